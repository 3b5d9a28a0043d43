#include "artefacts/dcc/dcc_quantity.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "artefacts/dcc/dcc_numbers.h"
#include "artefacts/dcc/dcc_relative.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::size_t max_names = 100;
constexpr std::array<std::string_view, 3> texts{"noQuantity", "charsXMLList", "chars"};
constexpr std::array<std::string_view, 9> numbers{"real",        "realListXMLList",    "realList",
                                                  "list",        "constant",           "complex",
                                                  "complexList", "complexListXMLList", "hybrid"};

template <std::size_t n>
bool is_one_of(const std::array<std::string_view, n>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// The elements with a quantity's numbers: what a hybrid holds, or else the one that the quantity holds.
std::vector<pugi::xml_node> number_nodes(const pugi::xml_node& parent) {
  std::vector<pugi::xml_node> found;
  for (const pugi::xml_node& node : parent.children()) {
    if (node.type() == pugi::node_element && is_one_of(numbers, local_name(node))) {
      found.push_back(node);
    }
  }
  return found;
}

bool is_text(const pugi::xml_node& quantity) {
  return quantity.find_child([](const pugi::xml_node& child) { return is_one_of(texts, local_name(child)); });
}

Expected<std::vector<DccNumbers>> read_representations(const XmlSource& source, const pugi::xml_node& quantity) {
  std::vector<pugi::xml_node> nodes = number_nodes(quantity);
  if (nodes.size() != 1) {
    return bad_input(fmt::format("the quantity holds {} elements with numbers, expected one, such as si:real",
                                 nodes.empty() ? "no" : fmt::to_string(nodes.size())),
                     source.place_of(quantity));
  }
  if (local_name(nodes.front()) == "hybrid") {
    nodes = number_nodes(nodes.front());
  }
  std::vector<DccNumbers> representations;
  for (const pugi::xml_node& node : nodes) {
    auto read = read_dcc_numbers(source, node);
    if (!read) {
      return tl::unexpected(read.error());
    }
    representations.push_back(std::move(*read));
  }
  if (representations.empty()) {
    return bad_input("the quantity's si:hybrid is empty", source.place_of(quantity));
  }
  if (auto added = add_relative_uncertainty(source, quantity, representations); !added) {
    return tl::unexpected(added.error());
  }
  return representations;
}

void add_name(std::vector<std::string>& names, const pugi::xml_node& node) {
  if (std::string name = in_one_line_of_words(text_of(node)); !name.empty() && names.size() < max_names) {
    names.push_back(std::move(name));
  }
}

// Some certificates name their quantities in si:label alone.
void add_si_labels(const pugi::xml_node& parent, std::vector<std::string>& names) {
  for (const pugi::xml_node& node : number_nodes(parent)) {
    add_name(names, child_of(node, "label"));
    add_name(names, child_of(node, "labelXMLList"));
    if (local_name(node) == "hybrid") {
      add_si_labels(node, names);
    }
  }
}

}  // namespace

DccLabels dcc_labels(const pugi::xml_node& node) {
  DccLabels labels;
  labels.id = node.attribute("id").value();
  labels.ref_types = words_of(node.attribute("refType").value());
  labels.ref_types.resize(std::min(labels.ref_types.size(), max_names));
  for (const pugi::xml_node& content : child_of(node, "name").children()) {
    if (local_name(content) == "content") {
      add_name(labels.names, content);
    }
  }
  return labels;
}

std::optional<DccQuantity> read_quantity(const XmlSource& source, const pugi::xml_node& node) {
  if (is_text(node)) {
    return std::nullopt;
  }
  DccQuantity quantity{dcc_labels(node), {}, {}, std::nullopt, source.line_of(node)};
  std::vector<std::string> names;
  add_si_labels(node, names);
  // The last name is the one that is shown: better the quantity's own than the label of one of its numbers.
  quantity.labels.names.insert(quantity.labels.names.begin(), names.begin(), names.end());
  auto representations = read_representations(source, node);
  if (representations) {
    quantity.representations = std::move(*representations);
  } else {
    quantity.fault = std::move(representations.error());
  }
  return quantity;
}

}  // namespace artcal
