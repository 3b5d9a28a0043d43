#include "identification/evaluation/feature_plausibility.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/statistics.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr double unusual = 5.0;  // times the median
// How often one of the features or distances of a sound recording may stand out, however many there are (Bonferroni).
constexpr double false_alarms = 0.001;
// Standard uncertainties by which a certified length may be off before it must be another length.
constexpr double beyond_certificate = 10.0;
// Unknowns that the readings of a ball, a point or a plane settle at most.
constexpr int own_unknowns = 3;
constexpr double smallest = 1e-300;       // of exact readings
constexpr double gross_difference = 0.1;  // of a length, in proportion

/// How large something is, and how large for chance.
struct Size {
  double millimetres = 0.0;
  double multiple = 0.0;  ///< of what is expected of it; half of a sound recording's are below 1
  double limit = 0.0;     ///< of the multiple, which the worst of a sound recording hardly exceeds
};

// The largest multiple of all that exceed `far_off`, what is usual and their limit; nothing where none does.
std::optional<std::size_t> standing_out(const std::vector<Size>& sizes, double far_off) {
  if (sizes.empty()) {
    return std::nullopt;
  }
  std::vector<double> millimetres, multiples;
  for (const Size& size : sizes) {
    millimetres.push_back(size.millimetres);
    multiples.push_back(size.multiple);
  }
  const double usual_size = median(millimetres);
  const double usual_multiple = std::max(1.0, median(multiples));
  std::optional<std::size_t> worst;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (sizes[i].millimetres > std::max(far_off, unusual * usual_size) &&
        sizes[i].multiple > std::max(unusual, sizes[i].limit) * usual_multiple &&
        (!worst || sizes[i].multiple > sizes[*worst].multiple)) {
      worst = i;
    }
  }
  return worst;
}

/// Quantiles of chi-squared; features have as many readings as each other as a rule.
class Quantiles {
 public:
  double operator()(double probability, double freedom) {
    const auto [known, is_new] = known_.try_emplace({probability, freedom}, 0.0);
    if (is_new) {
      known->second = chi_squared_quantile(probability, freedom);
    }
    return known->second;
  }

 private:
  std::map<std::pair<double, double>, double> known_;
};

double spare_readings(const FeatureDeviation& feature) { return std::max(1, feature.readings - own_unknowns); }

// The standard deviation of a reading by the median of the features: n·rms² is σ²χ² with the readings to spare.
double usual_deviation(const std::vector<FeatureDeviation>& features) {
  Quantiles quantile;
  std::vector<double> deviations;
  for (const FeatureDeviation& feature : features) {
    deviations.push_back(feature.rms * std::sqrt(feature.readings / quantile(0.5, spare_readings(feature))));
  }
  return deviations.empty() ? 0.0 : median(deviations);
}

Size size_of(const FeatureDeviation& feature, double sigma, std::size_t count, Quantiles& quantile) {
  const double middle = quantile(0.5, spare_readings(feature));
  const double most = quantile(1.0 - false_alarms / static_cast<double>(count), spare_readings(feature));
  return {feature.rms, feature.rms * std::sqrt(feature.readings / middle) / std::max(sigma, smallest),
          std::sqrt(most / middle)};
}

// Of a length that is known to millimetres only, millimetres say nothing.
Size size_of(const LengthDeviation& length, double sigma, std::size_t count, Quantiles& /*quantile*/) {
  const double error = std::abs(length.error);
  if (error <= beyond_certificate * length.u) {
    return {};
  }
  const double u = std::max(std::hypot(length.u, sigma * length.gain), smallest);
  return {error, sigma_per_median() * error / u,
          sigma_per_median() * normal_quantile(1.0 - 0.5 * false_alarms / static_cast<double>(count))};
}

template <typename Deviation>
const Deviation* standing_out(const std::vector<Deviation>& deviations, double sigma, double far_off) {
  Quantiles quantile;
  std::vector<Size> sizes;
  for (const Deviation& deviation : deviations) {
    sizes.push_back(size_of(deviation, sigma, deviations.size(), quantile));
  }
  const auto worst = standing_out(sizes, far_off);
  return worst ? &deviations[*worst] : nullptr;
}

}  // namespace

std::optional<std::string> implausible_feature(const Evaluation& evaluation, double far_off) {
  const auto* feature = standing_out(evaluation.features, usual_deviation(evaluation.features), far_off);
  if (feature == nullptr) {
    return std::nullopt;
  }
  return fmt::format(
      "the readings of feature {} in placement {} are {:.3g} mm rms off an arm that fits the others (were all of them "
      "taken on that feature, and on the artefact described?)",
      in_quotes(feature->name.feature), in_quotes(feature->name.placement), feature->rms);
}

std::optional<std::string> implausible_feature_text(const Evaluation& evaluation, double far_off) {
  if (auto feature = implausible_feature(evaluation, far_off)) {
    return feature;
  }
  const auto* length = standing_out(evaluation.lengths, usual_deviation(evaluation.features), far_off);
  if (length == nullptr) {
    return std::nullopt;
  }
  return fmt::format(
      "the distance of {} and {} in placement {} is measured {:+.3g} mm off its certified {:.6g} mm with an arm that "
      "fits the others (have these features each other's names?)",
      in_quotes(length->first.feature), in_quotes(length->second), in_quotes(length->first.placement), length->error,
      length->certified.value);
}

std::optional<std::string> grossly_different_length(const Evaluation& evaluation) {
  struct Measured {
    const LengthDeviation* first = nullptr;
    std::vector<double> lengths;
  };
  std::map<std::tuple<std::string, std::string, std::string>, Measured> by_features;
  for (const LengthDeviation& length : evaluation.lengths) {
    Measured& measured = by_features[{length.first.artefact, length.first.feature, length.second}];
    measured.first = measured.first == nullptr ? &length : measured.first;
    measured.lengths.push_back(length.at_temperature + length.error);
  }
  double largest = 0.0;
  std::optional<std::string> text;
  for (auto& [features, measured] : by_features) {
    const double as_read = median(measured.lengths);
    const double certified = measured.first->certified.value;
    const double difference = std::abs(as_read - certified);
    if (difference > gross_difference * certified && difference > largest) {
      largest = difference;
      text = fmt::format(
          "the certified distance of {} and {} of artefact {} is {:.6g} mm, but the nominal arm reads {:.5g} mm "
          "between them (are these positions, steps and units those of the certificate?)",
          in_quotes(measured.first->first.feature), in_quotes(measured.first->second),
          in_quotes(measured.first->first.artefact), certified, as_read);
    }
  }
  return text;
}

}  // namespace artcal
