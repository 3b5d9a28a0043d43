#include "artefacts/simulation/simulate.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefacts/simulation/posture.h"
#include "core/statistics.h"
#include "tests/support/plans.h"
#include "tests/support/virtual_tip.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

Simulation made(const SimulationPlan& plan, int threads = 2) {
  auto simulation = simulate(plan, threads);
  if (!simulation) throw std::runtime_error(simulation.error().text());
  return std::move(*simulation);
}

Eigen::Vector3d tip(const Simulation& simulation, int reading) {
  return testing::tip_of(simulation.arm, simulation.recording.joints.col(reading),
                         simulation.recording.readings[reading].probe);
}

/// Where a feature of the first placement is, by the truth that the simulation tells.
Eigen::Vector3d centre(const Simulation& simulation, const std::string& feature, double expansion_factor = 1.0) {
  const Eigen::Vector3d at = simulation.artefacts[0].features[feature[0] - 'A'].at;
  return simulation.placements[0].base_from_artefact * Eigen::Vector3d(expansion_factor * at);
}

std::string feature_of(const Simulation& simulation, int reading) {
  return simulation.recording.features.name(simulation.recording.readings[reading].feature);
}

class SimulateBars : public ::testing::TestWithParam<bool> {};

TEST_P(SimulateBars, TipsTouchTheBalls) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Sphere));
  if (GetParam()) testing::spoil(plan.arm);
  const Simulation simulation = made(plan);
  ASSERT_EQ(simulation.recording.readings.size(), 75u);
  for (int i = 0; i < 75; ++i) {
    EXPECT_NEAR((tip(simulation, i) - centre(simulation, feature_of(simulation, i))).norm(), 15.7, 1e-9) << i;
  }
}

TEST_P(SimulateBars, TipsSitInTheSeats) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Point));
  if (GetParam()) testing::spoil(plan.arm);
  const Simulation simulation = made(plan);
  for (int i = 0; i < 75; ++i) {
    EXPECT_LT((tip(simulation, i) - centre(simulation, feature_of(simulation, i))).norm(), 1e-9) << i;
  }
}

TEST_P(SimulateBars, LengthsAreThoseToTheAnchors) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Anchor));
  plan.probings[0].lengths = {400.0, 900.0};
  if (GetParam()) testing::spoil(plan.arm);
  const Simulation simulation = made(plan);
  for (int i = 0; i < 75; ++i) {
    const double length = simulation.recording.readings[i].length;
    EXPECT_NEAR((tip(simulation, i) - centre(simulation, feature_of(simulation, i))).norm(), length, 1e-9) << i;
    EXPECT_THAT(length, AllOf(::testing::Ge(400.0), ::testing::Le(900.0)));
  }
}

INSTANTIATE_TEST_SUITE_P(RigidAndSpoilt, SimulateBars, ::testing::Bool());

TEST(Simulate, DistancesAreThoseOfTheCertificate) {
  const Simulation simulation = made(testing::plan_for(testing::bar_of(FeatureKind::Point)));
  EXPECT_NEAR((centre(simulation, "A") - centre(simulation, "B")).norm(), 250.0, 1e-9);
  EXPECT_NEAR((centre(simulation, "B") - centre(simulation, "C")).norm(), 350.0, 1e-9);
}

TEST(Simulate, ArtefactsGrowWithTheirTemperature) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Sphere));
  plan.placements[0].temperature = 22.0;
  plan.placements[0].temperature_end = 26.0;
  const Simulation simulation = made(plan);
  for (int i = 0; i < 75; ++i) {
    const double temperature = simulation.recording.readings[i].temperature;
    EXPECT_NEAR(temperature, 22.0 + 4.0 * i / 74.0, 1e-12);
    const double expansion_factor = 1.0 + 11.5e-6 * (temperature - 20.0);
    EXPECT_NEAR((tip(simulation, i) - centre(simulation, feature_of(simulation, i), expansion_factor)).norm(),
                expansion_factor * 12.7 + 3.0, 1e-9);
  }
}

