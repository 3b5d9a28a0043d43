#include "artefacts/simulation/simulate.h"

#include <algorithm>
#include <atomic>
#include <numeric>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "acquisition/arm/forward_kinematics.h"
#include "artefacts/simulation/posture.h"
#include "artefacts/simulation/session.h"
#include "artefacts/simulation/simulated_scans.h"
#include "artefacts/simulation/true_arm.h"
#include "core/parallel.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr int max_draws = 300;           // of a placement
constexpr int max_held_draws = 100'000;  // of them, those that the stand does not hold among them: these cost nothing

/// The readings of a placement, or the first that cannot be taken.
struct Outcome {
  std::vector<Taken> taken;
  std::optional<int> failed;
};

Outcome take_all(const Scene& scene, const std::vector<Job>& jobs, int threads) {
  const int count = static_cast<int>(jobs.size());
  Outcome outcome;
  outcome.taken.resize(jobs.size());
  std::atomic<int> next{0};
  std::atomic<int> first_failed{count};
  const auto work = [&] {
    for (int i = next++; i < first_failed; i = next++) {
      if (auto taken = take_reading(scene, jobs[i], i, count)) {
        outcome.taken[i] = std::move(*taken);
        continue;
      }
      for (int known = first_failed; i < known && !first_failed.compare_exchange_weak(known, i);) {
      }
    }
  };
  on_threads(thread_count(threads, jobs.size()), work);
  if (first_failed < count) {
    outcome.failed = first_failed;
  }
  return outcome;
}

// Before all readings are taken in a drawn place: one on each feature.
bool reaches_features(const Scene& scene, const std::vector<Job>& jobs) {
  for (int i = 0; i < static_cast<int>(jobs.size()); ++i) {
    if (jobs[i].point == 0 && !take_reading(scene, jobs[i], i, static_cast<int>(jobs.size()))) {
      return false;
    }
  }
  return true;
}

Eigen::Vector3d middle_of(const RealArtefact& artefact) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const RealFeature& feature : artefact.features) {
    sum += feature.at;
  }
  return sum / static_cast<double>(artefact.features.size());
}

// The artefact's middle where the tip is in some posture, turned in some way.
Rigid drawn_pose(const Scene& scene, RandomStream& random) {
  const Eigen::VectorXd q = random_readings(scene.arm, random);
  std::vector<double> sines(2 * scene.arm.joints.size());
  const std::span<const double> angles(q.data(), static_cast<std::size_t>(q.size()));
  joint_sines(angles, sines);
  const Eigen::Vector3d middle_in_base = ForwardKinematics(scene.arm.arm, {}, 0).tip_in_base({sines, angles});
  Rigid pose;
  const double about_z = random.uniform(-std::numbers::pi, std::numbers::pi);
  pose.rotation = scene.plan.placements[scene.placement].upright
                      ? Eigen::AngleAxisd(about_z, Eigen::Vector3d::UnitZ()).toRotationMatrix()
                      : random.rotation();
  pose.translation = middle_in_base - pose.rotation * middle_of(scene.artefact);
  return pose;
}

std::string reason_not_held(const Scene& scene) {
  std::vector<StandingFeature> standing;
  const PlannedPlacement& placement = scene.plan.placements[scene.placement];
  const Artefact& certified = scene.plan.artefacts[placement.artefact].certified;
  for (std::size_t i = 0; i < scene.artefact.features.size(); ++i) {
    const RealFeature& feature = scene.artefact.features[i];
    if (certified.features[i].kind == FeatureKind::Coordinates) {
      continue;  // where the tip is, not a thing that stands there
    }
    const bool is_ball = certified.features[i].kind == FeatureKind::Sphere;
    standing.push_back(
        {certified.features[i].name, scene.base_from_artefact * feature.at, is_ball ? feature.radius : 0.0});
  }
  return not_held(scene.plan.stand, standing);
}

Expected<std::vector<Taken>> take_drawn(Scene& scene, const std::vector<Job>& jobs, int threads) {
  const PlannedPlacement& placement = scene.plan.placements[scene.placement];
  RandomStream random(scene.plan.seed, "placement", static_cast<std::uint64_t>(scene.placement));
  int held = 0;
  for (int draw = 0; draw < max_held_draws && held < max_draws; ++draw) {
    scene.base_from_artefact = drawn_pose(scene, random);
    if (!reason_not_held(scene).empty()) {
      continue;
    }
    ++held;
    if (!reaches_features(scene, jobs)) {
      continue;
    }
    Outcome outcome = take_all(scene, jobs, threads);
    if (!outcome.failed) {
      return std::move(outcome.taken);
    }
  }
  if (held == 0) {
    return bad_input(fmt::format("the placement {}: none of {} places drawn in the arm's reach keeps to the limits of "
                                 "the stand (heights, floor, tables); the last: {}",
                                 in_quotes(placement.name), max_held_draws, reason_not_held(scene)),
                     placement.where);
  }
  return bad_input(fmt::format("the placement {}: no place was found in {} draws where the arm reaches all {} points; "
                               "state a position, or ask for less",
                               in_quotes(placement.name), held, jobs.size()),
                   placement.where);
}

