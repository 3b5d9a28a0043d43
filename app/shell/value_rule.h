#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace artcal {

/// Which values an option accepts, as the parser's check describes itself.
struct ValueRule {
  enum class Number { No, Whole, Real };
  Number number = Number::No;
  std::vector<std::string> choices;
  std::string least, greatest;  ///< empty where there is no limit

  /// For help: "1 to 1000", "worst or mean"; empty where every text may do.
  [[nodiscard]] std::string shortly() const;
  /// For an error: "a whole number from 1 to 1000", "worst or mean"; empty where nothing is known.
  [[nodiscard]] std::string expected() const;
};

/// What the parser calls a type, such as "GOAL:{worst,mean}" or "INT:INT in [1 - 1000]".
ValueRule value_rule(std::string_view type);
/// The type's name as it is shown: GOAL, N for a whole number, X for another number.
std::string shown_type(std::string_view type);

/// What completes a value in a shell.
struct FileKind {
  enum class Kind { None, Files, Folders };
  Kind kind = Kind::None;
  std::vector<std::string> endings;  ///< such as "toml"; empty: files of any name
};

/// By the name of the type: RECORDING completes to .toml files, FOLDER to folders, a name in capitals that is none of
/// the known values to any file.
FileKind file_kind(std::string_view shown_type);

}  // namespace artcal