// Gains, couplings and warm links of the true arm's own file, against its equations written with matrices.
TEST(Simulate, TipsOfAnArmWithJointErrorsTouchTheBalls) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Sphere));
  plan.placements[0].arm_temperature = 24.0;
  plan.placements[0].arm_temperature_end = 30.0;
  for (std::size_t i = 1; i < plan.arm.arm.joints.size(); ++i) {
    plan.arm.arm.joints[i].errors = {{1e-4, 0.0}, {0.0, -5e-5}, 2e-4, -1e-4, 0.0, 1.2e-5};
  }
  const Simulation simulation = made(plan);
  const testing::ArmNumbers<double> numbers(simulation.arm.arm);
  for (int i = 0; i < 75; ++i) {
    const double temperature = simulation.recording.readings[i].arm_temperature;
    EXPECT_NEAR(temperature, 24.0 + 6.0 * i / 74.0, 1e-12);
    const auto q = simulation.recording.joints.col(i);
    const Eigen::Vector3d there = testing::tip_with_errors(numbers, std::vector<double>(q.begin(), q.end()), 0,
                                                           temperature - simulation.arm.arm.reference_temperature);
    EXPECT_NEAR((there - centre(simulation, feature_of(simulation, i))).norm(), 12.7 + 3.0, 1e-9);
  }
}

TEST(Simulate, TipsTouchThePlane) {
  PlannedArtefact plate;
  plate.certified.name = "plate";
  plate.certified.features = {testing::certified("A", FeatureKind::Plane)};
  plate.stated.resize(1);
  plate.stated[0].normal = Eigen::Vector3d(0.2, -0.1, 1.0).normalized();
  SimulationPlan plan = testing::plan_for(plate, 60);
  plan.probings[0].extent = {300.0, 100.0};
  const Simulation simulation = made(plan);
  const Rigid& pose = simulation.placements[0].base_from_artefact;
  const Eigen::Vector3d normal = pose.rotation * *plate.stated[0].normal;
  double furthest = 0.0;
  for (int i = 0; i < 60; ++i) {
    const Eigen::Vector3d off = tip(simulation, i) - pose.translation;
    EXPECT_NEAR(normal.dot(off), 3.0, 1e-9);
    furthest = std::max(furthest, (off - normal.dot(off) * normal).norm());
  }
  EXPECT_LE(furthest, std::hypot(150.0, 50.0));
  EXPECT_GT(furthest, 110.0);  // 60 points do not all keep to the inner two thirds
}

TEST(Simulate, CoordinatesStandInTheInstrumentsFrame) {
  PlannedArtefact tracker;
  tracker.certified.name = "tracker";
  tracker.certified.features = {testing::certified("A", FeatureKind::Coordinates)};
  tracker.stated.resize(1);
  SimulationPlan plan = testing::plan_for(tracker, 40);
  testing::spoil(plan.arm);
  const Simulation simulation = made(plan);
  for (int i = 0; i < 40; ++i) {
    const Eigen::Vector3d in_base =
        simulation.placements[0].base_from_artefact * simulation.recording.readings[i].reference;
    EXPECT_LT((in_base - tip(simulation, i)).norm(), 1e-9);
  }
}

// Seen from the base, with up along its z axis: which side of the upright plane through the tip the joint
// between upper and lower arm is on (frame 3's origin of this arm).
double elbow_to_the_left(const Simulation& simulation, int reading) {
  const Eigen::VectorXd q = simulation.recording.joints.col(reading);
  const testing::ArmNumbers<double> numbers(simulation.arm.arm);
  const Eigen::Vector3d elbow =
      testing::base_from_last(numbers, std::vector<double>(q.begin(), q.begin() + 3)).topRightCorner<3, 1>();
  return Eigen::Vector3d::UnitZ().cross(tip(simulation, reading)).normalized().dot(elbow);
}

