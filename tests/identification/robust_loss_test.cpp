// Robust losses against numbers from outside (tests/reference/robust-losses/make.py: scipy) and planted truth: they
// reach distances and certificates, and what is said of the fit knows of what it let go.
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefacts/virtual_probing/virtual_probing.h"
#include "core/normal_vector.h"
#include "core/random.h"
#include "identification/identify.h"
#include "tests/support/recordings.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

struct KnownMoments {
  Loss loss;
  int degrees;
  double square, variance, information;
};
constexpr KnownMoments by_scipy[] = {{Loss::Huber, 1, 0.710164548269, 0.45556535119, 0.98969189551},
                                     {Loss::Huber, 3, 0.892801300121, 0.324442912092, 1.00776667683},
                                     {Loss::Cauchy, 1, 0.511952875669, 0.203412541359, 1.0827509876},
                                     {Loss::Cauchy, 3, 0.630586640198, 0.117513751464, 1.14189301585}};

TEST(LossMoments, AreThoseOfScipy) {
  for (const KnownMoments& known : by_scipy) {
    const LossMoments moments = moments_of(known.loss, known.degrees);
    EXPECT_NEAR(moments.square, known.square, 1e-8);
    EXPECT_NEAR(moments.variance, known.variance, 1e-8);
    EXPECT_NEAR(moments.information, known.information, 1e-8);
  }
  // Least squares: ψ² is χ² by its degrees of freedom.
  const LossMoments plain = moments_of(Loss::None, 3.0);
  EXPECT_NEAR(plain.square, 1.0, 1e-9);
  EXPECT_NEAR(plain.variance, 2.0 / 3.0, 1e-9);
  EXPECT_NEAR(plain.information, 1.0, 1e-9);
}

// Of the same script: changes of these parameters from their nominal values, and the spread of 300 cauchy estimates.
constexpr const char* names_of_four[] = {"d3", "d5", "alpha2", "theta4"};
constexpr double scipy_linear[] = {0.407765595, -0.303036961, 0.000393162996, -0.000602184996};
constexpr double scipy_huber[] = {0.405678726, -0.302713615, 0.000393365854, -0.000599255668};
constexpr double scipy_cauchy[] = {0.405545586, -0.30243427, 0.00039348939, -0.000599265745};
constexpr double scipy_u[] = {3.33311689e-03, 3.34809933e-03, 6.51867688e-06, 3.78178231e-06};

/// The distances of tests/reference/robust-losses/distances.csv: each read once at both ends, one of them 5 standard
/// deviations off.
test::Bound single_distances() {
  Recording recording;
  recording.name = "distances";
  recording.arm = test::gao_arm();
  recording.files.emplace_back("distances.csv");
  std::ifstream file(std::string(ARTCAL_SOURCE_DIR) + "/tests/reference/robust-losses/distances.csv");
  std::string line;
  std::getline(file, line);
  std::vector<Artefact> artefacts;
  std::vector<double> angles;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::array<double, 13> numbers{};
    for (double& number : numbers) {
      std::string cell;
      std::getline(cells, cell, ',');
      number = std::stod(cell);
    }
    Artefact artefact;
    artefact.name = "pair " + std::to_string(artefacts.size());
    for (const char* end : {"a", "b"}) {
      Reading reading;
      reading.artefact = recording.artefacts.index_of(artefact.name);
      reading.placement = recording.placements.index_of("only");
      reading.feature = recording.features.index_of(end);
      reading.orientation = recording.orientations.index_of("");
      reading.repeat = recording.repeats.index_of("");
      reading.line = static_cast<int>(recording.readings.size()) + 2;
      recording.readings.push_back(reading);
      CertifiedFeature feature;
      feature.name = end;
      artefact.features.push_back(feature);
    }
    artefact.distances = {{0, 1, numbers.back(), 0.01}};
    artefacts.push_back(artefact);
    angles.insert(angles.end(), numbers.begin(), numbers.end() - 1);
  }
  recording.joints = Eigen::MatrixXd::Map(angles.data(), 6, static_cast<Eigen::Index>(recording.readings.size()));
  return test::bind(std::move(recording), std::move(artefacts));
}

std::array<double, 4> found(const Identification& result) {
  std::array<double, 4> values{};
  for (const IdentifiedParameter& p : result.parameters) {
    const auto at = std::find(std::begin(names_of_four), std::end(names_of_four), p.parameter.name);
    if (at != std::end(names_of_four)) {
      values[static_cast<std::size_t>(at - std::begin(names_of_four))] = p.identified - p.nominal;
    }
  }
  return values;
}

