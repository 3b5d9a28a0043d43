#include "artefacts/simulation/session.h"

#include <cmath>

#include <Eigen/Geometry>

#include "acquisition/arm/forward_kinematics.h"
#include "artefacts/simulation/pattern.h"
#include "artefacts/simulation/posture.h"
#include "core/random.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr int max_far_postures = 1000;  // until one is at a length that the instrument measures

/// What chance does to one reading. Drawn before all else, so that the posture does not change it.
struct Chance {
  RandomStream random;
  Eigen::Vector3d probing, instrument;
  double temperature;
  Eigen::VectorXd encoders;

  Chance(const Scene& scene, int index)
      : random(scene.plan.seed, "reading",
               (static_cast<std::uint64_t>(scene.placement) << 32) + static_cast<std::uint64_t>(index)),
        probing(triple(scene.plan.noise.probing)),
        instrument(triple(1.0)),
        temperature(scene.plan.noise.temperature * random.normal()),
        encoders(static_cast<Eigen::Index>(scene.arm.joints.size())) {
    for (Eigen::Index i = 0; i < encoders.size(); ++i) {
      encoders[i] = scene.arm.joints[i].encoder_noise * random.normal();
    }
  }

 private:
  Eigen::Vector3d triple(double size) {
    const double x = random.normal();
    const double y = random.normal();
    const double z = random.normal();
    return size * Eigen::Vector3d(x, y, z);
  }
};

double temperature_at(const Scene& scene, int index, int count) {
  const PlannedPlacement& placement = scene.plan.placements[scene.placement];
  if (!placement.temperature) {
    return scene.plan.artefacts[placement.artefact].certified.reference_temperature;
  }
  const double part = count > 1 ? static_cast<double>(index) / (count - 1) : 0.0;
  return *placement.temperature + part * (placement.temperature_end - *placement.temperature);
}

// Not a number where the plan states none: the arm is at its reference.
double arm_temperature_at(const Scene& scene, int index, int count) {
  const PlannedPlacement& placement = scene.plan.placements[scene.placement];
  const double part = count > 1 ? static_cast<double>(index) / (count - 1) : 0.0;
  return placement.arm_temperature
             ? *placement.arm_temperature + part * (placement.arm_temperature_end - *placement.arm_temperature)
             : Reading::not_read;
}

const Artefact& certified(const Scene& scene) {
  return scene.plan.artefacts[scene.plan.placements[scene.placement].artefact].certified;
}

/// One feature as it stands in the base frame during a reading, mm.
RealFeature in_base(const Scene& scene, int feature, double temperature) {
  const RealFeature& real = scene.artefact.features[feature];
  const double expansion_factor =
      1.0 + scene.artefact.expansion * (temperature - certified(scene).reference_temperature);
  return {scene.base_from_artefact * Eigen::Vector3d(expansion_factor * real.at),
          scene.base_from_artefact.rotation * real.normal, expansion_factor * real.radius};
}

// Where the tip's centre belongs on something that is touched.
Eigen::Vector3d contact(const Scene& scene, const Job& job, const RealFeature& there) {
  const double tip = scene.arm.arm.probes[scene.plan.probings[job.probing].probe].radius;
  switch (certified(scene).features[job.feature].kind) {
    case FeatureKind::Sphere: return there.at + (there.radius + tip) * job.direction;
    case FeatureKind::Plane: {
      const Eigen::Matrix3d across = rotation_to(there.normal);
      return there.at + across.leftCols<2>() * job.place + tip * there.normal;
    }
    default: return there.at;
  }
}

Elbow alternating(int number) { return number % 2 == 0 ? Elbow::Left : Elbow::Right; }

// The posture that all points of one orientation begin from, well off the stops if there is such a one.
std::optional<Eigen::VectorXd> orientation_posture(const Scene& scene, const Job& job, double temperature) {
  const SimulationPlan& plan = scene.plan;
  const PlannedProbing& probing = plan.probings[job.probing];
  const std::uint64_t key = ((static_cast<std::uint64_t>(scene.placement) * plan.probings.size() + job.probing) *
                                 certified(scene).features.size() +
                             job.feature) *
                                1024 +
                            job.orientation;
  RandomStream random(plan.seed, "orientation", key);
  Job middle = job;
  middle.direction = probing.pole_in_base;
  middle.place.setZero();
  PostureRequest request{probing.probe,
                         contact(scene, middle, in_base(scene, job.feature, temperature)),
                         alternating(job.orientation),
                         {},
                         5.0 * units::degree};
  if (auto q = find_posture(scene.arm, request, random)) {
    return q;
  }
  request.margin = 0.0;
  return find_posture(scene.arm, request, random);
}

