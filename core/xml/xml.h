#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/files/text_file.h"
#include "core/text/line_index.h"

namespace pugi {
class xml_document;
class xml_node;
}  // namespace pugi

namespace artcal {

/// The text of an XML file with the places of its elements for messages. The text file must outlive it.
class XmlSource {
 public:
  explicit XmlSource(const TextFile& file) : file_(file), lines_(file.text) {}

  [[nodiscard]] const TextFile& file() const { return file_; }
  /// The line where an element begins, and "certificate.xml:12" for messages.
  [[nodiscard]] int line_of(const pugi::xml_node& node) const;
  [[nodiscard]] std::string place_of(const pugi::xml_node& node) const;
  /// The same of a byte of the text.
  [[nodiscard]] std::string place_at(std::ptrdiff_t offset) const;

 private:
  const TextFile& file_;
  LineIndex lines_;
};

/// Parses XML without believing it. Refused, each with its line where there is one: a syntax error, a document type
/// (entities could be defined in it), elements nested deeper than 64, another encoding than UTF-8.
Expected<void> parse_xml(const XmlSource& source, pugi::xml_document& document);

/// An element's name without its prefix. Prefixes are the writer's choice.
std::string_view local_name(const pugi::xml_node& node);

/// The first child element of that local name; an empty node if there is none.
pugi::xml_node child_of(const pugi::xml_node& node, std::string_view name);

/// The first child element of any name; an empty node if there is none.
pugi::xml_node first_element(const pugi::xml_node& node);

/// An element's character data without the white space around it: every piece of it, whatever comments, processing
/// instructions and CDATA sections lie between (XML 1.0, 2.4 to 2.7). That of elements inside it is not part of it.
std::string text_of(const pugi::xml_node& node);

/// The text with every run of white space as one space (xs:token): a name that is broken over several lines.
std::string in_one_line_of_words(std::string_view text);

/// What white space separates.
std::vector<std::string> words_of(const std::string& text);

}  // namespace artcal
