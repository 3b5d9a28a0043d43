#include "artefacts/verification/sphere_plate/sphere_plate.h"
#include "artefacts/verification/decision/conclusion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "artefacts/verification/iso10360_12/length_tests.h"
#include "artefacts/verification/measured.h"
#include "artefacts/verification/point_uncertainty.h"
#include "artefacts/verification/sphere_plate/ball_outliers.h"
#include "artefacts/verification/sphere_plate/rigid_fit.h"
#include "core/statistics.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

using Key = std::tuple<int, int, int>;  // artefact, placement, repeat

constexpr std::size_t swing_round_placements = 4;

/// Measured centres of a plate beside the certified ones, at the reference temperature.
struct BallPattern {
  std::vector<int> features;
  Eigen::Matrix3Xd measured, certified, others;
};

bool is_plate(const Artefact& artefact) {
  return std::count_if(artefact.features.begin(), artefact.features.end(),
                       [](const CertifiedFeature& feature) { return feature.at.has_value(); }) >= 3;
}

BallPattern pattern_of(const Artefact& artefact, const std::map<int, MeasuredPoint>& balls, double temperature) {
  BallPattern pattern;
  std::vector<Eigen::Vector3d> measured, certified, others;
  const double factor = expansion_factor_or_one(artefact, temperature);
  for (int f = 0; f < static_cast<int>(artefact.features.size()); ++f) {
    const auto& at = artefact.features[f].at;
    if (const auto ball = balls.find(f); at && ball != balls.end()) {
      pattern.features.push_back(f);
      measured.emplace_back(ball->second.centre_in_base / factor);
      certified.push_back(*at);
    } else if (at) {
      others.push_back(*at);
    }
  }
  const auto matrix = [](const std::vector<Eigen::Vector3d>& points) {
    Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) {
      columns.col(static_cast<Eigen::Index>(i)) = points[i];
    }
    return columns;
  };
  pattern.measured = matrix(measured);
  pattern.certified = matrix(certified);
  pattern.others = matrix(others);
  return pattern;
}

double u_of_scale(const Session& session, const Artefact& artefact, const BallPattern& pattern, const RigidFit& fit,
                  double scatter, double temperature) {
  double u_at = 0.0;
  for (const int f : pattern.features) {
    u_at = std::max(u_at, artefact.features[f].u_at);
  }
  const ThermalState thermal = thermal_state(session, artefact, temperature);
  const Budget per_length = with_thermal({}, 1.0, thermal);
  return std::hypot(std::hypot(scatter, u_at) / std::sqrt(fit.spread), per_length.total());
}

// Of a combined u, of which `scatter` was estimated with `freedom` degrees of freedom.
double coverage_factor_of(double scatter, double freedom, double u) {
  const std::array<UncertaintyComponent, 2> components{
      {{scatter, freedom}, {std::sqrt(std::max(0.0, u * u - scatter * scatter))}}};
  return stated_coverage_factor(effective_degrees_of_freedom(components));
}

std::string names_of(const Artefact& artefact, const BallPattern& pattern, const std::vector<int>& which) {
  std::string text;
  for (const int i : which) {
    text += (text.empty() ? "" : ", ") + artefact.features[pattern.features[i]].name;
  }
  return truncated(120, text);
}

// Names of certified balls in the order that PatternFinding counts them: the measured ones, then the others.
std::vector<int> counted(const Artefact& artefact, const BallPattern& pattern) {
  std::vector<int> features = pattern.features;
  for (int f = 0; f < static_cast<int>(artefact.features.size()); ++f) {
    const bool is_measured = std::find(pattern.features.begin(), pattern.features.end(), f) != pattern.features.end();
    if (artefact.features[f].at && !is_measured) {
      features.push_back(f);
    }
  }
  return features;
}

std::string swaps_of(const Artefact& artefact, const BallPattern& pattern, const std::vector<int>& order) {
  const auto features = counted(artefact, pattern);
  std::string text;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i] != static_cast<int>(i)) {
      text += fmt::format("{}{} is {}", text.empty() ? "" : ", ", artefact.features[features[i]].name,
                          artefact.features[features[order[i]]].name);
    }
  }
  return truncated(160, text);
}