Expected<std::vector<Taken>> take_placed(const Scene& scene, const std::vector<Job>& jobs, int threads) {
  if (const std::string reason = reason_not_held(scene); !reason.empty()) {
    const PlannedPlacement& stated = scene.plan.placements[scene.placement];
    return bad_input(
        fmt::format("the placement {} is not one that the stand holds: {}; state another position, or other "
                    "limits of the stand",
                    in_quotes(stated.name), reason),
        stated.where);
  }
  Outcome outcome = take_all(scene, jobs, threads);
  if (!outcome.failed) {
    return std::move(outcome.taken);
  }
  const PlannedPlacement& placement = scene.plan.placements[scene.placement];
  const PlannedArtefact& artefact = scene.plan.artefacts[placement.artefact];
  const Job& job = jobs[*outcome.failed];
  const Eigen::Vector3d at = scene.base_from_artefact * scene.artefact.features[job.feature].at;
  return bad_input(
      fmt::format("the placement {}: the arm does not reach point {} of the feature {} of {} (at {:.1f}, {:.1f}, "
                  "{:.1f} mm in the base frame) with its joints between their stops",
                  in_quotes(placement.name), job.point + 1, in_quotes(artefact.certified.features[job.feature].name),
                  in_quotes(artefact.certified.name), at.x(), at.y(), at.z()),
      placement.where);
}

Noise stated_noise(const VirtualArm& arm, double probing) {
  const double encoder = arm.joints.front().encoder_noise;
  const bool alike = std::all_of(arm.joints.begin(), arm.joints.end(),
                                 [&](const VirtualJoint& joint) { return joint.encoder_noise == encoder; });
  return alike && encoder > 0.0 && probing > 0.0 ? Noise{{}, encoder, probing} : Noise{};
}

void add_to(Recording& recording, const SimulationPlan& plan, int placement, const Job& job, const Taken& taken) {
  const PlannedPlacement& planned = plan.placements[placement];
  const Artefact& artefact = plan.artefacts[planned.artefact].certified;
  const PlannedProbing& probing = plan.probings[job.probing];
  Reading reading;
  reading.artefact = recording.artefacts.index_of(plan.artefacts.size() > 1 ? artefact.name : "");
  reading.placement = recording.placements.index_of(planned.name);
  reading.feature = recording.features.index_of(artefact.features[job.feature].name);
  reading.orientation = recording.orientations.index_of(job.orientation > 0 ? fmt::format("{}", job.orientation) : "");
  reading.repeat = recording.repeats.index_of(probing.repeats > 1 ? fmt::format("{}", job.repeat + 1) : "");
  reading.probe = probing.probe;
  reading.temperature = taken.temperature;
  reading.arm_temperature = taken.arm_temperature;
  reading.length = taken.length;
  reading.reference = taken.reference;
  recording.joints.col(static_cast<Eigen::Index>(recording.readings.size())) = taken.joints;
  recording.readings.push_back(reading);
  recording.readings.back().line = static_cast<int>(recording.readings.size()) + 1;  // after the header
}

}  // namespace

double planned_readings(const SimulationPlan& plan) {
  return std::accumulate(
      plan.probings.begin(), plan.probings.end(), 0.0, [](double sum, const PlannedProbing& probing) {
        return sum + static_cast<double>(probing.features.size()) * static_cast<double>(probing.placements.size()) *
                         std::max(1, probing.orientations) * probing.repeats * probing.points;
      });
}

Expected<Simulation> simulate(const SimulationPlan& plan, int threads) {
  Simulation made;
  made.arm = drawn_arm(plan);
  for (std::size_t i = 0; i < plan.artefacts.size(); ++i) {
    RandomStream random(plan.seed, "artefact", i);
    auto real = real_artefact(plan.artefacts[i], plan.draw_artefacts ? &random : nullptr);
    if (!real) {
      return tl::unexpected(real.error());
    }
    made.artefacts.push_back(std::move(*real));
  }
  Recording& recording = made.recording;
  recording.name = plan.name;
  recording.arm = plan.nominal;
  recording.noise = stated_noise(made.arm, plan.noise.probing);
  recording.files = {"readings.csv"};
  recording.joints.resize(static_cast<Eigen::Index>(plan.nominal.joints.size()),
                          static_cast<Eigen::Index>(planned_readings(plan)));
  for (int p = 0; p < static_cast<int>(plan.placements.size()); ++p) {
    const PlannedPlacement& placement = plan.placements[p];
    const std::vector<Job> jobs = jobs_of(plan, p);
    Scene scene{plan, made.arm, made.artefacts[placement.artefact], p, placement.base_from_artefact.value_or(Rigid{})};
    const auto taken =
        placement.base_from_artefact ? take_placed(scene, jobs, threads) : take_drawn(scene, jobs, threads);
    if (!taken) {
      return tl::unexpected(taken.error());
    }
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      add_to(recording, plan, p, jobs[i], (*taken)[i]);
      if (plan.probings[static_cast<std::size_t>(jobs[i].probing)].scan) {
        add_to_scan(made, jobs[i].probing);
      }
    }
    const double reference = plan.artefacts[placement.artefact].certified.reference_temperature;
    made.placements.push_back(
        {placement.name, placement.artefact, scene.base_from_artefact, placement.temperature.value_or(reference),
         placement.temperature ? placement.temperature_end : reference, static_cast<int>(jobs.size())});
  }
  return made;
}

}  // namespace artcal
