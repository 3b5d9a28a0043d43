// Planes, gauges, balls of unknown size, the tip's radius and certificates' own uncertainty: planted truths come
// back from readings of an independent simulation, and what cannot be determined is said.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/normal_vector.h"
#include "tests/support/recordings.h"
#include "tests/support/simulated_session.h"

namespace artcal {
namespace {

using testing::feature_of;
using ::testing::HasSubstr;
using testing::Session;

constexpr testing::SessionNoise silent{0.0, 0.0};

Arm nominal_arm(double tip_radius = 3.0) {
  Arm arm = test::gao_arm();
  arm.probes.front().radius = tip_radius;
  return arm;
}

Arm true_arm(std::uint64_t seed, const Arm& nominal) {
  RandomStream random(seed, "true arm");
  return testing::arm_with_errors(nominal, random, 0.3, 1.7e-3);
}

IdentifyOptions stated_noise(double mm = 0.01) {
  IdentifyOptions options;
  options.noise.reading = mm;
  options.leave_out = false;
  return options;
}

void expect_truth(const Identification& result, const Arm& truth, double mm = 1e-6, double rad = 1e-9) {
  for (const auto& parameter : result.parameters) {
    EXPECT_NEAR(parameter.identified, value(truth, parameter.parameter), parameter.parameter.is_angle() ? rad : mm)
        << parameter.parameter.name;
  }
}

Artefact planes(int count) {
  Artefact artefact;
  artefact.name = "planes";
  for (int i = 0; i < count; ++i) artefact.features.push_back(feature_of(std::to_string(i), FeatureKind::Plane));
  return artefact;
}

void read_planes(Session& session, const Artefact& artefact, const std::string& placement, int readings) {
  for (const auto& feature : artefact.features) {
    const Rigid pose = session.pose();
    session.read_plane(artefact.name, placement, feature.name, readings, pose.translation, pose.rotation.col(2), 400.0);
  }
}

Artefact seats(double length) {
  Artefact artefact;
  artefact.name = "seats";
  artefact.features = {feature_of("A", FeatureKind::Point), feature_of("B", FeatureKind::Point)};
  artefact.distances = {{0, 1, length, 0.0005}};
  return artefact;
}

void read_seats(Session& session, const Artefact& artefact, const std::string& placement, int readings) {
  const Rigid pose = session.pose();
  for (const double end : {0.0, 1.0}) {
    const Eigen::Vector3d at = pose * Eigen::Vector3d(end * artefact.distances[0].value, 0.0, 0.0);
    session.read(artefact.name, placement, end == 0.0 ? "A" : "B", readings, [&](int) { return at; });
  }
}

TEST(Planes, WithOneLengthTheyBringBackTheTruth) {
  const Arm nominal = nominal_arm();
  const Arm truth = true_arm(1, nominal);
  Session session(nominal, truth, 1, silent);
  const Artefact granite = planes(4);
  const Artefact bar = seats(500.0);
  read_planes(session, granite, "1", 30);
  read_seats(session, bar, "1", 12);
  const auto bound = test::bind(session.recording(), {granite, bar});
  EXPECT_EQ(bound.constraints.unknown_count(), 4 * 3 + 6);
  const Identification result = test::identified(bound, stated_noise());
  EXPECT_EQ(result.coupling.rank, 21);
  expect_truth(result, truth);
  EXPECT_LT(result.after.overall.maximum, 1e-7);
}

TEST(Planes, AloneTheyAreRefused) {
  const Arm nominal = nominal_arm();
  Session session(nominal, true_arm(2, nominal), 2, silent);
  const Artefact granite = planes(4);
  read_planes(session, granite, "1", 40);
  const auto bound = test::bind(session.recording(), {granite});
  const auto result = identify(bound.recording, bound.constraints, stated_noise());
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("no calibrated length"));
}

// Three readings make a plane, two or a row of them do not.
TEST(Planes, ReadingsOnALineAreRefusedByName) {
  const Arm nominal = nominal_arm();
  Session session(nominal, nominal, 3, silent);
  const Artefact granite = planes(1);
  const Rigid pose = session.pose();
  session.read("planes", "here", "0", 5,
               [&](int i) { return Eigen::Vector3d(pose * Eigen::Vector3d(20.0 * i, 0, 0)); });
  const auto bound = test::bind(session.recording(), {granite});
  const auto result = identify(bound.recording, bound.constraints, stated_noise());
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("feature \"0\" of artefact \"planes\" in placement \"here\""));
  EXPECT_THAT(result.error().message, HasSubstr("not on a line"));
}

