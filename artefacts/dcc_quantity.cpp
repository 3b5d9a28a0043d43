#include "artefacts/dcc_quantity.h"

#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "artefacts/xml.h"
#include "core/in_quotes.h"

namespace artcal {
namespace {

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

Expected<std::vector<double>> numbers_of(const TextFile& file, const pugi::xml_node& node) {
  std::vector<double> numbers;
  for (const std::string& word : words_of(text_of(node))) {
    const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
    const char* end = word.data() + word.size();
    double number = 0.0;
    const auto [rest, error] = std::from_chars(begin, end, number);
    const bool not_measured = word == "NaN";  // D-SI allows it; it is refused where it is asked for
    if (!not_measured && (error != std::errc{} || rest != end || !std::isfinite(number))) {
      return bad_input(fmt::format("{} holds {}, expected a number", in_quotes(node.name()), in_quotes(word)),
                       place_of(file, node));
    }
    numbers.push_back(not_measured ? std::nan("") : number);
  }
  return numbers;
}

// Numbers of an element that may be absent: none then.
Expected<std::vector<double>> numbers_in(const TextFile& file, const pugi::xml_node& parent, std::string_view name) {
  const pugi::xml_node node = child_of(parent, name);
  return node ? numbers_of(file, node) : std::vector<double>{};
}

/// Where one form of uncertainty keeps its numbers; all names also with "XMLList" behind them.
struct UncertaintyForm {
  const char* element;
  const char* value;
  bool expanded;  // with coverageFactor, or else a standard uncertainty
};
constexpr std::array forms{
    UncertaintyForm{"expandedUnc", "uncertainty", true},
    UncertaintyForm{"coverageInterval", "standardUnc", false},
    UncertaintyForm{"expandedMU", "valueExpandedMU", true},
    UncertaintyForm{"standardMU", "valueStandardMU", false},
    UncertaintyForm{"coverageIntervalMU", "valueStandardMU", false},
};

// One for all, or one each.
double at(const std::vector<double>& numbers, std::size_t i) { return numbers[numbers.size() == 1 ? 0 : i]; }

Expected<std::vector<DccUncertainty>> read_form(const TextFile& file, const pugi::xml_node& node,
                                                const UncertaintyForm& form, const std::string& suffix,
                                                std::size_t count) {
  const auto U = numbers_in(file, node, form.value + suffix);
  const auto k = form.expanded ? numbers_in(file, node, "coverageFactor" + suffix)
                               : Expected<std::vector<double>>(std::vector<double>{1.0});
  const auto p = numbers_in(file, node, "coverageProbability" + suffix);
  for (const auto* numbers : {&U, &k, &p}) {
    if (!*numbers) {
      return tl::unexpected(numbers->error());
    }
  }
  const auto fits = [count](const auto& numbers) { return numbers.size() == 1 || numbers.size() == count; };
  if (!fits(*U) || !fits(*k) || !(p->empty() || fits(*p))) {
    return bad_input(
        fmt::format("the uncertainty holds {} values and {} coverage factors for {} numbers, expected one for "
                    "all or one each",
                    U->size(), k->size(), count),
        place_of(file, node));
  }
  std::vector<DccUncertainty> all;
  for (std::size_t i = 0; i < count; ++i) {
    all.push_back({at(*U, i), at(*k, i), p->empty() || !form.expanded ? std::nullopt : std::optional(at(*p, i))});
  }
  return all;
}

Expected<std::vector<DccUncertainty>> read_uncertainties(const TextFile& file, const pugi::xml_node& real,
                                                         const std::string& suffix, std::size_t count) {
  const pugi::xml_node univariate = child_of(real, "measurementUncertaintyUnivariate" + suffix);
  for (const UncertaintyForm& form : forms) {
    for (const pugi::xml_node& parent : {real, univariate}) {
      if (const pugi::xml_node node = child_of(parent, form.element + suffix)) {
        return read_form(file, node, form, suffix, count);
      }
    }
  }
  return std::vector<DccUncertainty>{};
}

// The si:real or si:realListXMLList of a quantity; in a hybrid the first, which D-SI wants in base units.
pugi::xml_node number_node(const pugi::xml_node& quantity) {
  const pugi::xml_node hybrid = child_of(quantity, "hybrid");
  const pugi::xml_node parent = hybrid ? hybrid : quantity;
  const pugi::xml_node real = child_of(parent, "real");
  return real ? real : child_of(parent, "realListXMLList");
}

}  // namespace

DccLabels dcc_labels(const pugi::xml_node& node) {
  DccLabels labels;
  labels.id = node.attribute("id").value();
  labels.ref_types = words_of(node.attribute("refType").value());
  for (const pugi::xml_node& content : child_of(node, "name").children()) {
    if (local_name(content) == "content") {
      labels.names.push_back(text_of(content));
    }
  }
  return labels;
}

Expected<std::optional<DccQuantity>> read_quantity(const TextFile& file, const pugi::xml_node& node) {
  const pugi::xml_node real = number_node(node);
  if (!real) {
    return std::nullopt;
  }
  const bool is_list = local_name(real) == "realListXMLList";
  const std::string suffix = is_list ? "XMLList" : "";
  const pugi::xml_node value = child_of(real, "value" + suffix);
  const pugi::xml_node unit = child_of(real, "unit" + suffix);
  const auto values = numbers_of(file, value ? value : real);
  if (!values) {
    return tl::unexpected(values.error());
  }
  const auto units = words_of(text_of(unit));
  if (values->empty() || (!is_list && values->size() != 1) || units.size() != 1) {
    return bad_input(fmt::format("{} holds {} values and {} units, expected {} and one unit", in_quotes(real.name()),
                                 values->size(), units.size(), is_list ? "numbers" : "one number"),
                     place_of(file, real));
  }
  const auto uncertainties = read_uncertainties(file, real, suffix, values->size());
  if (!uncertainties) {
    return tl::unexpected(uncertainties.error());
  }
  return DccQuantity{dcc_labels(node), {}, units.front(), *values, *uncertainties, line_of(file, node)};
}

}  // namespace artcal
