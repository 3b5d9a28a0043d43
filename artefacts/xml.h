#pragma once

#include <string>
#include <string_view>

#include "core/error.h"
#include "core/text_file.h"

namespace pugi {
class xml_document;
class xml_node;
}  // namespace pugi

namespace artcal {

/// Parses XML without believing it. Refused, each with its line where there is one: a syntax error, a document type
/// (entities could be defined in it), elements nested deeper than 64, another encoding than UTF-8.
Expected<void> parse_xml(const TextFile& file, pugi::xml_document& document);

/// An element's name without its prefix. Prefixes are the writer's choice.
std::string_view local_name(const pugi::xml_node& node);

/// The first child element of that local name; an empty node if there is none.
pugi::xml_node child_of(const pugi::xml_node& node, std::string_view name);

/// An element's text without the white space around it; empty for an empty node.
std::string text_of(const pugi::xml_node& node);

/// "certificate.xml:12", the line where an element begins.
std::string place_of(const TextFile& file, const pugi::xml_node& node);
int line_of(const TextFile& file, const pugi::xml_node& node);

}  // namespace artcal
