#include "artefacts/dcc/dcc_numbers.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include "artefacts/dcc/dcc_uncertainty.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// Of an element that is asked for once: two of them are a contradiction.
Expected<pugi::xml_node> single_child(const XmlSource& source, const pugi::xml_node& node, std::string_view name) {
  pugi::xml_node found;
  for (const pugi::xml_node& child : node.children()) {
    if (local_name(child) != name) {
      continue;
    }
    if (found) {
      return bad_input(fmt::format("{} holds {} twice", in_quotes(node.name()), in_quotes(child.name())),
                       source.place_of(child));
    }
    found = child;
  }
  return found;
}

// The standard uncertainty of a si:constant stands in it directly.
Expected<DccStatedUncertainty> uncertainty_of_constant(const XmlSource& source, const pugi::xml_node& node) {
  if (const pugi::xml_node standard = child_of(node, "valueStandardMU")) {
    const auto read = read_written_numbers(source, standard);
    if (!read || read->values.size() != 1) {
      return bad_input("the standard uncertainty of the constant is no number", source.place_of(standard));
    }
    return DccStatedUncertainty{{{read->values.front(), 1.0, std::nullopt}}, {}};
  }
  return read_stated_uncertainty(source, node, 1);
}

// What a list says for all its numbers.
struct ListDefaults {
  std::string unit;
  pugi::xml_node list;  // empty where there is none
};

// One number, or numbers separated by blanks.
Expected<DccNumbers> read_plain(const XmlSource& source, const pugi::xml_node& node, bool is_list,
                                const ListDefaults& defaults) {
  const std::string suffix = is_list ? "XMLList" : "";
  const auto value = single_child(source, node, "value" + suffix);
  const auto unit = single_child(source, node, "unit" + suffix);
  if (!value || !unit) {
    return tl::unexpected(value ? unit.error() : value.error());
  }
  auto written = read_written_numbers(source, *value);
  if (!written) {
    return tl::unexpected(written.error());
  }
  DccNumbers numbers{std::move(written->values), std::move(written->half_digits), words_of(text_of(*unit)), {}, {}, {}};
  const std::size_t count = numbers.values.size();
  if (numbers.units.empty() && !defaults.unit.empty()) {
    numbers.units = {defaults.unit};
  }
  if (count == 0 || (!is_list && count != 1) || (numbers.units.size() != 1 && numbers.units.size() != count)) {
    return bad_input(
        fmt::format("{} holds {} values and {} units, expected {}", in_quotes(node.name()), count, numbers.units.size(),
                    is_list ? "numbers, and one unit for all or one each" : "one number and one unit"),
        source.place_of(node));
  }
  numbers.units.resize(count, numbers.units.front());
  if (auto labels = words_of(text_of(child_of(node, "label" + suffix))); is_list && labels.size() == count) {
    numbers.labels = std::move(labels);
  }
  auto stated = local_name(node) == "constant" ? uncertainty_of_constant(source, node)
                                               : read_stated_uncertainty(source, node, count);
  if (stated && stated->each.empty() && stated->unread.empty() && defaults.list) {
    stated = read_stated_uncertainty(source, defaults.list, count);
  }
  if (!stated) {
    return tl::unexpected(stated.error());
  }
  numbers.uncertainties = std::move(stated->each);
  numbers.unread_uncertainty = std::move(stated->unread);
  return numbers;
}

template <typename T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

// The numbers of all elements of a list. An uncertainty of some of them only is not read.
Expected<DccNumbers> read_list(const XmlSource& source, const pugi::xml_node& list) {
  const ListDefaults defaults{text_of(child_of(list, "listUnit")), list};
  DccNumbers all;
  for (const pugi::xml_node& node : list.children()) {
    const std::string_view name = local_name(node);
    if (name.find("omplex") != std::string_view::npos) {
      return bad_input("the quantity is a list of complex numbers, expected real ones", source.place_of(node));
    }
    if (!name.starts_with("real") && name != "list") {
      continue;
    }
    const auto read = name == "list" || name == "realList" ? read_dcc_numbers(source, node)
                                                           : read_plain(source, node, name != "real", defaults);
    if (!read) {
      return tl::unexpected(read.error());
    }
    append(all.values, read->values);
    append(all.half_digits, read->half_digits);
    append(all.units, read->units);
    append(all.uncertainties, read->uncertainties);
    all.unread_uncertainty += all.unread_uncertainty.empty() ? read->unread_uncertainty : "";
  }
  if (all.values.empty()) {
    return bad_input(fmt::format("{} holds no number", in_quotes(list.name())), source.place_of(list));
  }
  if (all.uncertainties.size() != all.values.size()) {
    if (!all.uncertainties.empty() && all.unread_uncertainty.empty()) {
      all.unread_uncertainty =
          fmt::format("{} (line {}), of some of its numbers only", in_quotes(list.name()), source.line_of(list));
    }
    all.uncertainties.clear();
  }
  return all;
}

}  // namespace

Expected<DccNumbers> read_dcc_numbers_as(const XmlSource& source, const pugi::xml_node& node, bool is_list) {
  return read_plain(source, node, is_list, {});
}

// Recursion ends: parse_xml() bounds the nesting.
Expected<DccNumbers> read_dcc_numbers(const XmlSource& source, const pugi::xml_node& node) {
  const std::string_view name = local_name(node);
  if (name == "real" || name == "constant" || name == "realListXMLList") {
    return read_plain(source, node, name == "realListXMLList", {});
  }
  if (name == "realList" || name == "list") {
    return read_list(source, node);
  }
  return bad_input(
      fmt::format("the quantity holds {}, which is not read here, expected a real number or a list of them",
                  in_quotes(node.name())),
      source.place_of(node));
}

}  // namespace artcal
