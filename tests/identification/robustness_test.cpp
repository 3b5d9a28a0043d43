// Other arms, placements and noise, begun from errors between those of a good nominal arm and several mm and
// degrees: whether the truth is found, judged by lengths in the volume.
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/support/recordings.h"
#include "tests/support/simulated_session.h"

namespace artcal {
namespace {

using testing::feature_of;
using testing::Session;

/// What is read in a session.
struct Programme {
  bool bar = false, plate = false, seats = false, planes = false;
};

test::Bound session_of(const Programme& programme, const Arm& nominal, const Arm& truth, std::uint64_t seed) {
  Session session(nominal, truth, seed);
  std::vector<Artefact> artefacts;
  const auto add = [&](const std::string& name, FeatureKind kind, int count) -> Artefact& {
    Artefact& artefact = artefacts.emplace_back();
    artefact.name = name;
    for (int i = 0; i < count; ++i) {
      artefact.features.push_back(feature_of(std::to_string(i), kind));
      if (kind == FeatureKind::Sphere) artefact.features.back().radius = 12.7;
    }
    return artefact;
  };
  if (programme.bar) {
    Artefact& bar = add("bar", FeatureKind::Sphere, 3);
    bar.distances = {{0, 1, 300.0, 4e-4}, {0, 2, 750.0, 4e-4}, {1, 2, 450.0, 4e-4}};
    for (int p = 0; p < 6; ++p) {
      const Rigid pose = session.pose();
      for (int i = 0; i < 3; ++i) {
        const double place = i == 0 ? 0.0 : i == 1 ? 300.0 : 750.0;
        session.read_ball("bar", std::to_string(p), std::to_string(i), 15, pose * Eigen::Vector3d(place, 0, 0), 12.7,
                          pose.rotation.col(2));
      }
    }
  }
  if (programme.plate) {
    Artefact& plate = add("plate", FeatureKind::Sphere, 9);
    for (int i = 0; i < 9; ++i) plate.features[i].at = 150.0 * Eigen::Vector3d(i % 3, i / 3, 0.0);
    for (int p = 0; p < 5; ++p) {
      const Rigid pose = session.pose();
      for (int i = 0; i < 9; ++i) {
        session.read_ball("plate", std::to_string(p), std::to_string(i), 6, pose * *plate.features[i].at, 12.7,
                          pose.rotation.col(2));
      }
    }
  }
  if (programme.seats) {
    add("seats", FeatureKind::Point, 2).distances = {{0, 1, 500.0, 4e-4}};
    for (int p = 0; p < 6; ++p) {
      const Rigid pose = session.pose();
      for (int i = 0; i < 2; ++i) {
        const Eigen::Vector3d at = pose * Eigen::Vector3d(500.0 * i, 0, 0);
        session.read("seats", std::to_string(p), std::to_string(i), 12, [&](int) { return at; });
      }
    }
  }
  if (programme.planes) {
    const Artefact& planes = add("planes", FeatureKind::Plane, 3);
    for (const auto& feature : planes.features) {
      const Rigid pose = session.pose();
      session.read_plane("planes", "1", feature.name, 40, pose.translation, pose.rotation.col(2), 400.0);
    }
  }
  return test::bind(session.recording(), artefacts);
}

struct Difficulty {
  double mm, degrees;
};

class OtherArms : public ::testing::TestWithParam<std::tuple<int, Difficulty>> {};

TEST_P(OtherArms, AreFound) {
  constexpr Programme programmes[] = {{.bar = true},
                                      {.plate = true},
                                      {.seats = true},
                                      {.bar = true, .planes = true},
                                      {.bar = true, .plate = true, .seats = true, .planes = true}};
  const auto& [programme, difficulty] = GetParam();
  const char* wanted = std::getenv("ARTCAL_ROBUSTNESS_SEEDS");
  const int seeds = wanted != nullptr ? std::atoi(wanted) : 2;
  int found = 0;
  double worst = 0.0;
  for (int seed = 0; seed < seeds; ++seed) {
    Arm nominal = test::gao_arm();
    nominal.probes.front().radius = 3.0;
    RandomStream random(static_cast<std::uint64_t>(seed), "other arms", static_cast<std::uint64_t>(programme));
    const Arm truth =
        testing::arm_with_errors(nominal, random, difficulty.mm, difficulty.degrees * 0.017453292519943295);
    const test::Bound bound =
        session_of(programmes[programme], nominal, truth, static_cast<std::uint64_t>(100 * programme + seed));
    IdentifyOptions options;
    options.leave_out = false;
    const auto result = identify(bound.recording, bound.constraints, options);
    const double rms = result ? testing::length_rms(truth, result->arm) : 1e9;
    worst = std::max(worst, rms);
    found += rms < 0.05 ? 1 : 0;
    if (rms >= 0.05) {
      ADD_FAILURE() << "seed " << seed << ": " << (result ? std::to_string(rms) + " mm" : result.error().text());
    }
  }
  RecordProperty("found", std::to_string(found) + " of " + std::to_string(seeds));
  RecordProperty("worst_um", std::to_string(1000 * worst));
}

INSTANTIATE_TEST_SUITE_P(AGoodNominalArm, OtherArms,
                         ::testing::Combine(::testing::Range(0, 5), ::testing::Values(Difficulty{0.3, 0.1})));
INSTANTIATE_TEST_SUITE_P(ARoughOne, OtherArms,
                         ::testing::Combine(::testing::Values(1, 2), ::testing::Values(Difficulty{3.0, 1.5})));

}  // namespace
}  // namespace artcal
