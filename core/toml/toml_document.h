#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/files/text_file.h"

namespace artcal {

/// Strict reading of a TOML table. Every getter that meets something wrong notes it and returns a
/// harmless value; `TomlDocument::finish` then gives the first thing noted, with file, line and column.
/// So a reader is written as straight code and nothing that it returned is used unless finish() agrees.
/// A key that was never asked for is an error too: it is a misspelling, and a silent default would be a
/// wrong number that looks right.
class TomlTable {
 public:
  [[nodiscard]] bool has(std::string_view key) const;
  [[nodiscard]] bool is_text(std::string_view key) const;   ///< false where the key is absent
  [[nodiscard]] bool is_table(std::string_view key) const;  ///< false where the key is absent

  std::string text(std::string_view key);
  std::string text_or(std::string_view key, std::string fallback);
  std::string name(std::string_view key);  ///< text of one line without control characters
  std::string name_or(std::string_view key, std::string fallback);
  double number(std::string_view key);  ///< integer or float; NaN and infinity are refused
  double number_or(std::string_view key, double fallback);
  std::optional<double> optional_number(std::string_view key);
  std::string date(std::string_view key);  ///< 2026-03-02, bare or in quotes; a day that the calendar has
  std::string date_or(std::string_view key, std::string fallback);
  bool truth_or(std::string_view key, bool fallback);
  std::vector<double> numbers(std::string_view key);
  std::vector<std::string> texts(std::string_view key);         ///< an array of strings; none if absent
  std::vector<std::vector<double>> rows(std::string_view key);  ///< an array of arrays; none if absent
  TomlTable table(std::string_view key);                        ///< an empty one if absent
  std::vector<TomlTable> tables(std::string_view key);          ///< an array of tables; none if absent

  /// Notes an error at the key (at the table if the key is absent), unless one was noted before.
  void fail(std::string_view key, std::string message);
  /// "file:line:column" of the key, or of the table if the key is absent.
  [[nodiscard]] std::string where(std::string_view key) const;

 private:
  friend class TomlDocument;
  struct Shared;
  TomlTable(std::shared_ptr<Shared> shared, const void* table, std::string name)
      : shared_(std::move(shared)), table_(table), name_(std::move(name)) {}
  void expected(std::string_view key, std::string_view what);

  std::shared_ptr<Shared> shared_;
  const void* table_;  // a toml::table; the library stays in the source file
  std::string name_;
};

/// A parsed TOML file.
class TomlDocument {
 public:
  /// REQUIRES: `file` holds UTF-8 text. A syntax error names line and column. If the document has a key
  /// `schema`, it must equal `schema`; a missing one is an error that says what to write.
  static Expected<TomlDocument> parse(const TextFile& file, std::string_view schema);
  /// Reads the file and parses it; the errors are read_text_file()'s and parse()'s.
  static Expected<TomlDocument> read(const std::filesystem::path& path, std::string_view schema);

  TomlTable& root() { return root_; }
  /// Of the file that was read.
  [[nodiscard]] const std::string& sha256() const { return sha256_; }

  /// The first error noted so far, if any: before what was read leads to other files.
  [[nodiscard]] Expected<void> so_far() const;
  /// The first error noted, if any; otherwise the first key nobody asked for.
  Expected<void> finish();

 private:
  TomlDocument(TomlTable root, std::string sha256) : root_(std::move(root)), sha256_(std::move(sha256)) {}
  TomlTable root_;
  std::string sha256_;
};

/// The `schema` of a TOML text; empty if it has none or is no TOML.
std::string schema_of(const TextFile& file);

}  // namespace artcal