// Two tips of different size on one plane lie on different heights over it: on which side, the readings say.
TEST(Planes, TipsOfTwoSizesAgreeOnTheSide) {
  Arm nominal = nominal_arm(4.0);
  nominal.probes.front().name = "large";
  nominal.probes.push_back(nominal.probes.front());
  nominal.probes.back().name = "small";
  nominal.probes.back().radius = 1.0;
  nominal.probes.back().tip_in_last.z() = 120.0;
  const Arm truth = true_arm(4, nominal);
  Session session(nominal, truth, 4, silent);
  const Artefact granite = planes(2);
  const Artefact bar = seats(500.0);
  for (const auto& feature : granite.features) {
    const Rigid pose = session.pose();
    for (const int probe : {0, 1}) {
      session.read_plane("planes", "1", feature.name, 30, pose.translation, pose.rotation.col(2), 400.0, probe);
    }
  }
  read_seats(session, bar, "1", 20);
  read_seats(session, bar, "2", 20);
  expect_truth(test::identified(test::bind(session.recording(), {granite, bar}), stated_noise()), truth);
}

// A reading off its plane or ball is listed, and placements of all kinds are left out in turn.
TEST(Planes, OutliersAreListedAndPlacementsLeftOut) {
  const Arm nominal = nominal_arm();
  const Arm truth = true_arm(15, nominal);
  Session session(nominal, truth, 15);
  const Artefact granite = planes(2);
  const Artefact bar = seats(500.0);
  for (const char* placement : {"a", "b"}) {
    read_planes(session, granite, placement, 30);
    read_seats(session, bar, placement, 15);
  }
  session.recording().joints.col(7).array() += 0.002;  // on a plane
  const auto bound = test::bind(session.recording(), {granite, bar});
  const Identification result = test::identified(bound, {});
  ASSERT_FALSE(result.outliers.empty());
  EXPECT_EQ(result.outliers.front().reading, 7);
  EXPECT_EQ(result.outliers.front().name.artefact, "planes");
  EXPECT_EQ(result.left_out.size(), 4u);
  for (const LeftOut& left : result.left_out) EXPECT_EQ(left.refusal, "");
}

// Three certified faces that meet in a corner have a pose; two of them do not.
TEST(Planes, OfACornerTheirPoseIsFound) {
  const Arm nominal = nominal_arm();
  const Arm truth = true_arm(14, nominal);
  Session session(nominal, truth, 14, silent);
  Artefact corner = planes(3);
  for (int i = 0; i < 3; ++i) {
    corner.features[i].at =
        100.0 * (Eigen::Vector3d::Ones() - Eigen::Vector3d::Unit(i)) + 5.0 * Eigen::Vector3d::Unit(i);
    corner.features[i].normal = Eigen::Vector3d::Unit(i);
  }
  const Artefact bar = seats(500.0);
  for (const char* placement : {"a", "b", "c"}) {
    const Rigid pose = session.pose();
    for (int i = 0; i < 3; ++i) {
      session.read_plane("planes", placement, std::to_string(i), 15, pose * *corner.features[i].at,
                         pose.rotation.col(i), 90.0);
    }
    read_seats(session, bar, placement, 12);
  }
  const auto bound = test::bind(session.recording(), {corner, bar});
  EXPECT_EQ(bound.constraints.groups[0].size, 6);
  expect_truth(test::identified(bound, stated_noise()), truth);
  std::vector<bool> drop;
  for (const auto& feature : bound.constraints.features) drop.push_back(feature.artefact == 0 && feature.feature == 2);
  const auto result = identify(bound.recording, without_features(bound.constraints, drop), stated_noise());
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("the pose of the artefact"));
}

/// A block with two faces that look away from each other; certified by their distance or by their coordinates.
struct Gauge {
  Artefact artefact;
  std::vector<double> heights, facings;
};

