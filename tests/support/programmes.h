#pragma once

#include <array>
#include <string>
#include <vector>

#include "tests/support/recordings.h"
#include "tests/support/simulated_session.h"

namespace artcal::testing {

/// What is read in a session.
struct Programme {
  const char* name;
  bool bar = false, plate = false, seats = false, planes = false;
};

inline constexpr std::array programmes = {
    Programme{.name = "ball bar", .bar = true}, Programme{.name = "sphere plate", .plate = true},
    Programme{.name = "two seats", .seats = true},
    Programme{.name = "ball bar and planes", .bar = true, .planes = true},
    Programme{.name = "all of them", .bar = true, .plate = true, .seats = true, .planes = true}};

/// How far a nominal arm is from the truth: standard deviations of its lengths, mm, and angles, degrees.
struct Difficulty {
  double mm, degrees;
};

/// A true arm that differs from `nominal` by chance.
inline Arm another_arm(const Arm& nominal, Difficulty difficulty, std::size_t programme, std::uint64_t seed) {
  RandomStream random(seed, "other arms", programme);
  return arm_with_errors(nominal, random, difficulty.mm, difficulty.degrees * std::numbers::pi / 180.0);
}

/// What an arm with errors reads in that programme, in placements and with noise of its own.
inline test::Bound session_of(const Programme& programme, const Arm& nominal, const Arm& truth, std::uint64_t seed,
                              double ball_radius = 12.7) {
  Session session(nominal, truth, seed);
  std::vector<Artefact> artefacts;
  const auto add = [&](const std::string& name, FeatureKind kind, int count) -> Artefact& {
    Artefact& artefact = artefacts.emplace_back();
    artefact.name = name;
    for (int i = 0; i < count; ++i) {
      artefact.features.push_back(feature_of(std::to_string(i), kind));
      if (kind == FeatureKind::Sphere) artefact.features.back().radius = ball_radius;
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
        session.read_ball("bar", std::to_string(p), std::to_string(i), 15, pose * Eigen::Vector3d(place, 0, 0),
                          ball_radius, pose.rotation.col(2));
      }
    }
  }
  if (programme.plate) {
    Artefact& plate = add("plate", FeatureKind::Sphere, 9);
    for (int i = 0; i < 9; ++i) plate.features[i].at = 150.0 * Eigen::Vector3d(i % 3, i / 3, 0.0);
    for (int p = 0; p < 5; ++p) {
      const Rigid pose = session.pose();
      for (int i = 0; i < 9; ++i) {
        session.read_ball("plate", std::to_string(p), std::to_string(i), 6, pose * *plate.features[i].at, ball_radius,
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

}  // namespace artcal::testing
