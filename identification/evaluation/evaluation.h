#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "artefacts/constraints/constraint.h"
#include "core/error.h"

namespace artcal {

/// How far the readings of one feature are from what it demands of them, mm: the distance of the tip from
/// the common point (point, coordinates), or the deviation from a ball's surface or a measured length.
struct FeatureDeviation {
  FeatureName name;
  int readings = 0;
  double rms = 0.0;
  double maximum = 0.0;
};

/// A certified distance as the arm measures it, mm: between two points or centres, each from its own readings, or
/// between two parallel planes along the normal that all readings of both have in common.
struct LengthDeviation {
  FeatureName first;
  std::string second;           ///< the other feature, same artefact and placement
  StatedValue certified;        ///< what the certificate says
  double at_temperature = 0.0;  ///< what that makes at the temperature of the placement
  double error = 0.0;           ///< measured − at_temperature
  double u = 0.0;               ///< standard uncertainty of the certified value, mm
  double gain = 0.0;            ///< standard deviation of the measured length per standard deviation of one reading
};

/// How well an arm explains readings. Each feature is fitted by itself from the arm's points, so that a
/// length is measured and not fitted.
struct Evaluation {
  std::vector<FeatureDeviation> features;    ///< as Constraints::features
  std::vector<FeatureDeviation> placements;  ///< the same over the features of one artefact in one placement
  std::vector<FeatureDeviation> artefacts;   ///< and over the placements of one artefact
  std::vector<LengthDeviation> lengths;      ///< as Constraints::distances
  FeatureDeviation overall;
  /// Of each reading, in order of the features.
  std::vector<double> deviations;        ///< signed for balls, planes and lengths
  std::vector<Eigen::Vector3d> tips;     ///< in the base frame, mm
  std::vector<Eigen::Vector3d> offsets;  ///< from where the tip should have been to where it was, base frame, mm
  /// Of each feature, in the base frame, mm: its point or centre by its own readings; of a plane, among them.
  std::vector<Eigen::Vector3d> points;
};

/// Whether the deviations of a feature's readings have a sign: from the surface of a ball, from a plane and of a length
/// they do, the distance from a point does not.
bool has_signed_deviation(const FeatureConstraint& feature);

Expected<Evaluation> evaluate(const Recording& recording, const Constraints& constraints, const Arm& arm);

/// The shape of an evaluation with NaN for every number that an arm has part in: of an arm that cannot be evaluated.
Evaluation not_evaluated(Evaluation like);

}  // namespace artcal