std::string text_of(const PatternFinding& finding, const Artefact& artefact, const BallPattern& pattern) {
  const std::string rms = fmt::format("{:.4g} mm rms instead of {:.4g}", finding.rms_found, finding.rms_as_named);
  switch (finding.kind) {
    case PatternFinding::Kind::Mirrored:
      return finding.order.empty()
                 ? fmt::format("the plate is mirrored: its mirror image fits with {}; look at the certificate's axes",
                               rms)
                 : fmt::format("the plate's numbering is mirrored ({}): {}", rms,
                               swaps_of(artefact, pattern, finding.order));
    case PatternFinding::Kind::TwoPoses:
      return fmt::format("two poses under one placement name: the balls {} fit another pose than the rest ({})",
                         names_of(artefact, pattern, finding.second), rms);
    case PatternFinding::Kind::OtherOrder: break;
  }
  return fmt::format("the balls were measured in another order ({}): {}", rms,
                     swaps_of(artefact, pattern, finding.order));
}

// What the plate itself is like, by all its complete placements; the first repeat of each stands for it.
void add_calibration(const Artefact& artefact, const std::vector<BallPattern>& patterns, PlateVerification& result) {
  std::vector<Eigen::Matrix3Xd> measured;
  Eigen::Matrix3Xd certified;
  for (const BallPattern& pattern : patterns) {
    if (pattern.others.cols() == 0) {
      measured.push_back(pattern.measured);
      certified = pattern.certified;
    }
  }
  if (measured.size() < swing_round_placements) {
    return;
  }
  if (auto calibration = mean_shape(measured, certified)) {
    calibration->artefact = artefact.name;
    for (const CertifiedFeature& feature : artefact.features) {
      if (feature.at) {
        calibration->features.push_back(feature.name);
      }
    }
    result.calibrations.push_back(std::move(*calibration));
  }
}

Expected<PlatePlacement> evaluate(const Session& session, const Artefact& artefact, const BallPattern& pattern,
                                  double temperature) {
  const auto fit = fit_rigid(pattern.measured, pattern.certified);
  if (!fit) {
    return tl::unexpected(fit.error());
  }
  PlatePlacement plate;
  plate.artefact = artefact.name;
  plate.temperature = temperature;
  plate.rms = fit->rms;
  plate.scale = fit->scale;
  const Eigen::Index n = pattern.measured.cols();
  // A scale error is no scatter: what it explains is taken out before the scatter is judged.
  const double explained = fit->scale * fit->scale * fit->spread;
  const double squares = std::max(0.0, fit->residuals.squaredNorm() - explained);
  const double scatter = 3 * n > 7 ? std::sqrt(squares / static_cast<double>(3 * n - 7)) : 0.0;
  plate.u_scale = u_of_scale(session, artefact, pattern, *fit, scatter, temperature);
  const double freedom = static_cast<double>(std::max<Eigen::Index>(1, 3 * n - 7));
  plate.k_scale = coverage_factor_of(scatter / std::sqrt(fit->spread), freedom, plate.u_scale);
  const BallOutlierTest studentised = studentised_residuals(pattern.measured, pattern.certified);
  plate.limit = studentised.limit;
  for (Eigen::Index i = 0; i < n; ++i) {
    plate.balls.push_back({artefact.features[pattern.features[i]].name,
                           fit->to_from.rotation.transpose() * fit->residuals.col(i), studentised.distances(i),
                           studentised.limit > 0.0 && studentised.distances(i) > studentised.limit});
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = i + 1; j < n; ++j) {
      const CertifiedFeature& a = artefact.features[pattern.features[i]];
      const CertifiedFeature& b = artefact.features[pattern.features[j]];
      const double error = (pattern.measured.col(i) - pattern.measured.col(j)).norm() -
                           (pattern.certified.col(i) - pattern.certified.col(j)).norm();
      const double u = std::hypot(std::sqrt(2.0) * scatter, std::hypot(a.u_at, b.u_at));
      const double U = coverage_factor_of(std::sqrt(2.0) * scatter, freedom, u) * u;
      plate.en_worst = std::max(plate.en_worst, U > 0.0 ? std::abs(error) / U : 0.0);
    }
  }
  for (int f = 0; f < static_cast<int>(artefact.features.size()); ++f) {
    const bool is_measured = std::find(pattern.features.begin(), pattern.features.end(), f) != pattern.features.end();
    if (artefact.features[f].at && !is_measured) {
      plate.not_measured.push_back(artefact.features[f].name);
    }
  }
  if (const auto finding = find_misnaming(pattern.measured, pattern.certified, pattern.others)) {
    plate.finding = text_of(*finding, artefact, pattern);
  }
  return plate;
}

