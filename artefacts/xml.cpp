#include "artefacts/xml.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "core/in_quotes.h"

namespace artcal {
namespace {

constexpr int deepest = 64;

int line_at(const TextFile& file, std::ptrdiff_t offset) {
  const auto end = file.text.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(file.text));
  return 1 + static_cast<int>(std::count(file.text.begin(), end, '\n'));
}

std::string position(const TextFile& file, std::ptrdiff_t offset) {
  return fmt::format("{}:{}", file.path.string(), line_at(file, offset));
}

// The first element that is nested too deep. Without recursion: the nesting is the attacker's.
pugi::xml_node too_deep(const pugi::xml_node& root) {
  int depth = 0;
  for (pugi::xml_node node = root.first_child(); node;) {
    if (depth >= deepest) {
      return node;
    }
    if (node.first_child()) {
      node = node.first_child();
      ++depth;
      continue;
    }
    while (node != root && !node.next_sibling()) {
      node = node.parent();
      --depth;
    }
    node = node == root ? pugi::xml_node{} : node.next_sibling();
  }
  return {};
}

bool is_utf8(std::string encoding) {
  std::transform(encoding.begin(), encoding.end(), encoding.begin(), [](unsigned char c) { return std::tolower(c); });
  return encoding.empty() || encoding == "utf-8" || encoding == "us-ascii";
}

}  // namespace

Expected<void> parse_xml(const TextFile& file, pugi::xml_document& document) {
  constexpr unsigned options = pugi::parse_default | pugi::parse_doctype | pugi::parse_declaration;
  const auto parsed = document.load_buffer(file.text.data(), file.text.size(), options, pugi::encoding_utf8);
  if (!parsed) {
    return bad_input(fmt::format("this is not valid XML: {}", parsed.description()), position(file, parsed.offset));
  }
  for (const pugi::xml_node& node : document.children()) {
    if (node.type() == pugi::node_doctype) {
      return bad_input("the file has a document type (<!DOCTYPE …>), which no certificate needs; it is not read",
                       position(file, node.offset_debug()));
    }
    if (node.type() == pugi::node_declaration && !is_utf8(node.attribute("encoding").value())) {
      return bad_input(fmt::format("the file says that its encoding is {}, expected UTF-8; save it as UTF-8",
                                   in_quotes(node.attribute("encoding").value())),
                       position(file, node.offset_debug()));
    }
  }
  if (const pugi::xml_node node = too_deep(document)) {
    return bad_input(fmt::format("elements are nested more than {} deep", deepest), place_of(file, node));
  }
  return {};
}

std::string_view local_name(const pugi::xml_node& node) {
  const std::string_view name = node.name();
  const auto colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

pugi::xml_node child_of(const pugi::xml_node& node, std::string_view name) {
  return node.find_child([name](const pugi::xml_node& child) { return local_name(child) == name; });
}

std::string text_of(const pugi::xml_node& node) {
  std::string text = node.text().get();
  constexpr std::string_view blank = " \t\r\n";
  text.erase(0, std::min(text.find_first_not_of(blank), text.size()));
  text.erase(text.find_last_not_of(blank) + 1);
  return text;
}

int line_of(const TextFile& file, const pugi::xml_node& node) { return line_at(file, node.offset_debug()); }

std::string place_of(const TextFile& file, const pugi::xml_node& node) { return position(file, node.offset_debug()); }

}  // namespace artcal
