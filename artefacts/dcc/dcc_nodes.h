#pragma once

#include <string>

namespace pugi {
class xml_node;
}

namespace artcal {

/// Text for a DCC: one line without control characters, and without the white space that the schema refuses.
std::string plain(const std::string& text);

/// Adds an element with such a text.
void add(pugi::xml_node& parent, const char* name, const std::string& text);
void add_unless_empty(pugi::xml_node& parent, const char* name, const std::string& text);

/// Adds an element with a dcc:content in English.
void add_text(pugi::xml_node& parent, const char* name, const std::string& text);

}  // namespace artcal
