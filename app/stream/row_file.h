#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.h"

namespace artcal {

/// A table that grows row by row. Each row is on disk before append() returns. A row that a crash cut off is taken away
/// when the table is opened again.
class RowFile {
 public:
  /// Opens or begins a table. Refused: a table with another header, one that another process records into.
  static Expected<RowFile> open(const std::filesystem::path& path, const std::string& header);
  RowFile(RowFile&& other) noexcept;
  RowFile& operator=(RowFile&&) = delete;
  ~RowFile();

  [[nodiscard]] std::size_t rows() const { return rows_; }
  /// Those that were there when the table was opened.
  [[nodiscard]] const std::vector<std::string>& first_rows() const { return first_rows_; }
  Expected<void> append(const std::string& row);
  /// Takes the last row away.
  Expected<void> remove_last();

 private:
  RowFile(int file, std::filesystem::path path) : file_(file), path_(std::move(path)) {}
  int file_;
  std::filesystem::path path_;
  std::size_t rows_ = 0;
  std::vector<std::string> first_rows_;
};

}  // namespace artcal
