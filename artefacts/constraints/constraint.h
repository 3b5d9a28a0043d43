#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "acquisition/recording/recording.h"
#include "artefacts/artefact/artefact.h"
#include "artefacts/constraints/point_line.h"
#include "core/error.h"

namespace artcal {

/// Where the point c, or the plane through it, that a constraint refers to is known.
enum class Location {
  Unknown,  ///< nowhere: a point is three unknowns in its group, a plane one, besides the tilts of its normal
  Posed,    ///< in the artefact's frame, whose pose is six unknowns in its group
  Base,     ///< in the base frame: no unknowns
};

/// P = c, the tip's centre at that point: three residuals a reading.
struct Coincide {};

/// |P − c| = a length that the reading brings: one residual a reading, mm.
struct AtDistance {
  std::vector<double> distances{};  ///< of each reading, mm
};

/// |P − c| = radius of the ball + radius of the tip: one residual a reading, mm.
struct OnBall {
  std::optional<double> radius{};      ///< in this placement, mm; nothing where it is not certified
  std::optional<int> shared_radius{};  ///< into Constraints::shared: takes its place; nothing: it is certified exactly
};

/// A face of a gauge (see UnknownGroup).
struct GaugeFace {
  double facing = 1.0;  ///< along the axis of the gauge or, -1, against it
  double height = 0.0;  ///< along that axis, mm
};

/// n·(P − c) = radius of the tip, with the outward normal n: one residual a reading, mm.
struct OnPlane {
  std::optional<Eigen::Vector3d> normal{};  ///< unit, as certified; of a face of a gauge, its axis or the opposite
  std::optional<GaugeFace> face{};
};

/// What is asked of the tip's centre.
using ConstraintKind = std::variant<Coincide, AtDistance, OnBall, OnPlane>;

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
  ConstraintKind kind;
  std::optional<int> group{};          ///< of the unknowns; nothing where there are none (Location::Base)
  int offset = 0;                      ///< of the point's three unknowns or the plane's one in the group (Unknown)
  std::vector<int> readings;           ///< into Recording::readings
  std::vector<Eigen::Vector3d> known;  ///< c of each reading, mm (empty where unknown)
  double u = 0.0;                      ///< standard uncertainty of what each reading brings, mm
  double expansion = 1.0;              ///< length in this placement / length at the reference temperature
  std::optional<int> first_error{};  ///< of three in Constraints::shared, where the certified coordinates are unknowns

  [[nodiscard]] int size() const { return static_cast<int>(readings.size()); }
  template <typename Kind>
  [[nodiscard]] bool is() const {
    return std::holds_alternative<Kind>(kind);
  }
  /// Null where the constraint is of another kind.
  template <typename Kind>
  [[nodiscard]] const Kind* as() const {
    return std::get_if<Kind>(&kind);
  }
  template <typename Kind>
  [[nodiscard]] Kind* as() {
    return std::get_if<Kind>(&kind);
  }
  /// Whether the point c is a centre, at a distance from the tips.
  [[nodiscard]] bool has_centre() const { return is<OnBall>() || is<AtDistance>(); }
  [[nodiscard]] std::optional<int> shared_radius() const {
    const auto* ball = as<OnBall>();
    return ball == nullptr ? std::nullopt : ball->shared_radius;
  }
  /// Null where the constraint is none on a face of a gauge.
  [[nodiscard]] const GaugeFace* face() const {
    const auto* plane = as<OnPlane>();
    return plane != nullptr && plane->face ? &*plane->face : nullptr;
  }
  /// Residuals a reading.
  [[nodiscard]] int dimension() const { return is<Coincide>() ? 3 : 1; }
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
  std::vector<std::string> warnings;  ///< of the binding; those of the documents: document_warnings.h

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

/// The same without the placements for which `drop[i]` is set, i counting Constraints::features.
Constraints without_features(const Constraints& constraints, const std::vector<bool>& drop);

/// The same with PoseTurn::Scaled for poses that lie nearly on a line.
Constraints with_scaled_turns(Constraints constraints);

/// The same with every ball taken for a point: for an arm that misses the balls by more than their radius.
Constraints balls_as_points(Constraints constraints);

}  // namespace artcal
