#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "core/file_access.h"

namespace artcal {

/// --allow-outside: whether the files that a user names may refer to files anywhere.
struct AccessOption {
  bool anywhere = false;

  void add_to(CLI::App& parser);
  /// For a file that the user has named.
  [[nodiscard]] FileAccess of(const std::string& path) const {
    return anywhere ? FileAccess::anywhere() : FileAccess::beside(path);
  }
};

}  // namespace artcal
