#include "core/xml/xml.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <sstream>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr int deepest = 64;

constexpr std::string_view blank = " \t\r\n";

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

int XmlSource::line_of(const pugi::xml_node& node) const {
  return lines_.line_at(static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)));
}

std::string XmlSource::place_of(const pugi::xml_node& node) const {
  return fmt::format("{}:{}", file_.path.string(), line_of(node));
}

std::string XmlSource::place_at(std::ptrdiff_t offset) const {
  return fmt::format("{}:{}", file_.path.string(),
                     lines_.line_at(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0))));
}

Expected<void> parse_xml(const XmlSource& source, pugi::xml_document& document) {
  // Blanks between two pieces of an element's text (a comment on either side) separate numbers: they are kept.
  constexpr unsigned options =
      pugi::parse_default | pugi::parse_doctype | pugi::parse_declaration | pugi::parse_ws_pcdata;
  const TextFile& file = source.file();
  const auto parsed = document.load_buffer(file.text.data(), file.text.size(), options, pugi::encoding_utf8);
  if (!parsed) {
    return bad_input(fmt::format("this is not valid XML: {}", parsed.description()), source.place_at(parsed.offset));
  }
  for (const pugi::xml_node& node : document.children()) {
    if (node.type() == pugi::node_doctype) {
      return bad_input(
          "the file has a document type (<!DOCTYPE …>), which no file of measured values needs; it is not read",
          source.place_of(node));
    }
    if (node.type() == pugi::node_declaration && !is_utf8(node.attribute("encoding").value())) {
      return bad_input(fmt::format("the file says that its encoding is {}, expected UTF-8; save it as UTF-8",
                                   in_quotes(node.attribute("encoding").value())),
                       source.place_of(node));
    }
  }
  if (const pugi::xml_node node = too_deep(document)) {
    return bad_input(fmt::format("elements are nested more than {} deep", deepest), source.place_of(node));
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

pugi::xml_node first_element(const pugi::xml_node& node) {
  return node.find_child([](const pugi::xml_node& child) { return child.type() == pugi::node_element; });
}

std::string text_of(const pugi::xml_node& node) {
  std::string text;
  for (const pugi::xml_node& piece : node.children()) {
    if (piece.type() == pugi::node_pcdata || piece.type() == pugi::node_cdata) {
      text += piece.value();
    }
  }
  text.erase(0, std::min(text.find_first_not_of(blank), text.size()));
  text.erase(text.find_last_not_of(blank) + 1);
  return text;
}

std::string in_one_line_of_words(std::string_view text) {
  std::string words;
  for (const char c : text) {
    if (blank.find(c) == std::string_view::npos) {
      words += c;
    } else if (!words.empty() && words.back() != ' ') {
      words += ' ';
    }
  }
  if (words.ends_with(' ')) {
    words.pop_back();
  }
  return words;
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  return {std::istream_iterator<std::string>(stream), {}};
}

}  // namespace artcal
