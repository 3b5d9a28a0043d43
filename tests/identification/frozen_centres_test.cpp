// Readings of a ball are posed anew at every step of an identification. What would be lost by taking from the
// nominal arm where the tip touched the ball, and freezing that: on the sphere plate of
// tests/reference/aacmm-simulated, judged by lengths in the volume.
#include <gtest/gtest.h>

#include "acquisition/arm/arm_file.h"
#include "identification/initial/nuisance_estimation.h"
#include "identification/least_squares/residual.h"
#include "tests/support/recordings.h"
#include "tests/support/simulated_session.h"

namespace artcal {
namespace {

const std::string folder = std::string(ARTCAL_SOURCE_DIR) + "/tests/reference/aacmm-simulated/";

/// The plate, each reading a feature of its own: a point, or a plane that touches its ball, in the place and
/// direction where the nominal arm has the contact.
test::Bound frozen(const test::Bound& plate, FeatureKind kind) {
  const Arm& nominal = plate.recording.arm;
  const System system = make_system(plate.recording, plate.constraints, nominal, {});
  const auto unknowns = estimate_nuisance_parameters(system, nominal, plate.recording);
  const testing::ArmNumbers<double> numbers(nominal);
  Recording recording = plate.recording;
  Artefact artefact;
  artefact.name = plate.constraints.artefacts[0].name;
  for (const FeatureConstraint& feature : plate.constraints.features) {
    const Rigid plate_from_base = base_from_artefact(state_of(feature, *unknowns)).inverse();
    for (int k = 0; k < feature.size(); ++k) {
      const int reading = feature.readings[k];
      const Eigen::VectorXd q = recording.joints.col(reading);
      const Eigen::Vector3d tip = testing::tip_in_base(numbers, std::vector<double>(q.begin(), q.end()), 0);
      const Eigen::Vector3d outwards = (plate_from_base * tip - feature.known[k]).normalized();
      CertifiedFeature contact = testing::feature_of(std::to_string(reading), kind);
      const double tip_radius = kind == FeatureKind::Point ? nominal.probes[0].radius : 0.0;
      contact.at = feature.known[k] + (*feature.as<OnBall>()->radius + tip_radius) * outwards;
      contact.normal = outwards;
      recording.readings[reading].feature = recording.features.index_of(contact.name);
      artefact.features.push_back(contact);
    }
  }
  return test::bind(std::move(recording), {artefact});
}

TEST(FrozenContacts, LoseToReadingsPosedAnew) {
  const Arm truth = read_arm_file(folder + "truth-arm.toml")->arm;
  test::Bound plate = test::read_bound(folder + "sphere-plate/recording.toml");
  for (auto& feature : plate.constraints.artefacts[0].features) feature.u_at = 0.0;
  plate = test::bind(plate.recording, plate.constraints.artefacts);
  IdentifyOptions options;
  options.accept_misfit = true;  // the wrong way is to show how wrong it is
  options.noise.reading = 0.015;
  options.leave_out = false;
  const auto rms = [&](const test::Bound& bound) {
    return 1000.0 * testing::length_rms(truth, test::identified(bound, options).arm, 20000);
  };
  const double anew = rms(plate);
  const double as_points = rms(frozen(plate, FeatureKind::Point));
  RecordProperty("posed anew, centres from frozen contacts (um)",
                 std::to_string(anew) + ", " + std::to_string(as_points));
  EXPECT_LT(anew, 3.7);
  EXPECT_GT(as_points, 10.0 * anew);
}

// The kinder way: only the distance along the frozen direction counts.
TEST(FrozenContacts, LoseEvenWhereOnlyTheirDirectionsAreFrozen) {
  const Arm truth = read_arm_file(folder + "truth-arm.toml")->arm;
  test::Bound plate = test::read_bound(folder + "sphere-plate/recording.toml");
  for (auto& feature : plate.constraints.artefacts[0].features) feature.u_at = 0.0;
  plate = test::bind(plate.recording, plate.constraints.artefacts);
  IdentifyOptions options;
  options.accept_misfit = true;  // the wrong way is to show how wrong it is
  options.noise.reading = 0.015;
  options.leave_out = false;
  const double anew = testing::length_rms(truth, test::identified(plate, options).arm, 20000);
  const double tangent =
      testing::length_rms(truth, test::identified(frozen(plate, FeatureKind::Plane), options).arm, 20000);
  RecordProperty("posed anew, frozen directions (um)",
                 std::to_string(1000 * anew) + ", " + std::to_string(1000 * tangent));
  EXPECT_GT(tangent, 3.0 * anew);
}

}  // namespace
}  // namespace artcal
