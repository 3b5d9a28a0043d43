#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace artcal {

struct Pattern;
struct FoundPoint;

/// States which found point a point of the pattern is: the one at `near`. Resolves the ambiguity of a symmetric
/// artefact.
struct PlaceHint {
  int point = 0;  ///< of the pattern
  Eigen::Vector3d near = Eigen::Vector3d::Zero();
};

/// A hint that no found point answers. It is never moved to the next best point: that would name a whole artefact
/// wrongly where one sphere is missing.
struct UnmetHint {
  enum class Fault {
    NothingNear,  ///< no found point within `limit` of the place
    OtherRadius,  ///< the point there answers another radius
    SameAsOther,  ///< another hint states the same point
  };
  int hint = 0;  ///< into the hints
  Fault fault = Fault::NothingNear;
  int nearest = -1;       ///< into the found points, -1 where there are none
  double distance = 0.0;  ///< of it from the place, mm
  double limit = 0.0;     ///< mm
};

struct ResolvedHints {
  std::vector<int> found;  ///< for each point of the pattern an index into the found points, or -1: not stated
  std::vector<UnmetHint> unmet;
};

/// The found point of each hint: the nearest one, at most the sphere's radius and the pattern's tolerance away, and
/// never farther than half the smallest certified distance of that point, so that no neighbour is taken for it.
/// REQUIRES hints that name points of the pattern.
ResolvedHints resolve_hints(const Pattern& pattern, const std::vector<FoundPoint>& found,
                            const std::vector<PlaceHint>& hints);

/// How far a found point may be from where a hint states it, mm.
double place_limit(const Pattern& pattern, int point);

/// Why a hint is not met, in a clause such as "the nearest one, at 83 mm, is farther away than 12.1 mm". REQUIRES the
/// fault of an UnmetHint.
std::string fault_text(const UnmetHint& unmet);

}  // namespace artcal