Gauge gauge_of(const std::vector<double>& heights, const std::vector<double>& facings, bool with_coordinates) {
  Gauge gauge{{}, heights, facings};
  gauge.artefact.name = "gauge";
  for (std::size_t i = 0; i < heights.size(); ++i) {
    gauge.artefact.features.push_back(feature_of(std::to_string(i), FeatureKind::Plane));
    if (with_coordinates) {
      gauge.artefact.features.back().at = Eigen::Vector3d(0.0, heights[i], 7.0);
      gauge.artefact.features.back().normal = facings[i] * Eigen::Vector3d::UnitY();
      gauge.artefact.features.back().u_at = 0.0002;
    } else if (i > 0) {
      gauge.artefact.distances.push_back({0, static_cast<int>(i), std::abs(heights[i] - heights[0]), 0.0002});
    }
  }
  return gauge;
}

void read_gauge(Session& session, const Gauge& gauge, const std::string& placement, int readings) {
  const Rigid pose = session.pose();
  for (std::size_t i = 0; i < gauge.heights.size(); ++i) {
    session.read_plane("gauge", placement, std::to_string(i), readings,
                       pose * Eigen::Vector3d(0.0, gauge.heights[i], 7.0), gauge.facings[i] * pose.rotation.col(1),
                       15.0);
  }
}

class Gauges : public ::testing::TestWithParam<bool> {};

// A gauge block, a gap, and steps that look the same way: the tip's radius on the proper side of each face.
TEST_P(Gauges, BringBackTheTruth) {
  for (const std::vector<double>& facings :
       {std::vector<double>{-1.0, 1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0, -1.0, 1.0, -1.0}}) {
    const Arm nominal =
        nominal_arm(GetParam() ? 3.0 : 20.0);  // without normals the tip must be larger than the arm is off
    const Arm truth = true_arm(5, nominal);
    Session session(nominal, truth, 5, silent);
    const Gauge gauge = gauge_of(
        facings.size() == 2 ? std::vector<double>{0.0, 500.0} : std::vector<double>{0.0, 100.0, 200.0, 300.0, 400.0},
        facings, GetParam());
    for (const char* placement : {"a", "b", "c", "d", "e", "f", "g", "h"}) read_gauge(session, gauge, placement, 8);
    const auto bound = test::bind(session.recording(), {gauge.artefact});
    EXPECT_EQ(bound.constraints.groups.size(), 8u);
    EXPECT_EQ(bound.constraints.groups[0].size, GetParam() ? 3 : 2 + static_cast<int>(facings.size()));
    const Identification result = test::identified(bound, stated_noise());
    EXPECT_EQ(result.coupling.rank, 21);
    EXPECT_NE(result.coupling.scale, ScaleState::Unidentifiable);
    expect_truth(result, truth, 1e-5, 1e-8);
    for (const LengthDeviation& length : result.after.lengths) EXPECT_NEAR(length.error, 0.0, 1e-6);
  }
}

// A wedge: its faces stand 0.2 degrees apart, and are read far from where they would meet. Taken for parallel, each
// normal is 0.1 degrees off, and the arm with it.
TEST(Gauge, FacesOfAWedgeKeepTheirCertifiedNormals) {
  const Arm nominal = nominal_arm();
  const Arm truth = true_arm(21, nominal);
  Session session(nominal, truth, 21, silent);
  const double angle = 0.2 * std::numbers::pi / 180.0;
  Artefact wedge = planes(2);
  wedge.features[0].at = Eigen::Vector3d(0.0, 0.0, 0.0);
  wedge.features[0].normal = -Eigen::Vector3d::UnitY();
  wedge.features[1].at = Eigen::Vector3d(0.0, 40.0, 0.0);
  wedge.features[1].normal = Eigen::Vector3d(std::sin(angle), std::cos(angle), 0.0);
  const Artefact bar = seats(500.0);
  for (const char* placement : {"a", "b", "c", "d"}) {
    const Rigid pose = session.pose();
    for (const CertifiedFeature& face : wedge.features) {
      session.read_plane("planes", placement, face.name, 15, pose * *face.at, pose.rotation * *face.normal, 120.0);
    }
    read_seats(session, bar, placement, 12);
  }
  const auto bound = test::bind(session.recording(), {wedge, bar});
  expect_truth(test::identified(bound, stated_noise()), truth);
}

