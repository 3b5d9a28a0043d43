#pragma once

#include <map>
#include <string>

#include <CLI/CLI.hpp>

namespace artcal {

/// Accepts the names of values. It describes itself as the parser's own check for membership does, so that help, errors
/// and completion state the names.
template <typename Value>
CLI::Validator named_values(const std::map<std::string, Value>& values) {
  std::string names;
  for (const auto& [name, value] : values) {
    names += (names.empty() ? "{" : ",") + name;
  }
  return CLI::CheckedTransformer(values).description(names + "}");
}

}  // namespace artcal