TEST(Simulate, ASeatIsReachedWithTheElbowOnBothSidesAndTheWristSwivelled) {
  const Simulation simulation = made(testing::plan_for(testing::bar_of(FeatureKind::Point), 40));
  int left = 0;
  Eigen::Matrix3Xd styli(3, 40);
  for (int i = 0; i < 40; ++i) {
    left += elbow_to_the_left(simulation, i) > 0.0 ? 1 : 0;
    const Eigen::VectorXd q = simulation.recording.joints.col(i);
    styli.col(i) = testing::base_from_last(testing::ArmNumbers<double>(simulation.arm.arm),
                                           std::vector<double>(q.begin(), q.end()))
                       .block<3, 1>(0, 2);
  }
  EXPECT_GE(left, 15);
  EXPECT_LE(left, 25);
  EXPECT_LT((styli.transpose() * styli).minCoeff(), -0.5);  // two styli more than 120 degrees apart
}

TEST(Simulate, OrientationsKeepTheirPosture) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Sphere), 5);
  plan.probings[0].features = {0};
  plan.probings[0].orientations = 5;
  const Simulation simulation = made(plan);
  const Recording& recording = simulation.recording;
  ASSERT_EQ(recording.readings.size(), 25u);
  EXPECT_EQ(recording.orientations.size(), 5);
  for (int i = 0; i < 25; ++i) {
    const double within = (recording.joints.col(i) - recording.joints.col(i - i % 5)).cwiseAbs().maxCoeff();
    EXPECT_LT(within, 10.0 * units::degree) << i;
    EXPECT_EQ(recording.orientations.name(recording.readings[i].orientation), std::to_string(i / 5 + 1));
  }
  for (int i = 5; i < 25; i += 5) {
    EXPECT_GT((recording.joints.col(i) - recording.joints.col(i - 5)).cwiseAbs().maxCoeff(), 20.0 * units::degree);
  }
}

// The sum of squares of n standard normal deviates, against its distribution.
void expect_chi_squared(double sum, double n) {
  EXPECT_GT(sum, chi_squared_quantile(1e-4, n));
  EXPECT_LT(sum, chi_squared_quantile(1.0 - 1e-4, n));
}

TEST(Simulate, EncodersHaveTheirNoiseEachItsOwn) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Point), 300);
  const Simulation quiet = made(plan);
  for (int j = 0; j < 6; ++j) plan.arm.joints[j].encoder_noise = (1.0 + j) * units::arcsecond;
  const Simulation noisy = made(plan);
  for (int j = 0; j < 6; ++j) {
    const Eigen::VectorXd off =
        (noisy.recording.joints.row(j) - quiet.recording.joints.row(j)) / plan.arm.joints[j].encoder_noise;
    expect_chi_squared(off.squaredNorm(), 900.0);
    EXPECT_LT(std::abs(off.mean()), 4.0 / std::sqrt(900.0));
  }
  EXPECT_FALSE(noisy.recording.noise.is_given());  // no single number says it
}

TEST(Simulate, ProbingHasItsNoiseInEveryCoordinate) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Point), 300);
  plan.noise.probing = 0.004;
  const Simulation simulation = made(plan);
  Eigen::Vector3d sums = Eigen::Vector3d::Zero();
  for (int i = 0; i < 900; ++i) {
    const Eigen::Vector3d off = tip(simulation, i) - centre(simulation, feature_of(simulation, i));
    sums += (off / 0.004).cwiseAbs2();
  }
  for (const double sum : sums) expect_chi_squared(sum, 900.0);
}

TEST(Simulate, InstrumentsHaveTheirNoise) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Anchor), 300);
  plan.artefacts[0].certified.features[1].u = 0.002;
  const Simulation simulation = made(plan);
  double sum = 0.0;
  for (int i = 0; i < 900; ++i) {
    const std::string feature = feature_of(simulation, i);
    const double off =
        simulation.recording.readings[i].length - (tip(simulation, i) - centre(simulation, feature)).norm();
    if (feature == "B") {
      sum += off * off / (0.002 * 0.002);
    } else {
      EXPECT_LT(std::abs(off), 1e-9);
    }
  }
  expect_chi_squared(sum, 300.0);
}