TEST(RobustLoss, ReachesDistancesThatAreReadOnce) {
  const test::Bound bound = single_distances();
  IdentifyOptions options;
  options.leave_out = false;
  options.noise.reading = 0.02;
  for (const Parameter& parameter : parameters_of(bound.recording.arm)) {
    if (std::find(std::begin(names_of_four), std::end(names_of_four), parameter.name) == std::end(names_of_four)) {
      options.hold.push_back(parameter.name);
    }
  }
  const auto linear = found(test::identified(bound, options));
  options.loss = Loss::Huber;
  const auto huber = found(test::identified(bound, options));
  options.loss = Loss::Cauchy;
  const Identification result = test::identified(bound, options);
  const auto cauchy = found(result);
  for (std::size_t i = 0; i < 4; ++i) {
    SCOPED_TRACE(names_of_four[i]);
    EXPECT_NEAR(linear[i], scipy_linear[i], 1e-6 * std::abs(scipy_linear[i]));
    // Ours measures each distance by the spread that it has beside the parameters that are fitted to it too: 2 % less.
    EXPECT_NEAR(huber[i], scipy_huber[i], 0.1 * scipy_u[i]);
    EXPECT_NEAR(cauchy[i], scipy_cauchy[i], 0.1 * scipy_u[i]);
  }
  // One standard deviation of 300 estimates is known to 4 %.
  for (const IdentifiedParameter& p : result.parameters) {
    const auto at = std::find(std::begin(names_of_four), std::end(names_of_four), p.parameter.name);
    if (at != std::end(names_of_four)) {
      const double u = scipy_u[static_cast<std::size_t>(at - std::begin(names_of_four))];
      EXPECT_NEAR(p.u, u, 0.15 * u) << p.parameter.name;
    }
  }
  EXPECT_EQ(result.scale_factor, 1.0);
  EXPECT_NEAR(result.chi_squared, result.degrees_of_freedom, 0.4 * result.degrees_of_freedom);
  ASSERT_EQ(result.certificate_outliers.size(), 1u);
  EXPECT_EQ(result.certificate_outliers.front().name.artefact, "pair 77");
  EXPECT_LT(result.certificate_outliers.front().weight, 0.25);
  // Without a stated noise the readings, each alone on its point, do not come out as exact.
  options.noise = {};
  const Identification estimated = test::identified(bound, options);
  EXPECT_NEAR(estimated.noise, 0.02, 0.006);
  EXPECT_NEAR(found(estimated)[0], scipy_cauchy[0], 0.2 * scipy_u[0]);
}

/// 700 coordinates of a planted arm with 10 µm of noise, the first `wrong` of them 2 mm off.
test::Bound coordinates(int wrong) {
  VirtualProbing probing;
  probing.readings = 700;
  Arm truth = test::gao_arm();
  truth.joints[2].d += 0.2;
  truth.joints[3].alpha += 1e-3;
  VirtualRecording made = probe_virtually(truth, probing);
  made.recording.arm = test::gao_arm();
  RandomStream random(9, "noise");
  for (std::size_t i = 0; i < made.recording.readings.size(); ++i) {
    Eigen::Vector3d& reference = made.recording.readings[i].reference;
    reference += 0.01 * normal_vector(random);
    reference.x() += static_cast<int>(i) < wrong ? 2.0 : 0.0;
  }
  return test::bind(std::move(made.recording), std::move(made.artefacts));
}

TEST(RobustLoss, SevenBadReadingsOfSevenHundredLeaveTheUncertaintiesAlone) {
  IdentifyOptions options;
  options.leave_out = false;
  options.noise.reading = 0.01;
  const Identification clean = test::identified(coordinates(0), options);
  for (const Loss loss : {Loss::Huber, Loss::Cauchy}) {
    options.loss = loss;
    const Identification result = test::identified(coordinates(7), options);
    EXPECT_EQ(result.scale_factor, 1.0);
    EXPECT_GT(result.chi_squared, result.chi_squared_low);
    EXPECT_LT(result.chi_squared, result.chi_squared_high);
    EXPECT_EQ(result.degrees_of_freedom, clean.degrees_of_freedom - 3 * 7);
    EXPECT_EQ(result.outliers.size(), 7u);
    for (std::size_t i = 0; i < clean.free.size(); ++i) {
      // A robust estimate of three coordinates together is a little worse than least squares: 5 % in variance at most.
      const double ratio = result.parameters[result.free[i]].u / clean.parameters[clean.free[i]].u;
      EXPECT_GT(ratio, 0.97) << result.parameters[result.free[i]].parameter.name;
      EXPECT_LT(ratio, 1.08) << result.parameters[result.free[i]].parameter.name;
    }
  }
  // A noise that is stated too small is found by a robust fit too.
  options.loss = Loss::Cauchy;
  options.noise.reading = 0.005;
  EXPECT_NEAR(test::identified(coordinates(7), options).scale_factor, 2.0, 0.2);
}

