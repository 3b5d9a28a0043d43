// Identification as a whole: planted truths of every kind of reading come back, what cannot be determined is
// fixed and said, and contradictory requests are refused.
#include "identification/identify.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Cholesky>

#include "acquisition/arm/forward_kinematics.h"
#include "artefacts/virtual_probing/virtual_probing.h"
#include "core/normal_vector.h"
#include "core/random.h"
#include "identification/identifiability/selection.h"
#include "tests/support/recordings.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;

Arm slightly_wrong(Arm arm, std::uint64_t seed, double mm = 0.1, double rad = 1e-3) {
  RandomStream random(seed, "slightly wrong");
  for (auto& joint : arm.joints) {
    joint.a += mm * random.normal();
    joint.d += mm * random.normal();
    joint.theta += rad * random.normal();
    joint.alpha += rad * random.normal();
  }
  for (auto& probe : arm.probes) {
    probe.tip_in_last.z() += mm * random.normal();
  }
  return arm;
}

// Readings of a wrong arm, to be identified from the nominal one. a6, d6 are true at nominal, so that the
// held pair members hold the truth; likewise what only moves the base.
struct Planted {
  Arm truth;
  test::Bound bound;
};

Planted plant(const VirtualProbing& probing, std::uint64_t seed = 5, Arm nominal = test::gao_arm()) {
  Arm truth = slightly_wrong(nominal, seed);
  truth.joints.back().a = nominal.joints.back().a;
  truth.joints.back().d = nominal.joints.back().d;
  if (probing.kind != ReadingKind::BaseCoordinates) {
    truth.joints.front().d = nominal.joints.front().d;
    truth.joints.front().theta = nominal.joints.front().theta;
  }
  VirtualRecording made = probe_virtually(truth, probing);
  made.recording.arm = nominal;
  return {truth, test::bind(std::move(made.recording), std::move(made.artefacts))};
}

void expect_truth(const Identification& result, const Arm& truth, double mm, double rad) {
  for (const auto& parameter : result.parameters) {
    EXPECT_NEAR(parameter.identified, value(truth, parameter.parameter), parameter.parameter.is_angle() ? rad : mm)
        << parameter.parameter.name;
  }
}

class PlantedTruth : public ::testing::TestWithParam<ReadingKind> {};