// What the plan says of the instrument counts, not what the artefact says of its reference.
TEST(Simulate, AStatedInstrumentIsTheOneThatMeasures) {
  for (const double stated : {0.0, 0.01}) {
    SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Anchor), 300);
    plan.artefacts[0].certified.features[1].u = 0.002;
    plan.noise.instrument = stated;
    const Simulation simulation = made(plan);
    double squares = 0.0;
    for (int i = 0; i < 900; ++i) {
      const double off = simulation.recording.readings[i].length -
                         (tip(simulation, i) - centre(simulation, feature_of(simulation, i))).norm();
      squares += off * off;
    }
    if (stated > 0.0) {
      expect_chi_squared(squares / (stated * stated), 900.0);
    } else {
      EXPECT_LT(std::sqrt(squares), 1e-7);
    }
  }
}

TEST(Simulate, StatesTheNoiseARecordingCanState) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Sphere), 3);
  plan.noise.probing = 0.003;
  EXPECT_FALSE(made(plan).recording.noise.is_given());
  for (VirtualJoint& joint : plan.arm.joints) joint.encoder_noise = 1e-5;
  const Noise noise = made(plan).recording.noise;
  EXPECT_EQ(noise.encoder, 1e-5);
  EXPECT_EQ(noise.probing, 0.003);
}

TEST(Simulate, EndStopsAreKept) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Sphere), 40);
  for (std::size_t j = 0; j < 6; ++j) {
    plan.arm.joints[j].low = -120.0 * units::degree;
    plan.arm.joints[j].high = 130.0 * units::degree;
    plan.arm.joints[j].encoder_noise = 3.0 * units::degree;  // many readings are this near to a stop
  }
  plan.arm.joints[5].low = 170.0 * units::degree;  // beyond half a turn
  plan.arm.joints[5].high = 400.0 * units::degree;
  const Simulation simulation = made(plan);
  for (int j = 0; j < 6; ++j) {
    EXPECT_GE(simulation.recording.joints.row(j).minCoeff(), plan.arm.joints[j].low);
    EXPECT_LE(simulation.recording.joints.row(j).maxCoeff(), plan.arm.joints[j].high);
  }
  EXPECT_GT(simulation.recording.joints.row(5).maxCoeff(), 190.0 * units::degree);
}

TEST(Simulate, DrawnPlacementsAreInsideTheReachAndUprightWhereAsked) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Sphere), 10);
  plan.placements[0].base_from_artefact.reset();
  plan.placements[0].upright = true;
  plan.placements.push_back(plan.placements[0]);
  plan.placements[1].name = "right";
  plan.placements[1].upright = false;
  plan.probings[0].placements = {0, 1};
  const Simulation simulation = made(plan);
  ASSERT_EQ(simulation.recording.readings.size(), 60u);
  for (int i = 0; i < 60; ++i) {
    const RealPlacement& placement = simulation.placements[simulation.recording.readings[i].placement];
    const Eigen::Vector3d at = simulation.artefacts[0].features[feature_of(simulation, i)[0] - 'A'].at;
    EXPECT_NEAR((tip(simulation, i) - placement.base_from_artefact * at).norm(), 15.7, 1e-9);
  }
  EXPECT_LT((simulation.placements[0].base_from_artefact.rotation.col(2) - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_GT((simulation.placements[1].base_from_artefact.rotation.col(2) - Eigen::Vector3d::UnitZ()).norm(), 0.01);
}

// A wide plane: where its first point can be touched, others often cannot.
TEST(Simulate, ADrawnPlacementIsOneWhereEveryReadingCouldBeTaken) {
  PlannedArtefact table;
  table.certified.name = "table";
  table.certified.features = {testing::certified("A", FeatureKind::Plane)};
  table.stated.resize(1);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SimulationPlan plan = testing::plan_for(table, 8);
    plan.seed = seed;
    plan.placements[0].base_from_artefact.reset();
    plan.probings[0].extent = {1500.0, 1500.0};
    const Simulation simulation = made(plan);
    const Rigid& pose = simulation.placements[0].base_from_artefact;
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector3d off = tip(simulation, i) - pose.translation;
      EXPECT_NEAR(pose.rotation.col(2).dot(off), 3.0, 1e-9) << "seed " << seed << ", reading " << i;
      EXPECT_LT(off.norm(), 750.0 * std::sqrt(2.0) + 3.0);
    }
  }
}

