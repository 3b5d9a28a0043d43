#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace artcal {

/// What a reading on a feature means.
enum class FeatureKind {
  Point,        ///< seat, socket or cone: the tip's centre is the same point in every reading
  Sphere,       ///< the tip touches a ball: its centre lies at ball radius + tip radius from the ball's
  Anchor,       ///< telescoping bar or draw wire: the distance from the tip to one point is measured
  Coordinates,  ///< another instrument measured where the tip was: each reading brings its coordinates
};

/// Where certified coordinates stand.
enum class CoordinateFrame {
  Artefact,  ///< in the artefact's own frame, whose pose is unknown in every placement
  Base,      ///< in the arm's base frame
};

/// A feature of an artefact as its certificate describes it. Lengths in mm at the reference temperature.
struct CertifiedFeature {
  std::string name;
  FeatureKind kind = FeatureKind::Point;
  std::optional<Eigen::Vector3d> at;  ///< certified coordinates; absent: the place is unknown
  double radius = 0.0;                ///< of a sphere
  double u = 0.0;                     ///< standard uncertainty of what each reading brings (length or coordinate), mm
};

/// A certified distance between two features' points or centres, mm at the reference temperature.
struct CertifiedDistance {
  int first = 0;  ///< into Artefact::features
  int second = 0;
  double value = 0.0;
  double u = 0.0;  ///< standard uncertainty, U/k
};

/// Calibrated truth: what a certificate says of one object.
struct Artefact {
  std::string name;
  CoordinateFrame frame = CoordinateFrame::Artefact;
  std::vector<CertifiedFeature> features;
  std::vector<CertifiedDistance> distances;
  double expansion = 0.0;  ///< 1/K
  bool expansion_is_known = false;
  double reference_temperature = 20.0;  ///< °C

  /// Index into features, or -1. An empty name means the only feature, where there is only one.
  [[nodiscard]] int feature_index(const std::string& feature_name) const;
  /// L(T)/L(reference) = 1 + α·(T − reference).
  [[nodiscard]] double expansion_factor(double temperature) const {
    return 1.0 + expansion * (temperature - reference_temperature);
  }
};

}  // namespace artcal