void tell(const PlatePlacement& plate, Verification& verification) {
  const std::string where =
      fmt::format("artefact {}, placement {}{}", in_quotes(plate.artefact), in_quotes(plate.placement),
                  plate.repeat.empty() ? "" : ", repeat " + in_quotes(plate.repeat));
  if (!plate.finding.empty()) {
    verification.missing.push_back(where + ": " + plate.finding);
    return;
  }
  for (const BallResidual& ball : plate.balls) {
    if (ball.is_outlier) {
      verification.warnings.push_back(fmt::format(
          "{}: ball {} is off by {:.1f} um where the others are off by {:.1f} um rms: moved, dirty, or wrong on the "
          "certificate",
          where, in_quotes(ball.feature), 1e3 * ball.residual_in_plate.norm(), 1e3 * plate.rms));
    }
  }
  if (!plate.not_measured.empty()) {
    std::string names;
    for (const auto& name : plate.not_measured) {
      names += (names.empty() ? "" : ", ") + name;
    }
    verification.missing.push_back(fmt::format("{}: not measured: {}", where, truncated(120, names)));
  }
}

// Lengths between balls that were misnamed say nothing of the arm.
void judge_no_misnamed(const std::vector<PlatePlacement>& placements, Verification& verification) {
  for (const PlatePlacement& plate : placements) {
    for (TestValue& value : verification.values) {
      if (!plate.finding.empty() && value.artefact == plate.artefact && value.placement == plate.placement &&
          value.repeat == plate.repeat) {
        value.verdict = Verdict::NotJudged;
      }
    }
  }
}

}  // namespace

Expected<PlateVerification> verify_sphere_plate(const Session& session) {
  PlateVerification result;
  Verification& verification = result.verification;
  verification.standard = "sphere-plate";
  verification.rule = session.specification.rule;
  std::map<Key, std::map<int, MeasuredPoint>> placements;
  std::map<Key, std::vector<int>> readings;
  std::vector<Key> order;
  for (const Touched& touched : touched_features(session, Orientations::Together)) {
    if (!is_plate(session.constraints.artefacts[touched.artefact])) {
      continue;
    }
    const Key key{touched.artefact, touched.placement, touched.repeat};
    if (!placements.contains(key)) {
      order.push_back(key);
      placements[key];
    }
    auto& all = readings[key];
    all.insert(all.end(), touched.readings.begin(), touched.readings.end());
    if (const auto measured = measure(session, touched)) {
      placements[key].emplace(touched.feature, *measured);
    } else {
      verification.missing.push_back(measured.error().text());
    }
  }
  std::map<int, std::vector<BallPattern>> patterns;  // by artefact
  for (const Key& key : order) {
    const auto& [artefact, placement, repeat] = key;
    const double temperature = mean_temperature(session, readings[key]);
    const BallPattern pattern = pattern_of(session.constraints.artefacts[artefact], placements[key], temperature);
    auto plate = evaluate(session, session.constraints.artefacts[artefact], pattern, temperature);
    const std::string& name = session.recording.placements.name(placement);
    if (!plate) {
      verification.missing.push_back(fmt::format("placement {}: {}", in_quotes(name), plate.error().message));
      continue;
    }
    plate->placement = name;
    plate->repeat = session.recording.repeats.name(repeat);
    tell(*plate, verification);
    const bool is_new = std::none_of(
        result.placements.begin(), result.placements.end(),
        [&](const PlatePlacement& other) { return other.artefact == plate->artefact && other.placement == name; });
    if (is_new && plate->finding.empty()) {
      patterns[artefact].push_back(pattern);
    }
    result.placements.push_back(std::move(*plate));
  }
  if (result.placements.empty()) {
    return no_solution("no sphere plate can be evaluated: " +
                       (verification.missing.empty()
                            ? "no artefact has three or more features with certified coordinates"
                            : verification.missing.front()));
  }
  for (const auto& [artefact, all] : patterns) {
    add_calibration(session.constraints.artefacts[artefact], all, result);
  }
  add_length_tests(session, Quantity::LengthUni, verification);
  add_point_uncertainties(session, verification);
  judge_no_misnamed(result.placements, verification);
  check_and_conclude(session, verification);
  return result;
}

}  // namespace artcal