bool same_bits(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

TEST(Simulate, TheSeedAloneDecidesNotTheThreads) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Sphere), 15);
  testing::spoil(plan.arm);
  plan.placements[0].base_from_artefact.reset();
  plan.noise.probing = 0.003;
  plan.errors.length = 0.2;
  const Eigen::MatrixXd one = made(plan, 1).recording.joints;
  EXPECT_TRUE(same_bits(one, made(plan, 1).recording.joints));
  EXPECT_TRUE(same_bits(one, made(plan, 7).recording.joints));
  plan.seed = 2;
  EXPECT_FALSE(same_bits(one, made(plan, 1).recording.joints));
}

TEST(Simulate, ArmErrorsHaveTheirSize) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Point), 1);
  plan.probings[0].features = {0};
  plan.errors = {0.2, 1e-3, 5e-5, 2e-5, {"a6", "theta1"}};
  Eigen::Vector4d sums = Eigen::Vector4d::Zero();
  constexpr int trials = 200;
  for (plan.seed = 1; plan.seed <= trials; ++plan.seed) {
    const VirtualArm arm = made(plan).arm;
    sums[0] += std::pow((arm.arm.joints[2].d - plan.nominal.joints[2].d) / 0.2, 2);
    sums[1] += std::pow((arm.arm.joints[3].alpha - plan.nominal.joints[3].alpha) / 1e-3, 2);
    sums[2] += std::pow(arm.joints[1].eccentricity[0].amplitude / 5e-5, 2);
    sums[3] += std::pow(arm.joints[4].eccentricity[1].amplitude / 2e-5, 2);
    EXPECT_EQ(arm.arm.joints[5].a, 0.0);
    EXPECT_EQ(arm.arm.joints[0].theta, 0.0);
  }
  expect_chi_squared(sums[0], trials);
  expect_chi_squared(sums[1], trials);
  expect_chi_squared(sums[2], 2 * trials);  // two parts, in quadrature
  expect_chi_squared(sums[3], 2 * trials);
}

TEST(Simulate, JointErrorsAndRadiiHaveTheirSize) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Point), 1);
  plan.probings[0].features = {0};
  for (Joint& joint : plan.arm.arm.joints) joint.mass = 1.0;
  plan.arm.arm.joints[1].errors.expansion = 11e-6;  // what the file states is drawn around
  plan.errors.length = 0.2;
  const double chain = made(plan).arm.arm.joints[2].d;
  plan.errors.exact = {"gain1"};
  plan.errors.radius = 0.002;
  plan.errors.gain = 5e-5;
  plan.errors.coupling = 2e-5;
  plan.errors.compliance = 1e-8;
  plan.errors.expansion = 1e-6;
  EXPECT_EQ(made(plan).arm.arm.joints[2].d, chain);  // no choice changes another's
  Eigen::Vector<double, 5> sums = Eigen::Vector<double, 5>::Zero();
  double gains_by_couplings = 0.0;
  constexpr int trials = 200;
  for (plan.seed = 1; plan.seed <= trials; ++plan.seed) {
    const VirtualArm arm = made(plan).arm;
    const auto& joints = arm.arm.joints;
    sums[0] += std::pow((arm.arm.probes[0].radius - 3.0) / 0.002, 2);
    sums[1] += std::pow(joints[2].errors.gain / 5e-5, 2);
    sums[2] += std::pow(joints[3].errors.coupling / 2e-5, 2);
    sums[3] += std::pow(joints[4].errors.compliance / 1e-8, 2);
    sums[4] += std::pow((joints[1].errors.expansion - 11e-6) / 1e-6, 2);
    gains_by_couplings += joints[2].errors.gain / 5e-5 * joints[2].errors.coupling / 2e-5 / trials;
    EXPECT_EQ(joints[0].errors.gain, 0.0);  // exact
    EXPECT_EQ(joints[0].errors.coupling, 0.0);
    for (const Joint& joint : joints) EXPECT_GE(joint.errors.compliance, 0.0);
  }
  for (const double sum : sums) expect_chi_squared(sum, trials);
  EXPECT_LT(std::abs(gains_by_couplings), 4.0 / std::sqrt(trials));
}

