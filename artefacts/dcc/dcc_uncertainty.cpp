#include "artefacts/dcc/dcc_uncertainty.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "core/text/decimal_number.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::string_view list_suffix = "XMLList";

std::string_view without_suffix(std::string_view name) {
  return name.ends_with(list_suffix) ? name.substr(0, name.size() - list_suffix.size()) : name;
}

// The child element of that name, or of that name with "XMLList" behind it.
pugi::xml_node either_child_of(const pugi::xml_node& node, std::string_view name) {
  return node.find_child([name](const pugi::xml_node& child) { return without_suffix(local_name(child)) == name; });
}

// Half a unit of the last digit that a decimal number is written with: of "25.40e-3" it is 0.5e-5.
double half_digit(std::string_view number) {
  const std::size_t exponent_at = number.find_first_of("eE");
  const std::string_view mantissa = number.substr(0, exponent_at);
  const std::size_t point = mantissa.find('.');
  int exponent = 0;
  if (exponent_at != std::string_view::npos) {
    std::string_view digits = number.substr(exponent_at + 1);
    digits.remove_prefix(digits.starts_with('+') ? 1 : 0);
    std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  }
  const auto decimals = point == std::string_view::npos ? 0 : static_cast<int>(mantissa.size() - point) - 1;
  return 0.5 * std::pow(10.0, exponent - decimals);
}

/// Where one form of uncertainty keeps its numbers.
struct UncertaintyForm {
  std::string_view element;
  std::string_view value;
  bool expanded;  // with coverageFactor, or else a standard uncertainty
};
constexpr std::array forms{
    UncertaintyForm{"expandedUnc", "uncertainty", true},
    UncertaintyForm{"coverageInterval", "standardUnc", false},
    UncertaintyForm{"expandedMU", "valueExpandedMU", true},
    UncertaintyForm{"standardMU", "valueStandardMU", false},
    UncertaintyForm{"coverageIntervalMU", "valueStandardMU", false},
    UncertaintyForm{"coverageIntervalMU", "standardUnc", false},  // of a list, by the schema's own slip
};
// The second is how the schema 2.2.1 spells it within lists.
constexpr std::array<std::string_view, 4> univariate{"measurementUncertaintyUnivariate",
                                                     "measurementUncertaintyUnivaraite",
                                                     "listMeasurementUncertaintyUnivariate", "listUnivariateUnc"};

bool states_uncertainty(std::string_view element) {
  const std::string_view name = without_suffix(element);
  constexpr std::array<std::string_view, 8> parts{"Unc",      "unc",    "MU",        "Interval",
                                                  "interval", "Region", "ovariance", "eviation"};
  return std::any_of(parts.begin(), parts.end(),
                     [name](std::string_view part) { return name.find(part) != std::string_view::npos; });
}

std::string unread_element(const XmlSource& source, const pugi::xml_node& node) {
  return fmt::format("{} (line {})", in_quotes(node.name()), source.line_of(node));
}

// One for all, or one each.
double at(const std::vector<double>& numbers, std::size_t i) { return numbers[numbers.size() == 1 ? 0 : i]; }

Expected<std::vector<DccUncertainty>> read_form(const XmlSource& source, const pugi::xml_node& node,
                                                const UncertaintyForm& form, std::size_t count) {
  std::array<std::vector<double>, 3> numbers;  // U, k, coverage probability
  const std::array<std::string_view, 3> names{form.value, "coverageFactor", "coverageProbability"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (const pugi::xml_node child = either_child_of(node, names[i])) {
      auto read = read_written_numbers(source, child);
      if (!read) {
        return tl::unexpected(read.error());
      }
      numbers[i] = std::move(read->values);
    }
  }
  auto& [U, k, p] = numbers;
  if (!form.expanded) {
    k = {1.0};
    p.clear();
  }
  const auto fits = [count](const auto& all) { return all.size() == 1 || all.size() == count; };
  if (!fits(U) || !fits(k) || !(p.empty() || fits(p))) {
    return bad_input(
        fmt::format("the uncertainty holds {} values and {} coverage factors for {} numbers, expected one for "
                    "all or one each",
                    U.size(), k.size(), count),
        source.place_of(node));
  }
  if (std::any_of(k.begin(), k.end(), [](double factor) { return factor <= 0.0; })) {
    return bad_input("the uncertainty has a coverage factor that is not above zero", source.place_of(node));
  }
  std::vector<DccUncertainty> all;
  for (std::size_t i = 0; i < count; ++i) {
    all.push_back({at(U, i), at(k, i), p.empty() ? std::nullopt : std::optional(at(p, i))});
  }
  return all;
}

// The forms that are children of `parent`; nothing where there are none of them.
Expected<std::vector<DccUncertainty>> read_forms(const XmlSource& source, const pugi::xml_node& parent,
                                                 std::size_t count) {
  for (const UncertaintyForm& form : forms) {
    const pugi::xml_node node = either_child_of(parent, form.element);
    if (node && either_child_of(node, form.value)) {
      return read_form(source, node, form, count);
    }
  }
  return std::vector<DccUncertainty>{};
}

}  // namespace

Expected<DccWrittenNumbers> read_written_numbers(const XmlSource& source, const pugi::xml_node& node) {
  if (const pugi::xml_node inside = first_element(node)) {
    return bad_input(
        fmt::format("{} holds the element {}, expected numbers only", in_quotes(node.name()), in_quotes(inside.name())),
        source.place_of(node));
  }
  DccWrittenNumbers numbers;
  for (const std::string& word : words_of(text_of(node))) {
    const auto number = decimal_number(word);
    const bool not_measured = word == "NaN";  // D-SI allows it; it is refused where it is asked for
    if (!not_measured && !(number && std::isfinite(*number))) {
      return bad_input(fmt::format("{} holds {}, expected a number", in_quotes(node.name()), in_quotes(word)),
                       source.place_of(node));
    }
    numbers.values.push_back(not_measured ? std::nan("") : *number);
    numbers.half_digits.push_back(not_measured ? 0.0 : half_digit(word));
  }
  return numbers;
}

Expected<DccStatedUncertainty> read_stated_uncertainty(const XmlSource& source, const pugi::xml_node& parent,
                                                       std::size_t count) {
  DccStatedUncertainty stated;
  std::vector<pugi::xml_node> places{parent};
  for (const std::string_view name : univariate) {
    if (const pugi::xml_node node = either_child_of(parent, name)) {
      places.push_back(node);
    }
  }
  for (const pugi::xml_node& place : places) {
    auto read = read_forms(source, place, count);
    if (!read) {
      return tl::unexpected(read.error());
    }
    if (!read->empty()) {
      stated.each = std::move(*read);
      return stated;
    }
  }
  for (const pugi::xml_node& node : parent.children()) {
    if (node.type() == pugi::node_element && states_uncertainty(local_name(node))) {
      stated.unread = unread_element(source, node);
      break;
    }
  }
  return stated;
}

}  // namespace artcal
