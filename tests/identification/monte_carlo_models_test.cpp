// Monte Carlo of arms that are more than a chain: each group's parameters against first order, against whole
// identifications of readings drawn by the independent equations, and to the bit.
#include "core/normal_vector.h"
#include "identification/monte_carlo/monte_carlo.h"

#include <cmath>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/joint_error_sessions.h"

namespace artcal {
namespace {

using testing::nominal_arm;

struct Planted {
  Arm truth;
  test::Bound bound;
  IdentifyOptions options;
  Identification identification;
};

/// With certificates that are as doubtful as what the readings leave open.
test::Bound with_doubtful_lengths(test::Bound bound) {
  std::vector<Artefact> artefacts = bound.constraints.artefacts;
  for (CertifiedDistance& distance : artefacts.front().distances) distance.u = 5e-3;
  return test::bind(std::move(bound.recording), std::move(artefacts));
}

Planted planted(const Model& model, const testing::SessionNoise& noise) {
  Arm nominal = nominal_arm();
  if (model == Model{ParameterGroup::Hayati}) {  // second and third axis parallel
    nominal.joints[1] = {.a = 792.7, .d = 0.0, .alpha = 0.0, .mass = 1.5};
    nominal.joints[2].d = 65.5;
  }
  if (model == Model{ParameterGroup::Tip}) {  // which takes two styli
    nominal.probes[0].name = "short";
    nominal.probes.push_back({"long", {0.0, 0.0, 320.0}, 3.0, true});
  }
  Planted made{testing::true_arm(nominal, model, 1), {}, testing::options_for(model), {}};
  if (model == Model{ParameterGroup::Hayati}) made.truth.joints[1].d = nominal.joints[1].d;
  if (model == Model{ParameterGroup::Tip}) {  // of four offsets the readings tell two beside the last joint's angles
    made.truth.probes[0].tip_in_last.head<2>() = nominal.probes[0].tip_in_last.head<2>();
    made.options.hold = {"lx:short", "ly:short"};
  }
  made.bound = with_doubtful_lengths(model == Model{ParameterGroup::Radius}
                                         ? testing::ball_session(nominal, made.truth, 1, noise)
                                         : testing::bar_session(nominal, made.truth, 1, noise, 4));
  made.identification = test::identified(made.bound, made.options);
  if (made.identification.scale_factor != 1.0) throw std::runtime_error("this seed enlarges the draws");
  return made;
}

/// `made` must outlive it.
MonteCarlo monte_carlo_of(const Planted& made) {
  MonteCarloOptions options;
  options.measuring.points = 2;
  options.measuring.lengths = 1;
  options.measuring.balls = 1;
  auto monte_carlo =
      MonteCarlo::prepare(made.bound.recording, made.bound.constraints, made.options, made.identification, options);
  if (!monte_carlo) throw std::runtime_error(monte_carlo.error().text());
  return std::move(*monte_carlo);
}

MonteCarloCount trials(const MonteCarlo& monte_carlo, std::int64_t end, int threads = 0) {
  MonteCarloCount count = *monte_carlo.begin();
  const auto run = monte_carlo.run(count, {end, 2}, {{}, {}, nullptr, threads});
  if (!run) throw std::runtime_error(run.error().text());
  return count;
}

void expect_first_order(const MonteCarlo& monte_carlo, const MonteCarloCount& count) {
  EXPECT_EQ(count.not_converged, 0);
  const auto trials_made = static_cast<double>(count.end);
  const auto results = summary(monte_carlo.quantities(), count);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Measurand& quantity = monte_carlo.quantities()[i];
    if (!quantity.u_linear) continue;
    EXPECT_NEAR(results[i].u / *quantity.u_linear, 1.0, 4.0 / std::sqrt(2.0 * trials_made)) << quantity.name;
    EXPECT_NEAR(results[i].mean, quantity.estimate, 4.0 * results[i].u / std::sqrt(trials_made)) << quantity.name;
  }
}

TEST(MonteCarloOfModels, AgreesWithFirstOrderFromNoisyReadings) {
  const Planted made = planted({ParameterGroup::Eccentricity}, {});
  const MonteCarlo monte_carlo = monte_carlo_of(made);
  expect_first_order(monte_carlo, trials(monte_carlo, 2000));
}

/// The readings of a session without noise, and an arm to read them with again and again.
class Rereading {
 public:
  Rereading(const Arm& truth, const test::Bound& exact)
      : numbers_(truth), reference_(truth.reference_temperature), exact_(exact) {}

  test::Bound draw(RandomStream& random, const testing::SessionNoise& noise) const {
    Recording recording = exact_.recording;
    for (std::size_t i = 0; i < recording.readings.size(); ++i) {
      const Reading& reading = recording.readings[i];
      const double temperature_offset =
          std::isnan(reading.arm_temperature) ? 0.0 : reading.arm_temperature - reference_;
      auto q = recording.joints.col(static_cast<Eigen::Index>(i));
      q += shifted(q, reading.probe, temperature_offset, noise.probing * normal_vector(random));
      for (double& angle : q) angle += noise.encoder * random.normal();
    }
    std::vector<Artefact> artefacts = exact_.constraints.artefacts;
    for (CertifiedDistance& distance : artefacts.front().distances) distance.value += distance.u * random.normal();
    return test::bind(std::move(recording), std::move(artefacts));
  }

