// Identifications repeated from readings drawn anew: against the solver, against analytic answers, and to the bit.
#include "identification/monte_carlo/monte_carlo.h"

#include <cmath>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquisition/recording/recording_file.h"
#include "artefacts/constraints/bound_recording.h"
#include "identification/monte_carlo/reidentification.h"
#include "identification/monte_carlo/trial_inputs.h"
#include "tests/support/simulated_session.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;

struct Example {
  Recording recording;
  Constraints constraints;
  IdentifyOptions options;
  Identification identification;
};

Example identified(Recording recording, Constraints constraints) {
  Example example{std::move(recording), std::move(constraints), {}, {}};
  example.options.noise = example.recording.noise;
  example.options.leave_out = false;
  auto result = identify(example.recording, example.constraints, example.options);
  if (!result) throw std::runtime_error(result.error().text());
  example.identification = std::move(*result);
  return example;
}

Example identified_example(const std::string& name) {
  auto bound = bind_recording(*read_recording(test::example(name + "/recording.toml")));
  return identified(std::move(bound->recording), std::move(bound->constraints));
}

MonteCarloOptions few_quantities() {
  MonteCarloOptions options;
  options.measuring.points = 1;
  options.measuring.lengths = 1;
  options.measuring.balls = 1;
  return options;
}

MonteCarloCount trials(const Example& example, const MonteCarloOptions& options, std::int64_t first, std::int64_t end,
                       int threads = 1) {
  const auto monte_carlo =
      MonteCarlo::prepare(example.recording, example.constraints, example.options, example.identification, options);
  if (!monte_carlo) throw std::runtime_error(monte_carlo.error().text());
  MonteCarloCount count = *monte_carlo->begin(first);
  const auto run = monte_carlo->run(count, {end, 2}, {{}, {}, nullptr, threads});
  if (!run) throw std::runtime_error(run.error().text());
  return count;
}

void expect_same(const MonteCarloCount& a, const MonteCarloCount& b) {
  EXPECT_EQ(a.first, b.first);
  EXPECT_EQ(a.end, b.end);
  EXPECT_EQ(a.not_converged_first, b.not_converged_first);
  ASSERT_EQ(a.distributions.size(), b.distributions.size());
  for (std::size_t i = 0; i < a.distributions.size(); ++i) {
    const auto x = a.distributions[i].contents();
    const auto y = b.distributions[i].contents();
    EXPECT_TRUE(x.count == y.count && x.sum == y.sum && x.squares == y.squares && x.counts == y.counts) << i;
  }
}

TEST(Reidentification, EndsWhereTheSolverEnds) {
  for (const char* name : {"ball-bar", "two-socket-bar"}) {
    const Example example = identified_example(name);
    std::vector<Parameter> free;
    for (const int i : example.identification.free) {
      free.push_back(example.identification.parameters[i].parameter);
    }
    Noise noise = example.recording.noise;
    if (!noise.is_given()) noise.reading = example.identification.noise;
    const auto fit =
        fit_arm(example.recording, example.constraints, example.identification.arm, free, noise, SolveOptions{});
    ASSERT_TRUE(fit);
    const System system = make_system(example.recording, example.constraints, fit->arm, free);
    const auto again = Reidentification::of(system, *fit, {});
    ASSERT_TRUE(again);
    auto scratch = again->scratch();
    InputSpread spread;
    spread.probing = noise.reading.value_or(0.003);
    spread.encoder = noise.encoder.value_or(0.0);
    TrialInputs inputs(system, example.recording, spread);
    const auto covariance = *arm_covariance(Eigen::VectorXd::Ones(system.arm_size()), fit->linearisation);
    const Eigen::MatrixXd information = covariance.inverse();
    for (int trial = 0; trial < 5; ++trial) {
      inputs.draw(1, static_cast<std::uint64_t>(trial));
      const auto answer = again->solve(inputs.system(), scratch);
      const Solution solution =
          solve(inputs.system(), fit->weights, Eigen::VectorXd::Zero(system.arm_size()), fit->unknowns);
      ASSERT_TRUE(answer.converged);
      EXPECT_FALSE(answer.by_solver);
      const Eigen::VectorXd apart = answer.x - solution.x;
      EXPECT_LT(std::sqrt(apart.dot(information * apart)), 1e-3) << name;  // standard deviations, all parameters
      EXPECT_GT(std::sqrt(solution.x.dot(information * solution.x)), 2.0);
    }
  }
}

TEST(MonteCarlo, IsTheSameToTheBitForThreadsAndShares) {
  const Example example = identified_example("ball-bar");
  const MonteCarloOptions options = few_quantities();
  const MonteCarloCount whole = trials(example, options, 0, 170);
  expect_same(whole, trials(example, options, 0, 170, 3));
  MonteCarloCount parts = trials(example, options, 0, 120);
  EXPECT_FALSE(append(parts, trials(example, options, 130, 170)));  // trials are missing
  EXPECT_TRUE(append(parts, trials(example, options, 120, 170, 2)));
  expect_same(whole, parts);
}

