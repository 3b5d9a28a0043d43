#pragma once

#include <numbers>

#include "core/random.h"
#include "tests/support/forward_kinematics.h"
#include "tests/support/recordings.h"

namespace artcal::test {

/// An arm whose parameters are off the nominal ones by some tenths of a millimetre and of a milliradian.
inline Arm off_nominal(Arm arm, RandomStream& random) {
  for (Joint& joint : arm.joints) {
    joint.a += 0.5 * random.normal();
    joint.d += 0.5 * random.normal();
    joint.theta += 1e-3 * random.normal();
    joint.alpha += 1e-3 * random.normal();
  }
  return arm;
}

/// Readings of coordinates in the base frame by another instrument, at random postures (prismatic joints between their
/// ends): planted by the test's own matrices, with a noise of each coordinate in mm.
inline Bound tracked(const Arm& truth, const Arm& nominal, int count, double noise, std::uint64_t seed = 1) {
  RandomStream random(seed, "tracked");
  Recording recording;
  recording.name = "tracked";
  recording.arm = nominal;
  recording.files = {"planted"};
  recording.artefacts.index_of("tracker");
  const auto joints = static_cast<Eigen::Index>(truth.joints.size());
  recording.joints.resize(joints, count);
  const testing::ArmNumbers<double> numbers(truth);
  for (int i = 0; i < count; ++i) {
    std::vector<double> q;
    for (const Joint& joint : truth.joints) {
      q.push_back(joint.is_prismatic() ? random.uniform(joint.lowest.value_or(-500.0), joint.highest.value_or(500.0))
                                       : random.uniform(-std::numbers::pi, std::numbers::pi));
    }
    recording.joints.col(i) = Eigen::VectorXd::Map(q.data(), joints);
    Reading reading{};
    reading.placement = recording.placements.index_of("1");
    reading.feature = recording.features.index_of("T");
    reading.orientation = recording.orientations.index_of("");
    reading.repeat = recording.repeats.index_of("");
    reading.temperature = Reading::not_read;
    reading.reference = testing::tip_with_errors(numbers, q, 0, 0.0);
    for (double& coordinate : reading.reference) coordinate += noise * random.normal();
    reading.line = i + 1;
    recording.readings.push_back(reading);
  }
  Artefact tracker;
  tracker.name = "tracker";
  tracker.frame = CoordinateFrame::Base;
  CertifiedFeature target;
  target.name = "T";
  target.kind = FeatureKind::Coordinates;
  tracker.features.push_back(target);
  return bind(std::move(recording), {tracker});
}

}  // namespace artcal::test