std::optional<Taken> touch(const Scene& scene, const Job& job, int index, int count, Chance& chance) {
  const double temperature = temperature_at(scene, index, count);
  const RealFeature there = in_base(scene, job.feature, temperature);
  const PostureRequest request{scene.plan.probings[job.probing].probe,
                               contact(scene, job, there) + chance.probing,
                               alternating(job.point + job.repeat),
                               chance.encoders,
                               0.0,
                               arm_temperature_at(scene, index, count)};
  std::optional<Eigen::VectorXd> q;
  if (job.orientation > 0 || scene.plan.probings[static_cast<std::size_t>(job.probing)].scan) {
    // The reference temperature: the posture is to be the same for all of them.
    const auto start = orientation_posture(scene, job, certified(scene).reference_temperature);
    q = start ? find_posture_near(scene.arm, request, *start) : std::nullopt;
  } else {
    q = find_posture(scene.arm, request, chance.random);
  }
  if (!q) {
    return std::nullopt;
  }
  Taken taken;
  taken.joints = *q + chance.encoders;
  return taken;
}

bool keeps_to_stops(const VirtualArm& arm, const Eigen::VectorXd& q) {
  for (Eigen::Index i = 0; i < q.size(); ++i) {
    if (q[i] < arm.joints[i].low || q[i] > arm.joints[i].high) {
      return false;
    }
  }
  return true;
}

// The tip is anywhere; another instrument measures how far it is from the anchor, or where it is.
std::optional<Taken> measure_afar(const Scene& scene, const Job& job, int index, int count, Chance& chance) {
  const PlannedProbing& probing = scene.plan.probings[job.probing];
  const CertifiedFeature& feature = certified(scene).features[job.feature];
  const RealFeature there = in_base(scene, job.feature, temperature_at(scene, index, count));
  const double instrument = scene.plan.noise.instrument.value_or(feature.u);
  const ForwardKinematics kinematics(scene.arm.arm, {}, probing.probe);
  std::vector<double> sines(2 * scene.arm.joints.size());
  for (int attempt = 0; attempt < max_far_postures; ++attempt) {
    const Eigen::VectorXd rigid = random_readings(scene.arm, chance.random);
    Taken taken;
    taken.joints = readings_of(scene.arm, probing.probe, rigid) + chance.encoders;
    const std::span<const double> angles(rigid.data(), static_cast<std::size_t>(rigid.size()));
    joint_sines(angles, sines);
    const Eigen::Vector3d seen =
        kinematics.tip_in_base({sines, angles, arm_temperature_at(scene, index, count)}) - chance.probing;
    const double length = (seen - there.at).norm();
    if (!keeps_to_stops(scene.arm, taken.joints)) {
      continue;
    }
    if (feature.kind == FeatureKind::Coordinates) {
      taken.reference = scene.base_from_artefact.inverse() * seen + instrument * chance.instrument;
      return taken;
    }
    if (length >= probing.lengths[0] && length <= probing.lengths[1]) {
      taken.length = length + instrument * chance.instrument.x();
      return taken;
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<Job> jobs_of(const SimulationPlan& plan, int placement) {
  std::vector<Job> jobs;
  RandomStream random(plan.seed, "pattern", static_cast<std::uint64_t>(placement));
  for (int p = 0; p < static_cast<int>(plan.probings.size()); ++p) {
    const PlannedProbing& probing = plan.probings[p];
    if (std::find(probing.placements.begin(), probing.placements.end(), placement) == probing.placements.end()) {
      continue;
    }
    for (const int feature : probing.features) {
      const auto directions = directions_on_ball(probing, random);
      const auto places = places_on_plane(probing, random);
      for (int orientation = std::min(1, probing.orientations); orientation <= probing.orientations; ++orientation) {
        for (int repeat = 0; repeat < probing.repeats; ++repeat) {
          for (int point = 0; point < probing.points; ++point) {
            jobs.push_back({p, feature, point, orientation, repeat, directions[point], places[point]});
          }
        }
      }
    }
  }
  return jobs;
}

std::optional<Taken> take_reading(const Scene& scene, const Job& job, int index, int count) {
  Chance chance(scene, index);
  const FeatureKind kind = certified(scene).features[job.feature].kind;
  auto taken = kind == FeatureKind::Anchor || kind == FeatureKind::Coordinates
                   ? measure_afar(scene, job, index, count, chance)
                   : touch(scene, job, index, count, chance);
  if (taken && scene.plan.placements[scene.placement].temperature) {
    taken->temperature = temperature_at(scene, index, count) + chance.temperature;
  }
  if (taken) {
    // A stream of its own: stating it changes nothing else that is drawn.
    RandomStream random(scene.plan.seed, "arm temperature",
                        (static_cast<std::uint64_t>(scene.placement) << 32) + static_cast<std::uint64_t>(index));
    taken->arm_temperature = arm_temperature_at(scene, index, count) + scene.plan.noise.temperature * random.normal();
  }
  return taken;
}

}  // namespace artcal
