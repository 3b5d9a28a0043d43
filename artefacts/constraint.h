#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "acquisition/recording.h"
#include "artefacts/artefact.h"
#include "core/error.h"

namespace artcal {

/// Where the point that a constraint refers to is known.
enum class Location {
  Unknown,  ///< nowhere: three unknowns in its group
  Posed,    ///< in the artefact's frame, whose pose is six unknowns in its group
  Base,     ///< in the base frame: no unknowns
};

/// What is asked of the tip's centre P with respect to that point c.
enum class Demand {
  Coincide,    ///< P = c: three residuals a reading, mm
  AtDistance,  ///< |P − c| = a length: one residual a reading, mm
};

/// What one feature in one placement demands of its readings. Carries indices of readings and certified
/// numbers, never coordinates frozen with some arm: the readings are posed anew at every step.
struct FeatureConstraint {
  int artefact = 0;   ///< into Constraints::artefacts
  int placement = 0;  ///< into Recording::placements
  int feature = 0;    ///< into Artefact::features
  Location location = Location::Unknown;
  Demand demand = Demand::Coincide;
  int group = -1;                      ///< of the unknowns, or -1 where there are none
  int offset = 0;                      ///< of the point's three unknowns in the group (Location::Unknown)
  std::vector<int> readings;           ///< into Recording::readings
  std::vector<Eigen::Vector3d> known;  ///< c of each reading, mm (empty where unknown)
  std::vector<double> distances;       ///< the length of each reading, mm (empty for Coincide)
  double u = 0.0;                      ///< standard uncertainty of each of these, mm

  [[nodiscard]] int size() const { return static_cast<int>(readings.size()); }
  /// Residuals a reading.
  [[nodiscard]] int dimension() const { return demand == Demand::Coincide ? 3 : 1; }
};

/// The distance between two features' points or centres in one placement, as certified.
struct DistanceConstraint {
  int first = 0;  ///< into Constraints::features
  int second = 0;
  double value = 0.0;  ///< mm at the temperature of the placement
  double u = 0.0;      ///< standard uncertainty, mm
  bool binds = true;   ///< both points are unknown; otherwise their coordinates say it already
};

/// Unknowns that hang together and with nothing else but the arm: the points of one bar in one
/// placement, or the pose of one plate and what is unknown on it.
struct UnknownGroup {
  bool has_pose = false;  ///< the first six unknowns are a pose: turning (rad), then shift (mm)
  int size = 0;           ///< number of unknowns
};

/// Everything a recording's artefacts demand of its readings.
struct Constraints {
  std::vector<Artefact> artefacts;
  std::vector<FeatureConstraint> features;  ///< by artefact, placement, feature in order of appearance
  std::vector<DistanceConstraint> distances;
  std::vector<UnknownGroup> groups;
  std::vector<std::string> warnings;

  [[nodiscard]] int unknown_count() const;
  /// Residuals of readings, distances not counted.
  [[nodiscard]] int reading_residual_count() const;
  [[nodiscard]] int binding_distance_count() const;
};

/// Names for people and reports.
struct FeatureName {
  std::string artefact, placement, feature;
};
FeatureName name_of(const FeatureConstraint& constraint, const Constraints& constraints, const Recording& recording);

/// Binds a recording to its artefacts. Refused, with the reading's file and line: an artefact or feature
/// that nobody described, a reading on an anchor without a length, one on coordinates without them.
Expected<Constraints> build_constraints(const Recording& recording, std::vector<Artefact> artefacts);

/// Reads the artefact files that a recording names, notes them as its inputs, and binds them to it.
Expected<Constraints> read_constraints(Recording& recording);

/// The same without the placements for which `drop[i]` is set, i counting Constraints::features.
Constraints without_features(const Constraints& constraints, const std::vector<bool>& drop);

}  // namespace artcal