/// Real readings on a bar of 50 mm, in one of whose six placements the certificate says 55 mm.
test::Bound wrong_certificate() {
  test::Bound bound = test::read_bound(test::example("two-socket-bar/recording.toml"));
  Recording& recording = bound.recording;
  std::vector<Artefact> artefacts = bound.constraints.artefacts;
  artefacts.push_back(artefacts.front());
  artefacts.back().name = "wrong bar";
  artefacts.back().distances.front().value = 55.0;
  const int place = recording.placements.index_of("backleft");
  for (Reading& reading : recording.readings) {
    reading.artefact = recording.artefacts.index_of(reading.placement == place ? "wrong bar" : artefacts.front().name);
  }
  return test::bind(recording, artefacts);
}

TEST(RobustLoss, AWrongCertificateIsBlamedAndNotItsReadings) {
  const test::Bound bound = wrong_certificate();
  IdentifyOptions options;
  options.leave_out = false;
  options.loss = Loss::Cauchy;
  const Identification right =
      test::identified(test::read_bound(test::example("two-socket-bar/recording.toml")), options);
  const Identification result = test::identified(bound, options);
  ASSERT_EQ(result.certificate_outliers.size(), 1u);
  const CertificateOutlier& outlier = result.certificate_outliers.front();
  EXPECT_EQ(outlier.name.artefact, "wrong bar");
  EXPECT_EQ(outlier.name.placement, "backleft");
  EXPECT_EQ(outlier.certified, 55.0);
  EXPECT_NEAR(outlier.deviation, -5.0, 0.2);
  EXPECT_LT(outlier.weight, 0.01);
  EXPECT_THAT(result.warnings, ::testing::Contains(AllOf(HasSubstr("wrong bar"), HasSubstr("contradicts"))));
  int blamed = 0;
  for (const Outlier& reading : result.outliers) blamed += reading.name.artefact == "wrong bar" ? 1 : 0;
  EXPECT_LE(blamed, 1);
  EXPECT_NEAR(result.after.overall.rms, right.after.overall.rms, 0.005);
  EXPECT_NEAR(result.noise, right.noise, 0.02 * right.noise);
  // The arm is that of the right certificates within what one of six lengths tells.
  for (const IdentifiedParameter& p : result.parameters) {
    if (p.state != ParameterState::Identified) continue;
    const auto same = std::find_if(right.parameters.begin(), right.parameters.end(),
                                   [&](const auto& other) { return other.parameter.name == p.parameter.name; });
    EXPECT_NEAR(p.identified, same->identified, 1.0 * p.u) << p.parameter.name;
    EXPECT_NEAR(p.u, same->u, 0.2 * p.u) << p.parameter.name;
  }
  ASSERT_EQ(result.influences.size(), 2u);
  EXPECT_GT(result.influences[0].certificates_weight, 0.7);
  EXPECT_LT(result.influences[1].certificates_weight, 0.01);
  EXPECT_GT(result.influences[1].readings_weight, 0.8);
  EXPECT_NEAR(result.influences[0].share + result.influences[1].share, 1.0, 1e-9);
  EXPECT_GT(result.influences[0].share, 0.7);
}

// A distance that is known to millimetres only may be millimetres off; to micrometres it may not.
TEST(RobustLoss, SingleDistancesAreRefusedByTheirUncertainty) {
  test::Bound bound = single_distances();
  std::vector<Artefact> artefacts = bound.constraints.artefacts;
  for (Artefact& artefact : artefacts) artefact.distances.front().u = 0.8;
  artefacts[50].distances.front().value += 3.0;
  IdentifyOptions options;
  options.leave_out = false;
  options.noise.reading = 0.02;
  EXPECT_TRUE(identify(bound.recording, *build_constraints(bound.recording, artefacts), options));
  for (Artefact& artefact : artefacts) artefact.distances.front().u = 0.01;
  const auto refused = identify(bound.recording, *build_constraints(bound.recording, artefacts), options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::NoSolution);
}

}  // namespace
}  // namespace artcal