TEST_P(PlantedTruth, ComesBack) {
  VirtualProbing probing;
  probing.kind = GetParam();
  const Planted planted = plant(probing);
  IdentifyOptions options;
  options.noise.reading = 0.01;
  const Identification result = test::identified(planted.bound, options);
  expect_truth(result, planted.truth, 1e-7, 1e-10);
  EXPECT_LT(result.after.overall.rms, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Kinds, PlantedTruth,
                         ::testing::Values(ReadingKind::BaseCoordinates, ReadingKind::FrameCoordinates,
                                           ReadingKind::Distance, ReadingKind::Sphere, ReadingKind::Length));

TEST(Identify, ComesBackFromFarAway) {
  VirtualProbing probing;
  probing.kind = ReadingKind::Sphere;
  const Arm nominal = test::gao_arm();
  Arm truth = slightly_wrong(nominal, 11, 2.0, 0.02);
  truth.joints.front().d = nominal.joints.front().d;
  truth.joints.front().theta = nominal.joints.front().theta;
  truth.joints.back().a = truth.joints.back().d = 0.0;
  VirtualRecording made = probe_virtually(truth, probing);
  made.recording.arm = nominal;
  IdentifyOptions options;
  options.noise.reading = 0.01;
  options.leave_out = false;
  const auto bound = test::bind(std::move(made.recording), std::move(made.artefacts));
  expect_truth(test::identified(bound, options), truth, 1e-6, 1e-9);
}

// Appends the readings of another recording of the same arm, on an artefact of another name.
void append(Recording& all, const Recording& more, const std::string& artefact) {
  const Eigen::Index before = all.joints.cols();
  all.joints.conservativeResize(Eigen::NoChange, before + more.joints.cols());
  all.joints.rightCols(more.joints.cols()) = more.joints;
  for (Reading reading : more.readings) {
    reading.artefact = all.artefacts.index_of(artefact);
    reading.placement = all.placements.index_of(more.placements.name(reading.placement));
    reading.feature = all.features.index_of(more.features.name(reading.feature));
    all.readings.push_back(reading);
  }
}

// Seats alone lose the scale, balls tell it poorly, two lengths to an anchor add to it: all in one recording.
TEST(Identify, SeveralArtefactsInOneRecordingAddUp) {
  const Arm nominal = test::gao_arm();
  Arm truth = slightly_wrong(nominal, 12);
  truth.joints.front().d = nominal.joints.front().d;
  truth.joints.front().theta = nominal.joints.front().theta;
  truth.joints.back().a = truth.joints.back().d = 0.0;
  Recording all;
  all.arm = nominal;
  all.files = {"virtual"};
  all.joints.resize(6, 0);
  std::vector<Artefact> artefacts;
  for (const auto& [kind, name] :
       {std::pair{ReadingKind::Point, "seats"}, {ReadingKind::Sphere, "balls"}, {ReadingKind::Length, "wire"}}) {
    VirtualProbing probing;
    probing.kind = kind;
    probing.readings = 60;
    VirtualRecording made = probe_virtually(truth, probing);
    append(all, made.recording, name);
    artefacts.push_back(made.artefacts.front());
    artefacts.back().name = name;
  }
  IdentifyOptions options;
  options.noise.reading = 0.01;
  const Identification result = test::identified(test::bind(std::move(all), std::move(artefacts)), options);
  EXPECT_EQ(result.coupling.rank, 21);
  EXPECT_EQ(result.coupling.scale, ScaleState::Determined);
  EXPECT_EQ(result.after.artefacts.size(), 3u);
  EXPECT_EQ(result.left_out.size(), 3u);
  expect_truth(result, truth, 1e-7, 1e-10);
}

TEST(Identify, NoCalibratedLengthIsRefused) {
  VirtualProbing probing;
  probing.kind = ReadingKind::Point;
  const Planted planted = plant(probing);
  const auto result = identify(planted.bound.recording, planted.bound.constraints);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::NoSolution);
  EXPECT_THAT(result.error().message, HasSubstr("no calibrated length"));
  EXPECT_THAT(result.error().message, HasSubstr("ball bar"));
  // Holding one length is a calibrated length too.
  IdentifyOptions options;
  options.hold = {"l"};
  EXPECT_TRUE(identify(planted.bound.recording, planted.bound.constraints, options));
}

TEST(Identify, TooFewReadingsAreRefused) {
  VirtualProbing probing;
  probing.readings = 8;  // 24 residuals for 23 parameters would do, 7 readings would not
  EXPECT_TRUE(identify(plant(probing).bound.recording, plant(probing).bound.constraints));
  probing.readings = 7;
  const Planted few = plant(probing);
  const auto result = identify(few.bound.recording, few.bound.constraints);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::NoSolution);
  EXPECT_THAT(result.error().message, HasSubstr("take more readings"));
}

TEST(Identify, NoReadingsAreRefused) {
  Recording recording;
  recording.arm = test::gao_arm();
  const auto result = identify(recording, {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::NoSolution);
}

TEST(Identify, HoldAndFreeTradeTheMembersOfAPair) {
  const Planted planted = plant({});
  const auto states = [&](std::vector<std::string> hold, std::vector<std::string> free) {
    IdentifyOptions options;
    options.hold = std::move(hold);
    options.free = std::move(free);
    options.noise.reading = 0.01;
    const Identification result = test::identified(planted.bound, options);
    std::string text;
    for (const char* name : {"a6", "theta6", "d6", "alpha6"}) {
      text += test::state_of(result, name) == ParameterState::Identified ? 'i' : '-';
    }
    return text;
  };
  EXPECT_EQ(states({}, {}), "-i-i");
  EXPECT_EQ(states({}, {"a6"}), "i--i");
  EXPECT_EQ(states({"theta6"}, {}), "i--i");
  EXPECT_EQ(states({"alpha6"}, {"a6"}), "i-i-");
  EXPECT_EQ(states({"a6", "theta6"}, {}), "---i");
}

TEST(Identify, ContradictoryRequestsAreWrongUsage) {
  const Arm arm = test::gao_arm();
  for (const auto& [hold, free, says] :
       std::vector<std::tuple<std::vector<std::string>, std::vector<std::string>, std::string>>{
           {{}, {"a6", "theta6"}, "never identified together"},
           {{}, {"d6", "alpha6"}, "never identified together"},
           {{"a1"}, {"a1"}, "both fixed and free"},
           {{"a7"}, {}, "not a parameter of this arm"},
           {{}, {"tip"}, "not a parameter of this arm"}}) {
    const auto selection = select_parameters(arm, hold, free);
    ASSERT_FALSE(selection) << says;
    EXPECT_EQ(selection.error().code, ErrorCode::Usage);
    EXPECT_THAT(selection.error().message, HasSubstr(says));
  }
}

TEST(Identify, AParameterThatIsLostCannotBeFreed) {
  VirtualProbing probing;
  probing.kind = ReadingKind::FrameCoordinates;
  const Planted planted = plant(probing);
  IdentifyOptions options;
  options.free = {"d1"};
  const auto result = identify(planted.bound.recording, planted.bound.constraints, options);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::NoSolution);
  EXPECT_THAT(result.error().message, HasSubstr("d1 is not identifiable"));
}

