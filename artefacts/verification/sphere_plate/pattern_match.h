#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace artcal {

/// What is wrong with the names under which a pattern was measured, if something is.
struct PatternFinding {
  enum class Kind {
    OtherOrder,  ///< another assignment fits far better: `order`
    Mirrored,    ///< the mirror image fits far better, in space or in the pattern's plane
    TwoPoses,    ///< two sets of points fit a pose each, but no common one: `second` holds the smaller set
  };
  Kind kind = Kind::OtherOrder;
  std::vector<int> order;   ///< measured i is certified order[i]
  std::vector<int> second;  ///< measured points of the second pose
  double rms_as_named = 0.0;
  double rms_found = 0.0;
};

/// Looks for a better explanation of measured points than their names: another order, the mirror image, two
/// poses. `measured` and `certified` hold the same points by name; `others` are further certified points that
/// were not measured. Nothing where the names fit as well as anything does. A flat pattern that is its own mirror
/// image up to some µm (a square grid of balls) is told by these µm: an explanation counts where it leaves less
/// than half the rms (a tenth with fewer than nine points, where chance does more).
std::optional<PatternFinding> find_misnaming(const Eigen::Matrix3Xd& measured, const Eigen::Matrix3Xd& certified,
                                             const Eigen::Matrix3Xd& others);

}  // namespace artcal