 private:
  // The smallest change of the joints that moves the tip by so much.
  Eigen::VectorXd shifted(const Eigen::VectorXd& q, int probe, double temperature_offset,
                          const Eigen::Vector3d& by) const {
    const auto tip = [&](const Eigen::VectorXd& at) {
      return testing::tip_with_errors(numbers_, std::vector<double>(at.begin(), at.end()), probe, temperature_offset);
    };
    Eigen::Matrix3Xd slope(3, q.size());
    for (Eigen::Index j = 0; j < q.size(); ++j) {
      const Eigen::VectorXd step = 1e-6 * Eigen::VectorXd::Unit(q.size(), j);
      slope.col(j) = (tip(q + step) - tip(q - step)) / 2e-6;
    }
    return slope.transpose() * (slope * slope.transpose()).ldlt().solve(by);
  }

  testing::ArmNumbers<double> numbers_;
  double reference_;
  const test::Bound& exact_;
};

/// Mean square of the correlations: with so much of 2/(n − 1) the mean of n values' variances varies.
double shared_by(const Eigen::MatrixXd& covariance) {
  const Eigen::VectorXd u = covariance.diagonal().cwiseSqrt();
  const Eigen::MatrixXd correlation = u.cwiseInverse().asDiagonal() * covariance * u.cwiseInverse().asDiagonal();
  return correlation.cwiseAbs2().mean();
}

class MonteCarloOfGroups : public ::testing::TestWithParam<Model> {};

TEST_P(MonteCarloOfGroups, AgreesWithFirstOrderAndWithWholeIdentificationsOfReadingsDrawnIndependently) {
  constexpr int number = 50;
  const Planted made = planted(GetParam(), {0.0, 0.0});
  const MonteCarlo monte_carlo = monte_carlo_of(made);
  const MonteCarloCount count = trials(monte_carlo, 700);
  expect_first_order(monte_carlo, count);
  const auto results = summary(monte_carlo.quantities(), count);
  const Rereading again(made.truth, made.bound);
  std::vector<Eigen::VectorXd> found;
  for (int k = 0; k < number; ++k) {
    RandomStream random(5, "drawn independently", static_cast<std::uint64_t>(k));
    const Identification result = test::identified(again.draw(random, {}), made.options);
    ASSERT_EQ(result.free, made.identification.free);
    Eigen::VectorXd& row = found.emplace_back(result.free.size());
    for (Eigen::Index i = 0; i < row.size(); ++i) {
      row[i] = result.parameters[result.free[static_cast<std::size_t>(i)]].identified;
    }
  }
  double sum = 0.0;
  const Eigen::Index width = found.front().size();
  for (Eigen::Index i = 0; i < width; ++i) {
    double mean = 0.0;
    double squares = 0.0;
    for (const auto& row : found) mean += row[i] / number;
    for (const auto& row : found) squares += std::pow(row[i] - mean, 2) / (number - 1);
    const MonteCarloSummary& result = results[static_cast<std::size_t>(i)];
    const auto& quantity = monte_carlo.quantities()[static_cast<std::size_t>(i)];
    EXPECT_NEAR(std::sqrt(squares) / result.u, 1.0, 4.0 / std::sqrt(2.0 * (number - 1))) << quantity.name;
    EXPECT_LT(std::abs(mean - value(made.truth, made.identification.parameters[made.identification.free[i]].parameter)),
              4.5 * result.u / std::sqrt(number))
        << quantity.name;
    sum += squares / (result.u * result.u);
  }
  EXPECT_NEAR(sum / static_cast<double>(width), 1.0,
              4.0 * std::sqrt(2.0 / (number - 1) * shared_by(made.identification.covariance)));
}

INSTANTIATE_TEST_SUITE_P(Model, MonteCarloOfGroups,
                         ::testing::Values(Model{ParameterGroup::Eccentricity, ParameterGroup::SecondEccentricity},
                                           Model{ParameterGroup::Gain, ParameterGroup::Gravity,
                                                 ParameterGroup::Thermal},
                                           Model{ParameterGroup::Coupling}, Model{ParameterGroup::Hayati},
                                           Model{ParameterGroup::Tip}, Model{ParameterGroup::Radius}),
                         [](const auto& model) {
                           std::string name = model_text(model.param).substr(3);
                           std::replace(name.begin(), name.end(), '+', '_');
                           return name;
                         });

TEST(MonteCarloOfModels, IsTheSameToTheBitForThreadsAndShares) {
  const Planted made = planted({ParameterGroup::Gain, ParameterGroup::Gravity}, {});
  const MonteCarlo monte_carlo = monte_carlo_of(made);
  const MonteCarloCount whole = trials(monte_carlo, 170, 1);
  MonteCarloCount parts = *monte_carlo.begin();
  ASSERT_TRUE(monte_carlo.run(parts, {110, 2}, {{}, {}, nullptr, 3}));
  MonteCarloCount rest = *monte_carlo.begin(110);
  ASSERT_TRUE(monte_carlo.run(rest, {170, 2}, {{}, {}, nullptr, 2}));
  ASSERT_TRUE(append(parts, rest));
  ASSERT_EQ(parts.distributions.size(), whole.distributions.size());
  for (std::size_t i = 0; i < whole.distributions.size(); ++i) {
    const auto a = whole.distributions[i].contents();
    const auto b = parts.distributions[i].contents();
    EXPECT_TRUE(a.sum == b.sum && a.squares == b.squares && a.counts == b.counts) << i;
  }
}

}  // namespace
}  // namespace artcal
