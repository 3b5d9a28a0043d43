#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace artcal {

/// What the values of an enumeration are called in files and results, in the order in which messages list them.
template <typename Enum, std::size_t count>
using EnumNames = std::array<std::pair<Enum, const char*>, count>;

/// The name of a value; empty where it has none.
template <typename Enum, std::size_t count>
const char* name_in(const EnumNames<Enum, count>& names, Enum value) {
  for (const auto& [known, name] : names) {
    if (known == value) {
      return name;
    }
  }
  return "";
}

/// The value that a name means; nothing where it means none.
template <typename Enum, std::size_t count>
std::optional<Enum> value_in(const EnumNames<Enum, count>& names, std::string_view name) {
  for (const auto& [value, known] : names) {
    if (name == known) {
      return value;
    }
  }
  return std::nullopt;
}

/// "a, b or c".
template <typename Enum, std::size_t count>
std::string list_of(const EnumNames<Enum, count>& names) {
  std::string text;
  for (const auto& [value, name] : names) {
    text += (text.empty() ? "" : value == names.back().first ? " or " : ", ") + std::string(name);
  }
  return text;
}

}  // namespace artcal