TEST(Simulate, DrawnJointErrorsAreTheSameBitsEveryTime) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Sphere), 10);
  for (Joint& joint : plan.arm.arm.joints) joint.mass = 1.0;
  plan.errors = {0.2, 1e-3, 0.0, 0.0, {}, 0.002, 1e-4, 5e-5, 2e-8, 1e-6};
  const Simulation once = made(plan, 1);
  EXPECT_TRUE(same_bits(once.recording.joints, made(plan, 5).recording.joints));
  // And the tips touch the balls, by the equations written a second time.
  const testing::ArmNumbers<double> numbers(once.arm.arm);
  const Rigid pose = once.placements[0].base_from_artefact;
  for (std::size_t i = 0; i < once.recording.readings.size(); ++i) {
    const auto q = once.recording.joints.col(static_cast<Eigen::Index>(i));
    const Eigen::Vector3d tip = testing::tip_with_errors(numbers, std::vector<double>(q.begin(), q.end()), 0, 0.0);
    const std::string& name = once.recording.features.name(once.recording.readings[i].feature);
    const double along = name == "A" ? 0.0 : name == "B" ? 250.0 : 600.0;
    const Eigen::Vector3d centre = pose * Eigen::Vector3d(along, 0.0, 0.0);
    EXPECT_NEAR((tip - centre).norm(), 12.7 + once.arm.arm.probes[0].radius, 1e-8) << i;
  }
}

TEST(Simulate, SaysWhatIsOutOfReach) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Sphere));
  plan.placements[0].base_from_artefact->translation = {1500.0, 0.0, 0.0};
  plan.placements[0].base_from_artefact->rotation.setIdentity();
  plan.placements[0].where = "plan.toml:7:1";
  const auto refused = simulate(plan);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::BadInput);
  EXPECT_THAT(refused.error().text(), HasSubstr("plan.toml:7:1: the placement \"left\": the arm does not reach point 1 "
                                                "of the feature \"C\" of \"bar\" (at 2100.0, 0.0, 0.0 mm"));
  for (const int threads : {1, 5}) {
    EXPECT_EQ(simulate(plan, threads).error().text(), refused.error().text());
  }
}

// The first takes the arm some milliseconds to give up, the second far longer: whoever is done last has no say.
TEST(Simulate, NamesTheFirstReadingThatFailsNotTheLastToFail) {
  PlannedArtefact both;
  both.certified.name = "both";
  both.certified.features = {testing::certified("A", FeatureKind::Anchor),
                             testing::certified("B", FeatureKind::Sphere)};
  both.stated.resize(2);
  both.stated[0].at = Eigen::Vector3d(0.0, 0.0, 0.0);
  both.stated[1].at = Eigen::Vector3d(-900.0, 0.0, 0.0);
  SimulationPlan plan = testing::plan_for(both, 1);
  plan.placements[0].base_from_artefact = Rigid{Eigen::Matrix3d::Identity(), {0.0, 0.0, 300.0}};
  plan.probings[0].lengths = {0.0, 1e-9};
  plan.arm.joints[0].low = -0.1;  // never towards the ball
  plan.arm.joints[0].high = 0.1;
  plan.arm.joints[1].low = 0.1;
  plan.arm.joints[1].high = 0.2;
  for (int i = 0; i < 10; ++i) {
    EXPECT_THAT(simulate(plan, 4).error().text(), HasSubstr("does not reach point 1 of the feature \"A\""));
  }
}

TEST(Simulate, SaysWhatItCannotPlace) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Sphere), 2);
  for (CertifiedDistance& distance : plan.artefacts[0].certified.distances) distance.value *= 20.0;
  plan.placements[0].base_from_artefact.reset();
  const auto refused = simulate(plan);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), HasSubstr("no place was found in 300 draws"));
}

TEST(Simulate, StopsThatLeaveNoWayAreNoCrash) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Sphere), 2);
  for (VirtualJoint& joint : plan.arm.joints) {
    joint.low = 0.1;
    joint.high = 0.1 + 1e-9;
    joint.encoder_noise = 1e-3;
  }
  EXPECT_THAT(simulate(plan).error().text(), HasSubstr("does not reach point 1 of the feature \"A\""));
}

}  // namespace
}  // namespace artcal
