#include "identification/strange.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/in_quotes.h"
#include "core/statistics.h"

namespace artcal {
namespace {

constexpr double unusual = 5.0;
// Standard uncertainties by which a certified length may be off before it must be another length.
constexpr double beyond_certificate = 10.0;

// The worst of all, where its size is above `far_off` and well above the median; nothing elsewhere.
template <typename Item, typename Size>
const Item* standing_out(const std::vector<Item>& items, double far_off, Size&& size) {
  std::vector<double> sizes;
  for (const Item& item : items) {
    sizes.push_back(size(item));
  }
  const auto worst = std::max_element(sizes.begin(), sizes.end());
  const bool stands_out = worst != sizes.end() && *worst > far_off && *worst > unusual * median(sizes);
  return stands_out ? &items[static_cast<std::size_t>(worst - sizes.begin())] : nullptr;
}

}  // namespace

std::optional<std::string> feature_that_stands_out(const Evaluation& evaluation, double far_off) {
  if (const auto* feature = standing_out(evaluation.features, far_off, [](const auto& f) { return f.rms; })) {
    return fmt::format(
        "the readings of feature {} in placement {} are {:.3g} mm rms off an arm that fits the others (were all of "
        "them "
        "taken on that feature, and on the artefact described?)",
        in_quotes(feature->name.feature), in_quotes(feature->name.placement), feature->rms);
  }
  return std::nullopt;
}

std::optional<std::string> what_stands_out(const Evaluation& evaluation, double far_off) {
  if (auto feature = feature_that_stands_out(evaluation, far_off)) {
    return feature;
  }
  // Of a length that is known to millimetres only, millimetres say nothing.
  const auto error = [](const LengthDeviation& length) {
    return std::abs(length.error) > beyond_certificate * length.u ? std::abs(length.error) : 0.0;
  };
  if (const auto* length = standing_out(evaluation.lengths, far_off, error)) {
    return fmt::format(
        "the distance of {} and {} in placement {} is measured {:+.3g} mm off its certified {:.6g} mm with an arm "
        "that fits the others (have these features each other's names?)",
        in_quotes(length->first.feature), in_quotes(length->second), in_quotes(length->first.placement), length->error,
        length->certified);
  }
  return std::nullopt;
}

}  // namespace artcal
