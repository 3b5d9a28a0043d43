#pragma once

#include <string>
#include <vector>

namespace artcal {

/// A table for the terminal: the first column to the left, the others to the right, two blanks between.
class Table {
 public:
  explicit Table(std::vector<std::string> header) { add(std::move(header)); }
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  [[nodiscard]] std::string text() const;

 private:
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace artcal