// Faces that look different ways tell the tip's radius, faces that look the same way do not.
TEST_P(Gauges, TellTheTipsRadiusWhereTheyFaceBothWays) {
  Arm nominal = nominal_arm(3.0);
  Arm truth = true_arm(6, nominal);
  truth.probes.front().radius = 3.05;
  for (const double last : {1.0, -1.0}) {
    Session session(nominal, truth, 6, silent);
    const Gauge gauge = gauge_of({0.0, 250.0, 500.0}, {-1.0, -1.0, last}, GetParam());
    for (const char* placement : {"a", "b", "c", "d", "e", "f", "g", "h"}) read_gauge(session, gauge, placement, 10);
    const auto bound = test::bind(session.recording(), {gauge.artefact});
    IdentifyOptions options = stated_noise();
    options.free = {"radius"};
    const auto result = identify(bound.recording, bound.constraints, options);
    if (last < 0.0) {
      ASSERT_FALSE(result);
      EXPECT_THAT(result.error().message,
                  HasSubstr("radius was asked to be free, but these readings cannot determine it"));
      continue;
    }
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_NEAR(result->arm.probes.front().radius, 3.05, 1e-6);
    EXPECT_EQ(result->parameters.back().parameter.name, "radius");
    EXPECT_EQ(result->parameters.back().state, ParameterState::Identified);
  }
}

INSTANTIATE_TEST_SUITE_P(ByDistancesAndByCoordinates, Gauges, ::testing::Bool());

// An arm that misses a certified distance by as much as the tip is large does not show which side is meant.
TEST(Gauge, AnArmTooFarOffIsRefusedUnlessTheCertificateSaysTheSides) {
  const Arm nominal = nominal_arm(1.0);
  Arm truth = nominal;
  truth.joints[2].d += 20.0;
  Session session(nominal, truth, 7, silent);
  const Gauge gauge = gauge_of({0.0, 500.0}, {-1.0, 1.0}, false);
  for (const char* placement : {"a", "b", "c", "d", "e", "f", "g", "h"}) read_gauge(session, gauge, placement, 10);
  const auto bound = test::bind(session.recording(), {gauge.artefact});
  const auto result = identify(bound.recording, bound.constraints, stated_noise());
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("state `at` and `normal` of the planes"));
}

/// A bar of balls in several placements.
struct BallBar {
  Artefact artefact;
  std::vector<double> places, radii;
};

BallBar bar_of(bool with_radii, bool with_distances) {
  BallBar bar{{}, {0.0, 250.0, 600.0}, {12.7, 10.0, 15.0}};
  bar.artefact.name = "bar";
  for (std::size_t i = 0; i < bar.places.size(); ++i) {
    bar.artefact.features.push_back(feature_of(std::to_string(i), FeatureKind::Sphere));
    if (with_radii) bar.artefact.features.back().radius = bar.radii[i];
    if (i > 0 && with_distances) {
      bar.artefact.distances.push_back({0, static_cast<int>(i), bar.places[i], 0.0002});
    }
  }
  return bar;
}

void read_bar(Session& session, const BallBar& bar, int placements, int readings) {
  for (int p = 0; p < placements; ++p) {
    const Rigid pose = session.pose();
    for (std::size_t i = 0; i < bar.places.size(); ++i) {
      session.read_ball("bar", std::to_string(p), std::to_string(i), readings,
                        pose * Eigen::Vector3d(bar.places[i], 0.0, 0.0), bar.radii[i], pose.rotation.col(2));
    }
  }
}

