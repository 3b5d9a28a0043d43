#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "acquisition/recording/recording.h"
#include "artefacts/artefact/artefact.h"
#include "artefacts/constraints/point_line.h"
#include "core/error.h"

namespace artcal {

struct ScanSelection;  // artefacts/scans/scan_readings.h

/// Where the point or plane that a constraint refers to is known.
enum class Location {
  Unknown,  ///< nowhere: a point is three unknowns in its group, a plane one, besides the tilts of its normal
  Posed,    ///< in the artefact's frame, whose pose is six unknowns in its group
  Base,     ///< in the base frame: no unknowns
};

/// What is asked of the tip's centre P with respect to that point c, or a plane through it with the outward
/// normal n. One residual a reading, mm, but for the first.
enum class ConstraintKind {
  Coincide,    ///< P = c: three residuals a reading
  AtDistance,  ///< |P − c| = a length that the reading brings
  OnBall,      ///< |P − c| = radius of the ball + radius of the tip
  OnPlane,     ///< n·(P − c) = radius of the tip
};

/// A number that belongs to the artefact itself, the same in all its placements, and is not known exactly:
/// a ball's radius, or the error of a certified coordinate. The certificate tells it with a standard
/// uncertainty u, which enters once however often the feature is read; or, for a radius, not at all.
struct ArtefactParameter {
  enum class Quantity { ErrorX, ErrorY, ErrorZ, Radius };
  int artefact = 0;  ///< into Constraints::artefacts
  int feature = 0;   ///< into Artefact::features
  Quantity quantity = Quantity::Radius;
  double certified = 0.0;  ///< mm at the reference temperature; of an error 0
  double u = 0.0;          ///< mm; 0 where the certificate is silent
};

/// What one feature in one placement demands of its readings. Carries indices of readings and certified
/// numbers, never coordinates frozen with some arm: the readings are posed anew at every step.
struct FeatureConstraint {
  int artefact = 0;   ///< into Constraints::artefacts
  int placement = 0;  ///< into Recording::placements
  int feature = 0;    ///< into Artefact::features
  Location location = Location::Unknown;
  ConstraintKind kind = ConstraintKind::Coincide;
  int group = -1;                      ///< of the unknowns, or -1 where there are none
  int offset = 0;                      ///< of the point's three unknowns or the plane's one in the group (Unknown)
  std::vector<int> readings;           ///< into Recording::readings
  std::vector<Eigen::Vector3d> known;  ///< c of each reading, mm (empty where unknown)
  std::vector<double> distances;       ///< the length of each reading, mm (AtDistance only)
  double u = 0.0;                      ///< standard uncertainty of what each reading brings, mm
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< of a plane, unit, as certified; zero where it is not
  double facing = 0.0;     ///< along the axis of a gauge (see UnknownGroup) or, -1, against it; 0: no face of a gauge
  double height = 0.0;     ///< of a face along that axis, mm
  double radius = 0.0;     ///< of the ball in this placement, mm; 0 where it is unknown
  double expansion = 1.0;  ///< length in this placement / length at the reference temperature
  int first_error = -1;    ///< of three in Constraints::shared, of the certified coordinates; or -1
  int shared_radius = -1;  ///< into Constraints::shared: takes the place of `radius`; or -1