// Two tips of different length separate a6 from theta6 and d6 from alpha6: nothing is unidentifiable then, and nothing
// is fixed. With a6 and d6 fixed at their nominal zeros the readings would not be fitted.
TEST(Identify, TwoProbesOfDifferentLengthSeparateThePairs) {
  Arm nominal = test::gao_arm();
  nominal.probes.front().name = "long";
  nominal.probes.push_back(nominal.probes.front());
  nominal.probes.back().name = "short";
  nominal.probes.back().tip_in_last.z() = 90.0;
  Planted planted = plant({}, 5, nominal);
  planted.truth.joints.back().a = 0.08;
  planted.truth.joints.back().d = -0.05;
  Recording& recording = planted.bound.recording;
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    const int probe = static_cast<int>(i % 2);
    recording.readings[i].probe = probe;
    std::vector<double> sines(12);
    joint_sines({recording.joints.col(static_cast<Eigen::Index>(i)).data(), 6}, sines);
    recording.readings[i].reference = ForwardKinematics(planted.truth, {}, probe).tip_in_base(sines);
  }
  planted.bound.constraints = *build_constraints(recording, planted.bound.constraints.artefacts);
  IdentifyOptions options;
  options.noise.reading = 0.01;
  const Identification result = test::identified(planted.bound, options);
  EXPECT_EQ(result.coupling.rank, 26);
  EXPECT_EQ(result.free.size(), 26u);
  EXPECT_EQ(test::state_of(result, "a6"), ParameterState::Identified);
  EXPECT_EQ(test::state_of(result, "d6"), ParameterState::Identified);
  expect_truth(result, planted.truth, 1e-7, 1e-10);
}

void add_noise(test::Bound& bound, double sigma, std::uint64_t seed) {
  RandomStream random(seed, "noise");
  for (auto& reading : bound.recording.readings) {
    reading.reference += sigma * normal_vector(random);
  }
  bound.constraints = *build_constraints(bound.recording, bound.constraints.artefacts);
}

TEST(Identify, NoiseIsEstimatedAndJudged) {
  Planted planted = plant({});
  add_noise(planted.bound, 0.02, 1);
  const Identification estimated = test::identified(planted.bound, {});
  EXPECT_NEAR(estimated.noise, 0.02, 0.001);  // 697 degrees of freedom: 2.7 %
  EXPECT_TRUE(estimated.warnings.empty());
  IdentifyOptions too_small;
  too_small.noise.reading = 0.01;
  const Identification enlarged = test::identified(planted.bound, too_small);
  EXPECT_NEAR(enlarged.scale_factor, 2.0, 0.1);
  EXPECT_THAT(enlarged.warnings.at(0), HasSubstr("times the stated noise"));
  for (std::size_t i = 0; i < estimated.parameters.size(); ++i) {
    EXPECT_NEAR(enlarged.parameters[i].u, estimated.parameters[i].u, 0.01 * estimated.parameters[i].u);
  }
}

