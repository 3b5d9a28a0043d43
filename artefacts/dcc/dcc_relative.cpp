#include "artefacts/dcc/dcc_relative.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "artefacts/dcc/dcc_length.h"
#include "artefacts/dcc/dcc_numbers.h"
#include "artefacts/dcc/dcc_uncertainty.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

std::string place(const XmlSource& source, const pugi::xml_node& node) {
  return fmt::format("{} (line {})", in_quotes(node.name()), source.line_of(node));
}

// The coverage factor that stands anywhere in the element; 0 where there is none.
Expected<double> coverage_factor_in(const XmlSource& source, const pugi::xml_node& node) {
  const pugi::xml_node factor = node.find_node([](const pugi::xml_node& inside) {
    return local_name(inside) == "coverageFactor" || local_name(inside) == "coverageFactorXMLList";
  });
  return read_written_numbers(source, factor).map([](const DccWrittenNumbers& k) {
    const bool same = std::adjacent_find(k.values.begin(), k.values.end(), std::not_equal_to<>()) == k.values.end();
    return k.values.empty() || !same ? 0.0 : k.values.front();
  });
}

}  // namespace

std::optional<double> dsi_ratio_unit(std::string_view unit) {
  if (unit == "\\one" || unit == "1") {
    return 1.0;
  }
  if (unit == "\\percent") {
    return 1e-2;
  }
  if (unit == "\\ppm") {
    return 1e-6;
  }
  for (const std::string_view per_metre : {"\\per\\metre", "\\metre\\tothe{-1}"}) {
    if (unit.ends_with(per_metre)) {
      const auto length = dsi_length_unit(unit.substr(0, unit.size() - per_metre.size()));
      return length ? std::optional(*length / 1e3) : std::nullopt;
    }
  }
  return std::nullopt;
}

Expected<void> add_relative_uncertainty(const XmlSource& source, const pugi::xml_node& quantity,
                                        std::vector<DccNumbers>& representations) {
  const pugi::xml_node relative = first_element(child_of(quantity, "relativeUncertainty"));
  if (!relative || std::any_of(representations.begin(), representations.end(),
                               [](const DccNumbers& numbers) { return !numbers.uncertainties.empty(); })) {
    return {};
  }
  const auto read = read_dcc_numbers_as(source, relative, local_name(relative) != "relativeUncertaintySingle");
  if (!read) {
    return tl::unexpected(read.error());
  }
  const auto k = coverage_factor_in(source, relative);
  if (!k) {
    return tl::unexpected(k.error());
  }
  for (DccNumbers& numbers : representations) {
    const std::size_t count = read->values.size();
    if (count != 1 && count != numbers.values.size()) {
      return bad_input(
          fmt::format("there are {} relative uncertainties of {} numbers, expected one for all or one each", count,
                      numbers.values.size()),
          source.place_of(relative));
    }
    for (std::size_t i = 0; i < numbers.values.size(); ++i) {
      const std::size_t j = count == 1 ? 0 : i;
      const auto factor = dsi_ratio_unit(read->units[j]);
      if (!factor) {
        numbers.uncertainties.clear();
        numbers.unread_uncertainty = fmt::format("{} in {}", place(source, relative), in_quotes(read->units[j]));
        break;
      }
      numbers.uncertainties.push_back({read->values[j] * *factor * std::abs(numbers.values[i]), *k, std::nullopt});
    }
  }
  return {};
}

}  // namespace artcal