  [[nodiscard]] int size() const { return static_cast<int>(readings.size()); }
  /// Residuals a reading.
  [[nodiscard]] int dimension() const { return kind == ConstraintKind::Coincide ? 3 : 1; }
};

/// The distance between two features' points or centres, or between two parallel planes, in one placement,
/// as certified.
struct DistanceConstraint {
  int first = 0;  ///< into Constraints::features
  int second = 0;
  double value = 0.0;          ///< mm at the temperature of the placement
  double u = 0.0;              ///< standard uncertainty, mm
  bool binds = true;           ///< no end is certified; otherwise their coordinates say it already
  StatedValue certified = {};  ///< what the certificate says
};

/// How a pose may turn about the line along which its points lie.
enum class PoseTurn {
  Free,    ///< as it may about any other axis: a turning of three unknowns
  Unseen,  ///< not at all: a turning of two unknowns, about the axes across the line
  Scaled,  ///< the same, and two unknowns u, v after the shift: the points are displaced across the line not by x, y
           ///< but by u·x − v·y, v·x + u·y. For a turn by φ these are cos φ, sin φ. The residual is linear in them, so
           ///< that they are found from any start.
};

/// Unknowns that hang together and with nothing else but the arm and what is shared: the points of one bar
/// in one placement, the pose of one plate, or one plane and those that are certified to be parallel to it.
///
/// Where all that was read of a certified artefact in a placement are parallel planes (a step gauge), readings do
/// not determine its pose, but only the direction of its axis (the first of the planes' normals) and its place along
/// it. Its planes then share one place (FeatureConstraint::offset), from which each has its certified height.
///
/// Where what was read of a certified artefact in a placement lies on a line (balls on a bar, or two balls), no reading
/// sees how the artefact is turned about that line: its pose has five unknowns. Where it lies nearly on a line, the
/// turn is one of the six unknowns, but readings see it only by the distances of the points from the line.
struct UnknownGroup {
  bool has_pose = false;            ///< the first unknowns are a pose: turning (rad), then shift (mm)
  bool has_axis = false;            ///< the first two unknowns are the tilts of the normal that its planes share
  int size = 0;                     ///< number of unknowns
  PoseTurn turn = PoseTurn::Free;   ///< of a pose
  std::optional<PointLine> line{};  ///< along which what is posed lies, or nearly lies
};

/// Everything a recording's artefacts demand of its readings.
struct Constraints {
  std::vector<Artefact> artefacts;
  std::vector<FeatureConstraint> features;  ///< by artefact, placement, feature in order of appearance
  std::vector<DistanceConstraint> distances;
  std::vector<UnknownGroup> groups;
  std::vector<ArtefactParameter> shared;
  std::vector<std::string> warnings;

  [[nodiscard]] int unknown_count() const;  ///< of groups, and shared
  /// Residuals of readings, distances not counted.
  [[nodiscard]] int reading_residual_count() const;
  [[nodiscard]] int binding_distance_count() const;
  /// Of what is shared and certified: one pseudo-observation each.
  [[nodiscard]] int certified_shared_count() const;
  [[nodiscard]] int residual_count() const {
    return reading_residual_count() + binding_distance_count() + certified_shared_count();
  }
};

/// Names for people and reports.
struct FeatureName {
  std::string artefact, placement, feature;
};
FeatureName name_of(const FeatureConstraint& constraint, const Constraints& constraints, const Recording& recording);

/// Binds a recording to its artefacts. Refused, with the reading's file and line: an artefact or feature
/// that nobody described, a reading on an anchor without a length, one on coordinates without them; and by
/// the artefact's name a plane of which only the place is certified, a distance between a plane and a point
/// or between planes that are not parallel.
Expected<Constraints> build_constraints(const Recording& recording, std::vector<Artefact> artefacts);

/// Reads the artefact files that a recording names, notes them as its inputs, makes readings of the recording's scans
/// (artefacts/scans/scan_readings.h), and binds them to it.
Expected<Constraints> read_constraints(Recording& recording);
/// The same with another choice of the scans' points.
Expected<Constraints> read_constraints(Recording& recording, const ScanSelection& selection);

/// The same without the placements for which `drop[i]` is set, i counting Constraints::features.
Constraints without_features(const Constraints& constraints, const std::vector<bool>& drop);

/// The same with PoseTurn::Scaled for poses that lie nearly on a line.
Constraints with_scaled_turns(Constraints constraints);

/// The same with every ball taken for a point: for an arm that misses the balls by more than their radius.
Constraints balls_as_points(Constraints constraints);

}  // namespace artcal