// The stated uncertainties are the spread of repeated identifications (a seeded Monte Carlo).
TEST(Identify, CovarianceIsTheSpreadOfRepeatedIdentifications) {
  constexpr int trials = 300;
  const Planted planted = plant({.readings = 60});
  IdentifyOptions options;
  options.noise.reading = 0.02;
  options.leave_out = false;
  Eigen::MatrixXd whitened;
  for (int trial = 0; trial < trials; ++trial) {
    Planted noisy = planted;
    add_noise(noisy.bound, 0.02, static_cast<std::uint64_t>(trial));
    const Identification result = test::identified(noisy.bound, options);
    Eigen::VectorXd deviation(static_cast<Eigen::Index>(result.free.size()));
    for (Eigen::Index i = 0; i < deviation.size(); ++i) {
      const auto& parameter = result.parameters[result.free[i]];
      deviation[i] = parameter.identified - value(planted.truth, parameter.parameter);
    }
    whitened.conservativeResize(deviation.size(), trial + 1);
    whitened.col(trial) =
        (result.covariance / (result.scale_factor * result.scale_factor)).llt().matrixL().solve(deviation);
  }
  // 23 · 300 numbers of mean 0 and variance 1: their mean square is 1 within 4 standard deviations.
  EXPECT_NEAR(whitened.squaredNorm() / static_cast<double>(whitened.size()), 1.0, 4 * std::sqrt(2.0 / 6900));
  EXPECT_LT(whitened.rowwise().mean().cwiseAbs().maxCoeff(), 4.5 / std::sqrt(trials));
}

TEST(Identify, RobustLossesBearOutliersAndListThem) {
  Planted planted = plant({});
  add_noise(planted.bound, 0.01, 3);
  for (const int wrong : {10, 50, 90, 130, 170}) {
    planted.bound.recording.readings[wrong].reference.x() += 2.0;
  }
  planted.bound.constraints = *build_constraints(planted.bound.recording, planted.bound.constraints.artefacts);
  const auto worst_error = [&](Loss loss) {
    IdentifyOptions options;
    options.loss = loss;
    const Identification result = test::identified(planted.bound, options);
    double worst = 0.0;
    for (const auto& p : result.parameters) {
      worst = std::max(
          worst, std::abs(p.identified - value(planted.truth, p.parameter)) * (p.parameter.is_angle() ? 1000 : 1));
    }
    std::vector<int> listed;
    for (const Outlier& outlier : result.outliers) listed.push_back(outlier.reading);
    EXPECT_THAT(listed, ::testing::UnorderedElementsAre(10, 50, 90, 130, 170));
    return worst;
  };
  const double plain = worst_error(Loss::None);
  EXPECT_LT(worst_error(Loss::Huber), 0.3 * plain);
  EXPECT_LT(worst_error(Loss::Cauchy), 0.15 * plain);
}

TEST(Identify, TheSameBitsWithAnyNumberOfThreads) {
  const test::Bound bound = test::read_bound(test::example("two-socket-bar/recording.toml"));
  const auto run = [&](int threads) {
    IdentifyOptions options;
    options.threads = threads;
    return test::identified(bound, options);
  };
  const Identification one = run(1);
  for (const int threads : {2, 4, 0}) {
    const Identification other = run(threads);
    EXPECT_EQ(one.covariance, other.covariance);
    for (std::size_t i = 0; i < one.parameters.size(); ++i) {
      EXPECT_EQ(one.parameters[i].identified, other.parameters[i].identified);
    }
    for (std::size_t i = 0; i < one.left_out.size(); ++i) {
      EXPECT_EQ(one.left_out[i].deviation.rms, other.left_out[i].deviation.rms);
    }
  }
}

TEST(Identify, AHeldParameterShowsAsHeld) {
  IdentifyOptions options;
  options.hold = {"a1"};
  options.noise.reading = 0.01;
  const Identification result = test::identified(plant({}).bound, options);
  EXPECT_EQ(test::state_of(result, "a1"), ParameterState::Fixed);
  EXPECT_EQ(test::identified_value(result, "a1"), 0.0);
  EXPECT_EQ(result.free.size(), 22u);
  EXPECT_EQ(result.covariance.rows(), 22);
}

}  // namespace
}  // namespace artcal
