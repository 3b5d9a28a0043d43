#include "identification/uncertainty/unmodelled_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "artefacts/virtual_probing/postures.h"
#include "core/random.h"
#include "core/statistics.h"
#include "identification/uncertainty/uncertain_arm.h"

namespace artcal {
namespace {

constexpr double confidence = 0.99;  // of calling a sound model wrong: one in a hundred
constexpr double coverage = 0.95;    // what Student's factor is for
constexpr double largest_scale = 1e3;
// mm; readings that agree to the last digits are no real ones, and errors beside them are rounding.
constexpr double least_real_noise = 1e-6;
constexpr int survey_postures = 200;

// Mean over a placement's predictions of (error/u)², where the arm's share of u is `scale` times as large.
double mean_square(const LeftOut& left, double scale) {
  double sum = 0.0;
  for (const CheckedPrediction& checked : left.predictions) {
    const double u = std::hypot(scale * checked.u_arm, checked.u_other);
    sum += u > 0.0 ? std::pow(checked.error / u, 2) : 0.0;
  }
  return sum / static_cast<double>(left.predictions.size());
}

double sum_over_placements(const std::vector<LeftOut>& left_out, double scale, Loss loss) {
  std::vector<double> squares;
  for (const LeftOut& left : left_out) {
    if (!left.predictions.empty()) {
      squares.push_back(mean_square(left, scale));
    }
  }
  return loss == Loss::None ? std::accumulate(squares.begin(), squares.end(), 0.0)
                            : static_cast<double>(squares.size()) * median(squares) / chi_squared_quantile(0.5, 1.0);
}

// Degrees of freedom of that sum (Satterthwaite): within a placement errors are taken for one; from placement to
// placement the error of a certified value is the same, and the more it is of u, the less does each placement add.
double effective_placements(const std::vector<LeftOut>& left_out) {
  struct Sums {
    double all = 0.0, squares = 0.0;
  };
  std::map<std::array<int, 3>, Sums> by_certified;
  double placements = 0.0;
  for (const LeftOut& left : left_out) {
    placements += left.predictions.empty() ? 0.0 : 1.0;
    std::map<std::array<int, 3>, double> own;
    for (const CheckedPrediction& checked : left.predictions) {
      const double u = std::hypot(checked.u_arm, checked.u_other);
      if (checked.certified[0] >= 0 && u > 0.0) {
        own[checked.certified] += std::pow(checked.u_certificate / u, 2) / static_cast<double>(left.predictions.size());
      }
    }
    for (const auto& [certified, share] : own) {
      by_certified[certified].all += share;
      by_certified[certified].squares += share * share;
    }
  }
  double squares = placements;
  for (const auto& [certified, sums] : by_certified) {
    squares += sums.all * sums.all - sums.squares;
  }
  return placements * placements / squares;
}

// The scale at which the sum is the number of placements; it falls with the scale.
double matching_scale(const std::vector<LeftOut>& left_out, double placements, Loss loss) {
  double low = 1.0, high = largest_scale;
  while (high / low > 1.0 + 1e-9) {
    const double middle = std::sqrt(low * high);
    (sum_over_placements(left_out, middle, loss) > placements ? low : high) = middle;
  }
  return high;
}

// So few placements do not know a scale better: Student's factor over the normal one.
double of_few(double placements) {
  return student_coverage_factor(coverage, placements) / normal_quantile(0.5 * (1.0 + coverage));
}

// The scale with which 95 % intervals hold 95 % of coordinates of these variances with that error beside them. A mean
// over the variances would not do: where they differ from posture to posture, the small ones hold too little. Those
// that the parameters hardly move count with half of the rms, so that they do not enlarge all others without
// bound.
double covering_scale(std::vector<double> variances, double error) {
  const double least =
      std::accumulate(variances.begin(), variances.end(), 0.0) / (4.0 * static_cast<double>(variances.size()));
  if (!(least > 0.0)) {
    return 1.0;
  }
  for (double& variance : variances) {
    variance = std::max(variance, least);
  }
  const auto share_held = [&](double scale) {
    double sum = 0.0;
    for (const double variance : variances) {
      const double limit = normal_quantile(0.5 * (1.0 + coverage)) * scale * std::sqrt(variance);
      sum += std::erf(limit / std::sqrt(2.0 * (variance + error * error)));
    }
    return sum / static_cast<double>(variances.size());
  };
  double low = 1.0, high = largest_scale;
  while (high / low > 1.0 + 1e-9) {
    const double middle = std::sqrt(low * high);
    (share_held(middle) < coverage ? low : high) = middle;
  }
  return high;
}

}  // namespace

CrossValidation cross_validate(const std::vector<LeftOut>& left_out, bool effects_found, Loss loss) {
  CrossValidation found;
  for (const LeftOut& left : left_out) {
    found.placements += left.predictions.empty() ? 0 : 1;
    found.predictions += static_cast<int>(left.predictions.size());
  }
  if (found.placements == 0) {
    return found;
  }
  const double placements = found.placements;
  const double sum = sum_over_placements(left_out, 1.0, loss);
  found.ratio = std::sqrt(sum / placements);
  found.effective_placements = effective_placements(left_out);
  found.limit = std::sqrt(chi_squared_quantile(confidence, found.effective_placements) / found.effective_placements);
  if (found.ratio > (effects_found ? 1.0 : found.limit)) {
    found.scale = matching_scale(left_out, placements, loss) * of_few(found.effective_placements);
  }
  return found;
}

double unmodelled_point_error(const std::vector<LeftOut>& left_out, double noise) {
  double squares = 0.0;
  int freedom = 0;
  for (const LeftOut& left : left_out) {
    if (left.refusal.empty() && left.degrees_of_freedom > 0) {
      squares += left.squares;
      freedom += left.degrees_of_freedom;
    }
  }
  return freedom > 0 ? std::sqrt(std::max(0.0, squares / freedom - noise * noise)) : 0.0;
}

void add_point_error(double error, const Identification& result, CrossValidation& found) {
  if (found.placements == 0 || !(error > 0.0) || result.free.empty()) {
    return;
  }
  UncertaintySources sources;
  for (const int index : result.free) {
    sources.parameters.push_back(result.parameters[index].parameter);
  }
  sources.covariance = result.covariance;
  const UncertainArm arm(result.arm, std::move(sources));
  RandomStream random(1, "unmodelled error");
  std::vector<double> variances;  // of coordinates
  for (int i = 0; i < survey_postures; ++i) {
    const Eigen::Vector3d of_point = arm.of_point(arm.tip(random_posture(result.arm, random))).diagonal();
    variances.insert(variances.end(), of_point.begin(), of_point.end());
  }
  found.point_error = error;
  found.scale = std::max(found.scale, covering_scale(std::move(variances), error) * of_few(found.effective_placements));
}

void enlarge_for_unmodelled_errors(const CrossValidation& found, Identification& result) {
  result.cross_validation = found;
  if (found.scale <= 1.0) {
    return;
  }
  result.covariance *= found.scale * found.scale;
  for (IdentifiedParameter& parameter : result.parameters) {
    parameter.u *= found.scale;
  }
  result.warnings.push_back(fmt::format(
      "unmodelled error: in {} placements left out, the arm identified without them is off by {:.2g} times its "
      "standard uncertainty (rms){}; the covariance and all standard uncertainties of this arm, its points and its "
      "lengths are enlarged by {:.2f} to what these placements show",
      found.placements, found.ratio,
      found.point_error > 0.0
          ? fmt::format(", and readings by {:.2g} mm a coordinate beyond the known noise", found.point_error)
          : std::string(),
      found.scale));
}

void judge_by_left_out(Loss loss, Identification& result) {
  if (!(result.noise > least_real_noise)) {
    return;
  }
  const bool effects_found = !result.model_study.findings.empty();
  CrossValidation found = cross_validate(result.left_out, effects_found, loss);
  const bool noise_exceeded =
      result.noise_is_given && result.chi_squared > chi_squared_quantile(0.999, result.degrees_of_freedom);
  if (effects_found || noise_exceeded || found.scale > 1.0) {
    // Where no noise was stated, it is what the residuals hold beside the effects that were found in them.
    const double known_noise =
        result.noise_is_given ? result.noise : result.noise * std::sqrt(result.model_study.remaining_variance);
    add_point_error(unmodelled_point_error(result.left_out, known_noise), result, found);
  }
  enlarge_for_unmodelled_errors(found, result);
}

}  // namespace artcal