TEST(MonteCarlo, IsStoppedBetweenTrialsAndGoesOnToTheSameBits) {
  const Example example = identified_example("ball-bar");
  const auto monte_carlo = MonteCarlo::prepare(example.recording, example.constraints, example.options,
                                               example.identification, few_quantities());
  MonteCarloCount count = *monte_carlo->begin();
  std::atomic<bool> stop{false};
  const auto stop_it = [&](const MonteCarloCount& now) { stop = now.end >= 100; };
  ASSERT_TRUE(monte_carlo->run(count, {250, 2}, {stop_it, {}, &stop, 2}));
  EXPECT_GE(count.end, 100);
  EXPECT_LT(count.end, 250);
  ASSERT_TRUE(monte_carlo->run(count, {250, 2}, {{}, {}, nullptr, 2}));
  expect_same(count, trials(example, few_quantities(), 0, 250));
}

TEST(MonteCarlo, AgreesWithFirstOrderWhereTheModelIsNearlyLinear) {
  const Example example = identified_example("ball-bar");
  const auto monte_carlo = MonteCarlo::prepare(example.recording, example.constraints, example.options,
                                               example.identification, few_quantities());
  const MonteCarloCount count = trials(example, few_quantities(), 0, 800);
  EXPECT_EQ(count.not_converged, 0);
  const auto results = summary(monte_carlo->quantities(), count);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Measurand& quantity = monte_carlo->quantities()[i];
    if (quantity.u_linear) {
      EXPECT_NEAR(results[i].u / *quantity.u_linear, 1.0, 0.1) << quantity.name;  // 2.5 % is one standard deviation
      EXPECT_NEAR(results[i].mean, quantity.estimate, 0.15 * results[i].u) << quantity.name;
    }
  }
}

/// An arm on one bar of three seats, in `placements` places, with next to no noise: what is left is the certificate's.
/// The arm is at its reference temperature; `expansion`, 1/K, is that of its links.
Example on_a_doubtful_bar(int placements, double u, double temperature, double expansion = 0.0) {
  Arm nominal = test::gao_arm();
  for (Joint& joint : nominal.joints) joint.errors.expansion = expansion;
  RandomStream random(4, "arm");
  const Arm truth = testing::arm_with_errors(nominal, random, 0.2, 5e-4);
  testing::Session session(nominal, truth, 11, {1e-9, 1e-6});
  Artefact bar;
  bar.name = "bar";
  bar.expansion = 11.5e-6;
  bar.expansion_is_known = true;
  for (const char* name : {"A", "B"}) bar.features.push_back(testing::feature_of(name, FeatureKind::Point));
  bar.distances.push_back({0, 1, 500.0, u});
  for (int p = 0; p < placements; ++p) {
    const Rigid pose = session.pose();
    for (int end = 0; end < 2; ++end) {
      session.read("bar", std::to_string(p), end == 0 ? "A" : "B", 20, [&](int) {
        const double along = 500.0 * bar.expansion_factor(temperature) * (end - 0.5);
        return Eigen::Vector3d(pose.translation + pose.rotation * Eigen::Vector3d(along, 0.0, 0.0));
      });
    }
  }
  for (Reading& reading : session.recording().readings) {
    reading.temperature = temperature;
    reading.arm_temperature = nominal.reference_temperature;
  }
  session.recording().noise.reading = 1e-5;
  Constraints constraints = *build_constraints(session.recording(), {bar});
  return identified(session.recording(), std::move(constraints));
}

// u of a length that is the bar's relative u, whatever the number of placements: a certificate is wrong in all of them
// alike.
TEST(MonteCarlo, KnowsThatACertificateIsTheSameInAllPlacements) {
  const double u = 0.05;  // on 500 mm: 100 ppm
  const Example example = on_a_doubtful_bar(5, u, 20.0);
  const auto monte_carlo = MonteCarlo::prepare(example.recording, example.constraints, example.options,
                                               example.identification, few_quantities());
  const auto results = summary(monte_carlo->quantities(), trials(example, few_quantities(), 0, 600));
  int lengths = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Measurand& quantity = monte_carlo->quantities()[i];
    if (quantity.kind == Measurand::Kind::Length) {
      ++lengths;
      EXPECT_NEAR(results[i].u / quantity.estimate, u / 500.0, 0.12 * u / 500.0);
      EXPECT_NEAR(*quantity.u_linear / quantity.estimate, u / 500.0, 0.02 * u / 500.0);  // and so does first order
      EXPECT_FALSE(results[i].differs_from_linear);
    }
  }
  EXPECT_EQ(lengths, 5);
}

