#include "artefacts/dcc/dcc_nodes.h"

#include <sstream>

#include <pugixml.hpp>

#include "core/text/in_quotes.h"

namespace artcal {

// One line without control characters, and without the white space that the schema refuses at the ends.
std::string plain(const std::string& text) {
  std::string clean;
  std::string_view rest = text;
  for (auto control = find_control(rest); control; control = find_control(rest)) {
    clean += std::string(rest.substr(0, control->offset)) + " ";
    rest.remove_prefix(control->offset + control->length);
  }
  std::istringstream words(clean + std::string(rest));
  std::string line;
  for (std::string word; words >> word;) {
    line += (line.empty() ? "" : " ") + word;
  }
  return line;
}

void add(pugi::xml_node& parent, const char* name, const std::string& text) {
  parent.append_child(name).text().set(plain(text).c_str());
}

void add_unless_empty(pugi::xml_node& parent, const char* name, const std::string& text) {
  if (!plain(text).empty()) {
    add(parent, name, text);
  }
}

void add_text(pugi::xml_node& parent, const char* name, const std::string& text) {
  pugi::xml_node named = parent.append_child(name);
  pugi::xml_node content = named.append_child("dcc:content");
  content.append_attribute("lang") = "en";
  content.text().set(plain(text).c_str());
}

}  // namespace artcal
