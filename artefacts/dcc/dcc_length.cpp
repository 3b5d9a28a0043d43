#include "artefacts/dcc/dcc_length.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::string_view known_units = "\\metre with no prefix or \\kilo, \\deci, \\centi, \\milli, \\micro, \\nano";
// Uncertainties are rounded to one digit or two: 1.49 to 1.
constexpr double rounding_of_uncertainties = 1.5;

/// A representation in mm.
struct InMillimetres {
  DccLengths lengths;
  std::vector<double> half_digits;  // mm
};

bool are_lengths(const DccNumbers& numbers) {
  return std::all_of(numbers.units.begin(), numbers.units.end(),
                     [](const std::string& unit) { return dsi_length_unit(unit).has_value(); });
}

InMillimetres converted(const DccNumbers& numbers) {
  InMillimetres all{{{}, numbers.uncertainties, numbers.unread_uncertainty, numbers.labels}, {}};
  for (std::size_t i = 0; i < numbers.values.size(); ++i) {
    const double unit = dsi_length_unit(numbers.units[i]).value_or(1.0);
    all.lengths.values.push_back(numbers.values[i] * unit);
    all.half_digits.push_back(numbers.half_digits[i] * unit);
    if (!all.lengths.uncertainties.empty()) {
      all.lengths.uncertainties[i].U *= unit;
    }
  }
  return all;
}

// By more than the rounding of the conversion itself.
bool is_finer(const InMillimetres& one, const InMillimetres& other) {
  const auto coarsest = [](const auto& all) { return *std::max_element(all.begin(), all.end()); };
  return coarsest(one.half_digits) < 0.99 * coarsest(other.half_digits);
}

std::string contradiction(const InMillimetres& one, const InMillimetres& other) {
  const auto& a = one.lengths.values;
  const auto& b = other.lengths.values;
  if (a.size() != b.size()) {
    return fmt::format("{} numbers and {} numbers", a.size(), b.size());
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double rounding = one.half_digits[i] + other.half_digits[i] + 1e-12 * std::abs(a[i]);
    if (!(std::abs(a[i] - b[i]) <= rounding)) {
      return fmt::format("{} mm and {} mm", a[i], b[i]);
    }
  }
  if (one.lengths.uncertainties.empty() || other.lengths.uncertainties.empty()) {
    return {};
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto& u = one.lengths.uncertainties[i];
    const auto& v = other.lengths.uncertainties[i];
    const double ratio = (u.U / u.k) / (v.U / v.k);
    if (std::isfinite(ratio) && (ratio > rounding_of_uncertainties || ratio < 1.0 / rounding_of_uncertainties)) {
      return fmt::format("U = {} mm (k = {}) and U = {} mm (k = {})", u.U, u.k, v.U, v.k);
    }
  }
  return {};
}

// What is wrong with the lengths that were chosen; empty where nothing is.
std::string impossible(const DccLengths& lengths) {
  if (!std::all_of(lengths.values.begin(), lengths.values.end(), [](double value) { return std::isfinite(value); })) {
    return "holds a NaN, no number";
  }
  for (const DccUncertainty& uncertainty : lengths.uncertainties) {
    if (!(uncertainty.U > 0.0) || !(uncertainty.k >= 0.0)) {
      return fmt::format("has U = {} mm and k = {}; an uncertainty of zero or less is not one", uncertainty.U,
                         uncertainty.k);
    }
  }
  return {};
}

// An uncertainty of another representation, where the chosen one has none.
void take_uncertainty(const std::vector<InMillimetres>& all, const DccQuantity& quantity, DccLengths& lengths) {
  for (const InMillimetres& other : all) {
    if (lengths.uncertainties.empty()) {
      lengths.uncertainties = other.lengths.uncertainties;
    }
  }
  for (const DccNumbers& numbers : quantity.representations) {
    if (lengths.unread_uncertainty.empty() && !numbers.uncertainties.empty()) {
      lengths.unread_uncertainty = fmt::format("an uncertainty in {}", in_quotes(numbers.units.front()));
    } else if (lengths.unread_uncertainty.empty()) {
      lengths.unread_uncertainty = numbers.unread_uncertainty;
    }
  }
  if (!lengths.uncertainties.empty()) {
    lengths.unread_uncertainty.clear();
  }
}

tl::unexpected<Error> refusal(const DccQuantity& quantity, const std::string& what) {
  return bad_input(fmt::format("the certificate's quantity {} {}", in_quotes(quantity.text()), what));
}

}  // namespace

std::optional<double> dsi_length_unit(std::string_view unit) {
  constexpr std::string_view metre = "\\metre";
  if (!unit.ends_with(metre)) {
    return std::nullopt;
  }
  const std::string_view prefix = unit.substr(0, unit.size() - metre.size());
  constexpr std::pair<std::string_view, double> prefixes[] = {{"", 1e3},        {"\\kilo", 1e6},  {"\\deci", 1e2},
                                                              {"\\centi", 1e1}, {"\\milli", 1.0}, {"\\micro", 1e-3},
                                                              {"\\nano", 1e-6}};
  for (const auto& [name, factor] : prefixes) {
    if (name == prefix) {
      return factor;
    }
  }
  return std::nullopt;
}

Expected<DccLengths> lengths_of(const DccQuantity& quantity) {
  if (quantity.fault) {
    return tl::unexpected(*quantity.fault);
  }
  std::vector<InMillimetres> all;
  for (const DccNumbers& numbers : quantity.representations) {
    if (are_lengths(numbers)) {
      all.push_back(converted(numbers));
    }
  }
  if (all.empty()) {
    const auto& units = quantity.numbers().units;
    const auto other = std::find_if_not(units.begin(), units.end(),
                                        [](const std::string& unit) { return dsi_length_unit(unit).has_value(); });
    return refusal(quantity, fmt::format("is in {}, which is no unit of length known here, expected {}",
                                         in_quotes(*other), known_units));
  }
  if (const std::string wrong = impossible(all.front().lengths); !wrong.empty()) {
    return refusal(quantity, wrong);
  }
  const InMillimetres* chosen = &all.front();
  for (const InMillimetres& one : all) {
    const std::string found = contradiction(all.front(), one);
    if (!found.empty()) {
      return refusal(quantity,
                     fmt::format("states {} for the same length; ask the laboratory which of them holds", found));
    }
    chosen = is_finer(one, *chosen) ? &one : chosen;
  }
  DccLengths lengths = chosen->lengths;
  take_uncertainty(all, quantity, lengths);
  if (const std::string wrong = impossible(lengths); !wrong.empty()) {
    return refusal(quantity, wrong);
  }
  return lengths;
}

}  // namespace artcal
