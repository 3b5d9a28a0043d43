#include "artefacts/virtual_probing/virtual_probing.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <Eigen/Dense>

#include "artefacts/virtual_probing/postures.h"
#include "core/random.h"
#include "core/rigid.h"

namespace artcal {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int max_misses = 200;  // in a row; then the arm cannot do what is asked
constexpr int starts = 50;       // of a posture; then a point counts as out of reach

CertifiedFeature feature_called(std::string name, FeatureKind kind) {
  CertifiedFeature feature;
  feature.name = std::move(name);
  feature.kind = kind;
  return feature;
}

/// Collects readings into a recording.
class Recorder {
 public:
  Recorder(const Arm& arm, std::string artefact) {
    recording_.name = "virtual";
    recording_.arm = arm;
    recording_.files.emplace_back("virtual");
    recording_.artefacts.index_of(artefact);
  }
  void add(const Eigen::VectorXd& q, const std::string& placement, const std::string& feature,
           const Eigen::Vector3d& reference, double length) {
    Reading reading{};
    reading.placement = recording_.placements.index_of(placement);
    reading.feature = recording_.features.index_of(feature);
    reading.orientation = recording_.orientations.index_of("");
    reading.repeat = recording_.repeats.index_of("");
    reading.temperature = nan;
    reading.length = length;
    reading.reference = reference;
    reading.line = static_cast<int>(recording_.readings.size()) + 1;
    recording_.readings.push_back(reading);
    joints_.insert(joints_.end(), q.begin(), q.end());
  }
  Recording finish() {
    const auto rows = static_cast<Eigen::Index>(recording_.arm.joints.size());
    recording_.joints =
        Eigen::MatrixXd::Map(joints_.data(), rows, static_cast<Eigen::Index>(recording_.readings.size()));
    return std::move(recording_);
  }

 private:
  Recording recording_;
  std::vector<double> joints_;
};

const Eigen::Vector3d no_reference = Eigen::Vector3d::Constant(nan);

VirtualRecording probe_coordinates(const Arm& arm, const VirtualProbing& options, RandomStream& random) {
  const bool in_base = options.kind == ReadingKind::BaseCoordinates;
  Artefact artefact;
  artefact.name = "coordinates";
  artefact.frame = in_base ? CoordinateFrame::Base : CoordinateFrame::Artefact;
  artefact.features = {feature_called("tip", FeatureKind::Coordinates)};
  Recorder recorder(arm, artefact.name);
  const Rigid artefact_from_base = in_base ? Rigid{} : Rigid{random.rotation(), 0.3 * reach(arm) * random.direction()};
  for (int i = 0; i < options.readings; ++i) {
    const Eigen::VectorXd q = random_posture(arm, random);
    recorder.add(q, "1", "tip", artefact_from_base * tip_at(arm, 0, q), nan);
  }
  return {recorder.finish(), {artefact}};
}

VirtualRecording probe_distances(const Arm& arm, const VirtualProbing& options, RandomStream& random) {
  const double length = options.distance > 0.0 ? options.distance : 0.25 * reach(arm);
  Artefact artefact;
  artefact.name = "bar";
  artefact.features = {feature_called("1", FeatureKind::Point), feature_called("2", FeatureKind::Point)};
  artefact.distances = {{0, 1, length, 1e-3}};
  Recorder recorder(arm, artefact.name);
  int pairs = 0;
  int misses = 0;
  while (pairs < options.readings / 2 && misses < max_misses) {
    const Eigen::VectorXd first = random_posture(arm, random);
    if (const auto second =
            inverse_kinematics(arm, 0, tip_at(arm, 0, first) + length * random.direction(), random, starts)) {
      const std::string placement = fmt::format("{}", ++pairs);
      recorder.add(first, placement, "1", no_reference, nan);
      recorder.add(*second, placement, "2", no_reference, nan);
      misses = 0;
    } else {
      ++misses;
    }
  }
  return {recorder.finish(), {artefact}};
}

FeatureKind feature_kind_of(ReadingKind kind) {
  switch (kind) {
    case ReadingKind::Sphere:
    case ReadingKind::UnknownSphere: return FeatureKind::Sphere;
    case ReadingKind::Plane:
    case ReadingKind::LevelPlane: return FeatureKind::Plane;
    case ReadingKind::Length: return FeatureKind::Anchor;
    default: return FeatureKind::Point;
  }
}

// The first axis in the base frame.
Eigen::Vector3d first_axis(const Arm& arm) {
  const Joint& joint = arm.joints.front();
  return arm.convention == Convention::Standard
             ? Eigen::Vector3d::UnitZ()
             : Eigen::Vector3d(Eigen::AngleAxisd(joint.alpha, Eigen::Vector3d::UnitX()) *
                               Eigen::AngleAxisd(joint.beta, Eigen::Vector3d::UnitY()) * Eigen::Vector3d::UnitZ());
}

/// A feature somewhere in the volume, and where the tip may be on it.
struct Somewhere {
  FeatureKind kind;
  Eigen::Vector3d centre;
  Eigen::Vector3d normal;
  double ball;

