#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace artcal {

/// What an artefact is; reports and verification ask for it. Its features and distances say all the rest.
enum class ArtefactType {
  Other,
  BallBar,
  SpherePlate,
  Plane,           ///< a granite plate, say
  Sphere,          ///< a single ball
  SeatPlate,       ///< seats, sockets, cones
  StepGauge,       ///< parallel faces along a line
  GaugeBlock,      ///< two parallel faces
  TelescopingBar,  ///< or a draw wire
};

/// What a reading on a feature means.
enum class FeatureKind {
  Point,        ///< seat, socket or cone: the tip's centre is the same point in every reading
  Sphere,       ///< the tip touches a ball: its centre lies at ball radius + tip radius from the ball's
  Plane,        ///< the tip touches a plane: its centre lies one tip radius above it
  Anchor,       ///< telescoping bar or draw wire: the distance from the tip to one point is measured
  Coordinates,  ///< another instrument measured where the tip was: each reading brings its coordinates
};

/// Where certified coordinates stand.
enum class CoordinateFrame {
  Artefact,  ///< in the artefact's own frame, whose pose is unknown in every placement
  Base,      ///< in the arm's base frame
};

/// A feature of an artefact as its certificate describes it. Lengths in mm at the reference temperature,
/// uncertainties are standard uncertainties, U/k.
struct CertifiedFeature {
  std::string name;
  FeatureKind kind = FeatureKind::Point;
  std::optional<Eigen::Vector3d> at;      ///< certified coordinates; absent: the place is unknown
  double u_at = 0.0;                      ///< of each coordinate of `at`, mm; 0: they count as exact
  std::optional<Eigen::Vector3d> normal;  ///< of a plane, unit, out of the material; absent: unknown
  std::optional<double> radius;           ///< of a sphere; absent: unknown, one for all placements
  double u_radius = 0.0;                  ///< mm; 0: not stated
  std::optional<double> form;             ///< form deviation of a sphere or plane, mm
  double u_form = 0.0;                    ///< mm; 0: not stated
  double u = 0.0;                         ///< of what each reading brings (length or coordinate), mm
};

/// A value as its certificate states it, before it was brought to the reference temperature.
struct StatedValue {
  double value = 0.0;        ///< mm
  double temperature = 0.0;  ///< at which it holds, °C
};

/// A certified distance between two features' points or centres, or between two parallel planes, mm at the
/// reference temperature.
struct CertifiedDistance {
  int first = 0;  ///< into Artefact::features
  int second = 0;
  double value = 0.0;
  double u = 0.0;                          ///< standard uncertainty, U/k
  std::optional<StatedValue> stated = {};  ///< absent: `value`, at the reference temperature
};

/// The paper behind the numbers. Texts as they stand there; empty where the file does not say.
struct Certificate {
  std::string number;
  std::string laboratory;
  std::string date;         ///< of the calibration, "2026-03-02"
  std::string valid_until;  ///< the last day, "2028-03-01"; empty: no end is stated
};

/// Calibrated truth: what a certificate says of one object.
struct Artefact {
  std::string name;
  ArtefactType type = ArtefactType::Other;
  CoordinateFrame frame = CoordinateFrame::Artefact;
  std::vector<CertifiedFeature> features;
  std::vector<CertifiedDistance> distances;
  double expansion = 0.0;  ///< 1/K
  bool expansion_is_known = false;
  double u_expansion = 0.0;             ///< standard uncertainty of it, 1/K; 0: not stated
  double reference_temperature = 20.0;  ///< °C
  Certificate certificate;
  std::string material;
  std::string supports;  ///< how it is to be held, for people
  std::string note;      ///< for people

  /// Index into features, or -1. An empty name means the only feature, where there is only one.
  [[nodiscard]] int feature_index(const std::string& feature_name) const;
  /// L(T)/L(reference) = 1 + α·(T − reference).
  [[nodiscard]] double expansion_factor(double temperature) const {
    return 1.0 + expansion * (temperature - reference_temperature);
  }
  /// What the certificate says of a distance.
  [[nodiscard]] StatedValue stated(const CertifiedDistance& distance) const {
    return distance.stated.value_or(StatedValue{distance.value, reference_temperature});
  }
};

}  // namespace artcal