TEST(MonteCarlo, DrawsTemperaturesAnewInEachPlacement) {
  const Example example = on_a_doubtful_bar(1, 1e-4, 25.0);
  MonteCarloOptions options = few_quantities();
  options.u_temperature = 2.0;  // times 11.5e-6 a kelvin: 23 ppm
  const auto monte_carlo =
      MonteCarlo::prepare(example.recording, example.constraints, example.options, example.identification, options);
  const auto results = summary(monte_carlo->quantities(), trials(example, options, 0, 600));
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Measurand& quantity = monte_carlo->quantities()[i];
    if (quantity.kind == Measurand::Kind::Length) {
      EXPECT_NEAR(results[i].u / quantity.estimate, 23e-6, 2.8e-6);
      EXPECT_TRUE(results[i].differs_from_linear);  // which knows of no temperature
    }
  }
}

// Every link grows alike, so that an error of the arm's temperature is one of its scale, by expansion times u in one
// placement and by a √5th of that in five, for each is drawn anew.
TEST(MonteCarlo, DrawsTheArmsTemperatureAnewInEachPlacement) {
  MonteCarloOptions options = few_quantities();
  options.u_arm_temperature = 2.0;
  for (const int placements : {1, 5}) {
    Example example = on_a_doubtful_bar(placements, 1e-4, 20.0, 10e-6);
    const auto monte_carlo =
        MonteCarlo::prepare(example.recording, example.constraints, example.options, example.identification, options);
    ASSERT_TRUE(monte_carlo) << monte_carlo.error().text();
    const auto results = summary(monte_carlo->quantities(), trials(example, options, 0, 600));
    const double relative = 20e-6 / std::sqrt(placements);
    int lengths = 0;
    for (std::size_t i = 0; i < results.size(); ++i) {
      const Measurand& quantity = monte_carlo->quantities()[i];
      if (quantity.kind == Measurand::Kind::Length) {
        ++lengths;
        EXPECT_NEAR(results[i].u / quantity.estimate, relative, 0.12 * relative) << placements;
        EXPECT_TRUE(results[i].differs_from_linear);
      }
    }
    EXPECT_EQ(lengths, 5);
  }
}

TEST(MonteCarlo, RefusesATemperatureOfTheArmThatChangesNothing) {
  const Example example = on_a_doubtful_bar(1, 1e-4, 20.0);
  MonteCarloOptions options = few_quantities();
  options.u_arm_temperature = 0.1;
  const auto monte_carlo =
      MonteCarlo::prepare(example.recording, example.constraints, example.options, example.identification, options);
  ASSERT_FALSE(monte_carlo);
  EXPECT_EQ(monte_carlo.error().code, ErrorCode::BadInput);
  EXPECT_THAT(monte_carlo.error().message, HasSubstr("no link of this arm expands"));
}

/// Readings with a noise of 0.4 mm, which not every trial converges from.
MonteCarlo of_very_noisy_readings(Example& example) {
  example.options.noise = {0.4, {}, {}};
  example.options.max_iterations = 4;
  MonteCarloOptions options = few_quantities();
  options.measuring.balls = 0;
  return *MonteCarlo::prepare(example.recording, example.constraints, example.options, example.identification, options);
}

void expect_all_counted(const MonteCarloCount& count, std::int64_t trials) {
  EXPECT_EQ(count.end, trials);
  EXPECT_EQ(count.not_converged_first.size(),
            static_cast<std::size_t>(std::min<std::int64_t>(10, count.not_converged)));
  for (const Distribution& distribution : count.distributions) {
    EXPECT_EQ(distribution.count(), trials - count.not_converged);
  }
}

TEST(MonteCarlo, CountsAndListsATrialThatDoesNotConverge) {
  Example example = identified_example("ball-bar");
  const MonteCarlo monte_carlo = of_very_noisy_readings(example);
  MonteCarloCount count = *monte_carlo.begin();
  ASSERT_TRUE(monte_carlo.run(count, {90, 2}, {}));  // too few to judge
  EXPECT_GT(count.not_converged, 0);
  expect_all_counted(count, 90);
}

TEST(MonteCarlo, StopsWhereMoreThanOneTrialInAHundredDoesNotConverge) {
  Example example = identified_example("ball-bar");
  const MonteCarlo monte_carlo = of_very_noisy_readings(example);
  MonteCarloCount count = *monte_carlo.begin();
  const auto run = monte_carlo.run(count, {150, 2}, {});
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().code, ErrorCode::NoSolution);
  EXPECT_GT(count.not_converged, 1);
  EXPECT_THAT(run.error().message, HasSubstr(std::to_string(count.not_converged) + " of 150 identifications"));
  expect_all_counted(count, 150);
}