// The ball is the same in every placement: one unknown each, not one a placement.
TEST(UnknownRadius, BallsOfABarBringBackTheTruthAndTheirSize) {
  const Arm nominal = nominal_arm();
  const Arm truth = true_arm(8, nominal);
  Session session(nominal, truth, 8, silent);
  const BallBar bar = bar_of(false, true);
  read_bar(session, bar, 6, 12);
  const auto bound = test::bind(session.recording(), {bar.artefact});
  EXPECT_EQ(bound.constraints.shared.size(), 3u);
  EXPECT_EQ(bound.constraints.unknown_count(), 6 * 9 + 3);
  const Identification result = test::identified(bound, stated_noise());
  EXPECT_EQ(result.coupling.rank, 21);
  expect_truth(result, truth);
  ASSERT_EQ(result.artefact_values.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(result.artefact_values[i].found, bar.radii[i], 1e-6);
}

// With next to no noise all that is left of the size of a ball is the scale that the bar gives: its relative u, times
// the ball's and the tip's radius, in however many placements.
TEST(UnknownRadius, HasTheErrorOfTheOneCertificateInAllPlacements) {
  const Arm nominal = nominal_arm();
  Session session(nominal, true_arm(8, nominal), 8, silent);
  BallBar bar = bar_of(false, true);
  bar.places.pop_back();
  bar.artefact.features.pop_back();
  bar.artefact.distances.pop_back();
  bar.artefact.distances.front().u = 0.02;
  read_bar(session, bar, 6, 12);
  const auto bound = test::bind(session.recording(), {bar.artefact});
  const Identification result = test::identified(bound, stated_noise(1e-6));
  ASSERT_EQ(result.artefact_values.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const double expected = (bar.radii[i] + nominal.probes.front().radius) * 0.02 / bar.places[1];
    EXPECT_NEAR(result.artefact_values[i].u / result.scale_factor, expected, 0.02 * expected);
  }
}

TEST(UnknownRadius, WithoutALengthTheScaleIsLost) {
  const Arm nominal = nominal_arm();
  Session session(nominal, true_arm(9, nominal), 9, silent);
  const BallBar bar = bar_of(false, false);
  read_bar(session, bar, 6, 12);
  const auto bound = test::bind(session.recording(), {bar.artefact});
  const auto result = identify(bound.recording, bound.constraints, stated_noise());
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("no calibrated length"));
}

TEST(TipRadius, ComesBackFromBallsOfKnownSizeAndStaysOtherwise) {
  const Arm nominal = nominal_arm(3.0);
  Arm truth = true_arm(10, nominal);
  truth.probes.front().radius = 2.95;
  Session session(nominal, truth, 10, silent);
  const BallBar bar = bar_of(true, true);
  read_bar(session, bar, 6, 12);
  const auto bound = test::bind(session.recording(), {bar.artefact});
  IdentifyOptions options = stated_noise();
  options.free = {"radius"};
  const Identification result = test::identified(bound, options);
  expect_truth(result, truth);
  EXPECT_NEAR(result.arm.probes.front().radius, 2.95, 1e-7);
  // Not asked for, it is no parameter and stays; the readings do not fit.
  options.free = {};
  const Identification fixed = test::identified(bound, options);
  EXPECT_EQ(fixed.arm.probes.front().radius, 3.0);
  EXPECT_EQ(fixed.parameters.size(), 25u);
  EXPECT_GT(fixed.scale_factor, 1.5);
}

// Only the sum of the two radii is seen, and that is said.
TEST(TipRadius, WithBallsOfUnknownSizeCannotBeTold) {
  const Arm nominal = nominal_arm();
  Session session(nominal, true_arm(11, nominal), 11, silent);
  const BallBar bar = bar_of(false, true);
  read_bar(session, bar, 6, 12);
  const auto bound = test::bind(session.recording(), {bar.artefact});
  IdentifyOptions options = stated_noise();
  options.free = {"radius"};
  const auto result = identify(bound.recording, bound.constraints, options);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, HasSubstr("only its sum with the unknown radius of a ball"));
}

