#include "artefacts/verification/b89_4_22/b89_4_22.h"
#include "artefacts/verification/decision/conclusion.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "artefacts/verification/iso10360_12/length_tests.h"
#include "artefacts/verification/iso10360_12/sphere_tests.h"
#include "artefacts/verification/measured.h"
#include "artefacts/verification/point_uncertainty.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

bool is_single_seat(const Artefact& artefact) {
  return artefact.features.size() == 1 && artefact.features.front().kind == FeatureKind::Point;
}

TestValue value_of(const Session& session, const Touched& touched, Quantity quantity, const Eigen::Vector3d& point) {
  TestValue value;
  value.quantity = quantity;
  value.artefact = session.constraints.artefacts[touched.artefact].name;
  value.placement = session.recording.placements.name(touched.placement);
  value.first = session.constraints.artefacts[touched.artefact].features[touched.feature].name;
  value.repeat = session.recording.repeats.name(touched.repeat);
  value.temperature = mean_temperature(session, touched.readings);
  value.budget.fixture = session.specification.u_fixture;
  value.place = place_of(point, session.recording, session.arm, touched.readings);
  return value;
}

void add_effective_diameter(const Session& session, const Touched& touched, Verification& verification) {
  const Artefact& artefact = session.constraints.artefacts[touched.artefact];
  const CertifiedFeature& ball = artefact.features[touched.feature];
  const auto measured = measure(session, touched);
  if (!measured || !ball.radius) {
    verification.missing.push_back("effective diameter: " +
                                   (measured ? "the ball has no calibrated diameter" : measured.error().text()));
    return;
  }
  TestValue value = value_of(session, touched, Quantity::EffectiveDiameter, measured->centre_in_base);
  value.certified = 2.0 * *ball.radius;
  value.measured = measured->diameter / expansion_factor_or_one(artefact, value.temperature);
  value.value = value.measured - value.certified;
  const double of_radius = std::sqrt(measured->cofactor(3, 3));
  value.dilution.add(measured->kind, 2.0 * of_radius, of_radius, ball.name);
  verification.scatter(measured->kind).add(measured->squares, measured->degrees_of_freedom);
  value.budget.calibration = 2.0 * ball.u_radius;
  value.budget = with_thermal(value.budget, value.certified, thermal_state(session, artefact, value.temperature));
  judge(value, session.specification);
  verification.values.push_back(value);
}

Articulation articulation_of(const Session& session, const Touched& touched, Eigen::Vector3d& mean) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(touched.readings.size()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    points.col(i) = session.tips.in_base.col(touched.readings[i]);
  }
  mean = points.rowwise().mean();
  const Eigen::VectorXd off = (points.colwise() - mean).colwise().norm();
  const Artefact& artefact = session.constraints.artefacts[touched.artefact];
  Articulation result;
  result.artefact = artefact.name;
  result.placement = session.recording.placements.name(touched.placement);
  result.feature = artefact.features[touched.feature].name;
  result.readings = static_cast<int>(points.cols());
  result.largest = off.maxCoeff();
  result.twice_s = 2.0 * std::sqrt(off.squaredNorm() / static_cast<double>(points.cols() - 1));
  result.half_range = 0.5 * (points.rowwise().maxCoeff() - points.rowwise().minCoeff());
  return result;
}

void add_articulation(const Session& session, const Touched& touched, B89Verification& result) {
  if (touched.readings.size() < 2) {
    result.verification.missing.push_back("SPAT: " + text_of(touched, session) + ": one reading shows no spread");
    return;
  }
  Eigen::Vector3d mean;
  const Articulation articulation = articulation_of(session, touched, mean);
  for (const auto& [quantity, figure] : {std::pair{Quantity::Articulation, articulation.largest},
                                         std::pair{Quantity::ArticulationSpread, articulation.twice_s}}) {
    TestValue value = value_of(session, touched, quantity, mean);
    value.value = value.measured = figure;
    judge(value, session.specification);
    result.verification.values.push_back(value);
  }
  result.articulations.push_back(articulation);
}

std::optional<VolumetricSummary> volumetric_summary(const Verification& verification) {
  std::vector<double> errors;
  for (const TestValue& value : verification.values) {
    if (value.quantity == Quantity::Volumetric) {
      errors.push_back(value.value);
    }
  }
  if (errors.empty()) {
    return std::nullopt;
  }
  const Eigen::Map<const Eigen::ArrayXd> e(errors.data(), static_cast<Eigen::Index>(errors.size()));
  const auto n = static_cast<double>(errors.size());
  VolumetricSummary summary{static_cast<int>(errors.size()), e.abs().maxCoeff(), e.maxCoeff() - e.minCoeff(),
                            2.0 * std::sqrt(e.square().sum() / n), 0.0};
  summary.twice_s = n > 1.0 ? 2.0 * std::sqrt((e - e.mean()).square().sum() / (n - 1.0)) : 0.0;
  return summary;
}

void check_plan(const Session& session, B89Verification& result) {
  auto& missing = result.verification.missing;
  if (!session.specification.plan) {
    missing.push_back("the specification has no [plan]: whether enough was measured cannot be determined");
    return;
  }
  const TestPlan& plan = *session.specification.plan;
  const auto ask = [&](int there, int wanted, const char* what) {
    if (there < wanted) {
      missing.push_back(fmt::format("{}: {} of {}", what, there, wanted));
    }
  };
  int diameters = 0;
  std::set<std::string> positions;
  for (const TestValue& value : result.verification.values) {
    diameters += value.quantity == Quantity::EffectiveDiameter ? 1 : 0;
  }
  for (const Articulation& articulation : result.articulations) {
    positions.insert(articulation.placement);
    if (articulation.readings < plan.articulation_readings) {
      report_missing(result.verification, session.specification, Evidence::DistinctPoints,
                     fmt::format("SPAT, placement {}: {} of {} readings of their own",
                                 in_quotes(articulation.placement), articulation.readings, plan.articulation_readings));
    }
  }
  ask(diameters, plan.effective_diameter_repeats, "effective diameter, times measured");
  ask(static_cast<int>(positions.size()), plan.articulation_positions, "SPAT, positions");
  ask(result.volumetric ? result.volumetric->lengths : 0, plan.volumetric_lengths, "volumetric, lengths");
}

}  // namespace

Expected<B89Verification> verify_b89_4_22(const Session& session) {
  B89Verification result;
  Verification& verification = result.verification;
  verification.standard = "b89.4.22";
  verification.rule = session.specification.rule;
  for (const Touched& touched : touched_features(session, Orientations::Together)) {
    const Artefact& artefact = session.constraints.artefacts[touched.artefact];
    if (is_single_ball(artefact)) {
      add_effective_diameter(session, touched, verification);
    } else if (is_single_seat(artefact)) {
      add_articulation(session, touched, result);
    }
  }
  add_length_tests(session, Quantity::Volumetric, verification);
  if (verification.values.empty()) {
    return no_solution(
        "nothing of ASME B89.4.22 can be evaluated: " +
        (verification.missing.empty()
             ? "there is neither a single ball, nor a single seat, nor a certified length with both ends read"
             : verification.missing.front()));
  }
  add_point_uncertainties(session, verification);
  result.volumetric = volumetric_summary(verification);
  check_plan(session, result);
  check_and_conclude(session, verification);
  return result;
}

}  // namespace artcal