TEST(MonteCarlo, DoesNotBeginWhereHardlyAnyTrialConverges) {
  Example example = identified_example("ball-bar");
  example.options.noise = {1.0, {}, {}};
  example.options.max_iterations = 4;
  const auto monte_carlo = MonteCarlo::prepare(example.recording, example.constraints, example.options,
                                               example.identification, few_quantities());
  ASSERT_TRUE(monte_carlo) << monte_carlo.error().text();
  const auto refused = monte_carlo->begin();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::NoSolution);
  EXPECT_THAT(refused.error().message, HasSubstr("of 200 identifications"));
}

// A noise that ν residuals tell makes values t-distributed: their variance is ν/(ν − 2) of the first-order one.
TEST(MonteCarlo, IsWiderWhereFewResidualsToldTheNoise) {
  const Arm nominal = test::gao_arm();
  RandomStream random(4, "arm");
  testing::Session session(nominal, testing::arm_with_errors(nominal, random, 0.2, 5e-4), 3);
  Artefact bar;
  bar.name = "bar";
  for (const char* name : {"A", "B"}) bar.features.push_back(testing::feature_of(name, FeatureKind::Point));
  bar.distances.push_back({0, 1, 500.0, 1e-4});
  for (int p = 0; p < 2; ++p) {
    const Rigid pose = session.pose();
    for (const double end : {0.0, 500.0}) {
      session.read("bar", std::to_string(p), end == 0.0 ? "A" : "B", 2,
                   [&](int) { return Eigen::Vector3d(pose * Eigen::Vector3d(end, 0.0, 0.0)); });
    }
  }
  Constraints constraints = *build_constraints(session.recording(), {bar});
  Example example{session.recording(), std::move(constraints), {}, {}};
  example.options.leave_out = false;
  for (const Parameter& parameter : parameters_of(session.truth())) {
    const auto kind = parameter.kind;
    if (kind != ParameterKind::Theta && kind != ParameterKind::TipZ) example.options.hold.push_back(parameter.name);
  }
  example.recording.arm = session.truth();
  auto result = identify(example.recording, example.constraints, example.options);
  ASSERT_TRUE(result) << result.error().text();
  example.identification = std::move(*result);
  const double nu = example.identification.degrees_of_freedom;
  ASSERT_EQ(nu, 3 * 8 + 2 - 3 * 4 - 6);  // readings and lengths less seats and five zero offsets and the tip
  constexpr int number = 4000;
  MonteCarloOptions options = few_quantities();
  options.measuring.points = options.measuring.lengths = options.measuring.balls = 0;
  const auto monte_carlo =
      MonteCarlo::prepare(example.recording, example.constraints, example.options, example.identification, options);
  const auto results = summary(monte_carlo->quantities(), trials(example, options, 0, number));
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Measurand& quantity = monte_carlo->quantities()[i];
    if (quantity.kind != Measurand::Kind::Parameter) continue;
    // Of the deviation of a t-distribution: its excess kurtosis is 6/(ν − 4).
    const double error = std::sqrt((2.0 + 6.0 / (nu - 4.0)) / 4.0 / number);
    EXPECT_NEAR(results[i].u / *quantity.u_linear / std::sqrt(nu / (nu - 2.0)), 1.0, 4.0 * error) << quantity.name;
  }
}

TEST(MonteCarlo, SaysThatFirstOrderDiffersWhereTheTrialsTellIt) {
  Measurand quantity;
  quantity.u_linear = 1.0;
  for (const auto& [trials, spread, differs] :
       {std::tuple{50, 1.2, false}, std::tuple{5000, 1.2, true}, std::tuple{5000, 0.8, true}, std::tuple{50, 3.0, true},
        std::tuple{100'000, 1.05, false}}) {
    MonteCarloCount count{0, trials, 0, {}, {Distribution(Ruler{0.0, 1.0})}};
    for (int i = 0; i < trials; ++i) count.distributions[0].add(spread * RandomStream(1, "values", i).normal());
    EXPECT_EQ(summary({quantity}, count)[0].differs_from_linear, differs) << trials << ", " << spread;
  }
}

TEST(MonteCarlo, RefusesReadingsWithoutNoise) {
  Example example = identified_example("ball-bar");
  example.options.noise = {};
  example.identification.noise_is_given = false;
  example.identification.noise = 1e-9;
  const auto refused = MonteCarlo::prepare(example.recording, example.constraints, example.options,
                                           example.identification, few_quantities());
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("no noise to draw"));
}

TEST(MonteCarlo, RefusesAPointOutOfReach) {
  const Example example = identified_example("ball-bar");
  MonteCarloOptions options = few_quantities();
  options.measuring.points_in_base = {{5000.0, 0.0, 0.0}};
  const auto refused =
      MonteCarlo::prepare(example.recording, example.constraints, example.options, example.identification, options);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("does not reach"));
}

}  // namespace
}  // namespace artcal