/// A plate whose certified coordinates are off by as much as its certificate says, in six placements.
test::Bound plate_with_errors(std::uint64_t seed, const Arm& nominal, const Arm& truth, double u_at,
                              FeatureKind kind = FeatureKind::Sphere) {
  RandomStream random(seed, "plate");
  Artefact plate;
  plate.name = "plate";
  Session session(nominal, truth, seed, {0.0, 0.003});
  std::vector<Eigen::Vector3d> places;
  for (int i = 0; i < 9; ++i) {
    plate.features.push_back(feature_of(std::to_string(i), kind));
    places.emplace_back(150.0 * (i % 3), 150.0 * (i / 3), 0.0);
    plate.features.back().radius = 12.7;
    plate.features.back().u_at = u_at;
    plate.features.back().at = places.back() + u_at * normal_vector(random);
  }
  for (int p = 0; p < 5; ++p) {
    const Rigid pose = session.pose();
    for (int i = 0; i < 9; ++i) {
      if (kind == FeatureKind::Sphere) {
        session.read_ball("plate", std::to_string(p), std::to_string(i), 6, pose * places[i], 12.7,
                          pose.rotation.col(2));
      } else {
        session.read("plate", std::to_string(p), std::to_string(i), 6, [&](int) { return pose * places[i]; });
      }
    }
  }
  return test::bind(session.recording(), {plate});
}

// The error of a certified coordinate is the same in all readings of its ball and in all placements. Taken for
// exact, the plate contradicts readings of 3 µm; with its own u the fit is sound and the arm is better.
TEST(CertifiedCoordinates, CountByTheirOwnUncertainty) {
  const Arm nominal = nominal_arm();
  double squares = 0.0;
  double squares_exact = 0.0;
  double chi_squared = 0.0;
  int degrees_of_freedom = 0;
  double deviations = 0.0;
  int parameters = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Arm truth = true_arm(seed, nominal);
    test::Bound bound = plate_with_errors(seed, nominal, truth, 0.02);
    EXPECT_EQ(bound.constraints.shared.size(), 27u);
    const Identification result = test::identified(bound, stated_noise(0.003));
    EXPECT_EQ(result.coupling.rank, 21);
    squares += std::pow(testing::length_rms(truth, result.arm), 2);
    chi_squared += result.chi_squared;
    degrees_of_freedom += result.degrees_of_freedom;
    Eigen::VectorXd deviation(static_cast<Eigen::Index>(result.free.size()));
    for (Eigen::Index i = 0; i < deviation.size(); ++i) {
      const auto& parameter = result.parameters[result.free[i]];
      deviation[i] = parameter.identified - value(truth, parameter.parameter);
    }
    deviations += result.scale_factor * result.scale_factor * deviation.dot(result.covariance.ldlt().solve(deviation));
    parameters += static_cast<int>(deviation.size());
    for (auto& feature : bound.constraints.artefacts[0].features) feature.u_at = 0.0;
    bound = test::bind(bound.recording, bound.constraints.artefacts);
    const Identification exact = test::identified(bound, stated_noise(0.003));
    EXPECT_GT(exact.scale_factor, 2.0);
    squares_exact += std::pow(testing::length_rms(truth, exact.arm), 2);
  }
  RecordProperty("length rms with u, without (um)", std::to_string(1000 * std::sqrt(squares / 6)) + ", " +
                                                        std::to_string(1000 * std::sqrt(squares_exact / 6)));
  EXPECT_NEAR(chi_squared / degrees_of_freedom, 1.0, 4 * std::sqrt(2.0 / degrees_of_freedom));
  // The stated uncertainties hold the true deviations: χ² of 126 numbers within 4 standard deviations.
  EXPECT_NEAR(deviations / parameters, 1.0, 4 * std::sqrt(2.0 / parameters));
  EXPECT_LT(squares, squares_exact);
}

// A hundred readings of one ball do not make its certificate a hundred times better.
TEST(CertifiedCoordinates, TheirUncertaintyDoesNotAverageOut) {
  const Arm nominal = nominal_arm();
  const Arm truth = true_arm(12, nominal);
  test::Bound bound = plate_with_errors(12, nominal, truth, 0.02, FeatureKind::Point);
  // Much better readings of the same plate: what is left is the plate's uncertainty.
  const auto u_of_d3 = [&](double noise) {
    const Identification result = test::identified(bound, stated_noise(noise));
    for (const auto& p : result.parameters) {
      if (p.parameter.name == "d3") return p.u / result.scale_factor;
    }
    return 0.0;
  };
  const double coarse = u_of_d3(0.003);
  const double fine = u_of_d3(0.0001);
  EXPECT_GT(fine, 0.1 * coarse) << "with exact coordinates it would be a thirtieth";
}

}  // namespace
}  // namespace artcal