  [[nodiscard]] Eigen::Vector3d target(const Arm& arm, RandomStream& random) const {
    switch (kind) {
      case FeatureKind::Sphere: return centre + ball * random.direction();
      case FeatureKind::Anchor: return tip_at(arm, 0, random_posture(arm, random));
      case FeatureKind::Plane: {
        const Eigen::Vector3d anywhere = tip_at(arm, 0, random_posture(arm, random));
        return anywhere - normal.dot(anywhere - centre) * normal;
      }
      default: return centre;
    }
  }
};

// Points, balls, planes and anchors: readings spread evenly over features at random places.
VirtualRecording probe_features(const Arm& arm, const VirtualProbing& options, RandomStream& random) {
  const FeatureKind kind = feature_kind_of(options.kind);
  Artefact artefact;
  artefact.name = "features";
  Recorder recorder(arm, artefact.name);
  int misses = 0;
  for (int f = 0; f < options.features && misses < max_misses; ++f) {
    const std::string name = fmt::format("{}", f + 1);
    artefact.features.push_back(feature_called(name, kind));
    if (options.kind == ReadingKind::Sphere) {
      artefact.features.back().radius = options.ball_radius;
    }
    Somewhere place{kind, tip_at(arm, 0, random_posture(arm, random)), first_axis(arm),
                    options.ball_radius + arm.probes.front().radius};
    if (options.kind == ReadingKind::Plane) {
      place.normal = random.direction();
    }
    const int count = options.readings / options.features + (f < options.readings % options.features ? 1 : 0);
    for (int i = 0; i < count && misses < max_misses;) {
      const Eigen::Vector3d target = place.target(arm, random);
      if (const auto q = inverse_kinematics(arm, 0, target, random, starts)) {
        recorder.add(*q, "1", name, no_reference, kind == FeatureKind::Anchor ? (target - place.centre).norm() : nan);
        ++i;
        misses = 0;
      } else {
        ++misses;
      }
    }
  }
  return {recorder.finish(), {artefact}};
}

// A plate of three by three points, somewhere else in each placement; the readings go round over its points.
VirtualRecording probe_plate(const Arm& arm, const VirtualProbing& options, RandomStream& random) {
  const double pitch = 0.5 * (options.distance > 0.0 ? options.distance : 0.25 * reach(arm));
  Artefact artefact;
  artefact.name = "plate";
  for (int i = 0; i < 9; ++i) {
    artefact.features.push_back(feature_called(fmt::format("{}", i + 1), FeatureKind::Point));
    artefact.features.back().at = pitch * Eigen::Vector3d(i % 3 - 1, i / 3 - 1, 0.0);
  }
  Recorder recorder(arm, artefact.name);
  int misses = 0;
  for (int p = 0; p < options.features; ++p) {
    const Rigid base_from_plate{random.rotation(), 0.6 * tip_at(arm, 0, random_posture(arm, random))};
    const int count = options.readings / options.features + (p < options.readings % options.features ? 1 : 0);
    for (int i = 0, point = 0; i < count && misses < max_misses; ++point) {
      const CertifiedFeature& feature = artefact.features[point % 9];
      if (const auto q = inverse_kinematics(arm, 0, base_from_plate * *feature.at, random, starts)) {
        recorder.add(*q, fmt::format("{}", p + 1), feature.name, no_reference, nan);
        ++i;
        misses = 0;
      } else {
        ++misses;
      }
    }
  }
  return {recorder.finish(), {artefact}};
}

}  // namespace

VirtualRecording probe_virtually(const Arm& arm, const VirtualProbing& options) {
  RandomStream random(options.seed, "virtual probing", static_cast<std::uint64_t>(options.kind));
  switch (options.kind) {
    case ReadingKind::BaseCoordinates:
    case ReadingKind::FrameCoordinates: return probe_coordinates(arm, options, random);
    case ReadingKind::Distance: return probe_distances(arm, options, random);
    case ReadingKind::Plate: return probe_plate(arm, options, random);
    default: return probe_features(arm, options, random);
  }
}

}  // namespace artcal
