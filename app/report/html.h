#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace artcal::html {

/// Text as a page shows it: what HTML would read as markup is written as entities, control characters and marks
/// of direction as '?', and of a very long text the first 4000 characters. Fit for text and for attributes in
/// double quotes; the only way by which anything from a file gets into a page.
std::string text(std::string_view found);

/// The same for a cell of a table, whose column may become no narrower than its longest word: words of more than 28
/// characters, such as paths, may be broken after their punctuation, and where they have none anywhere. No other word
/// is.
std::string cell(std::string_view found);

/// Each in a tag of its own; the arguments are markup already.
std::string element(std::string_view tag, std::string_view content, std::string_view attributes = {});

/// JSON for a <script> of data: nothing in it ends the script or opens a comment.
std::string data(const nlohmann::ordered_json& json);

/// One column of a table.
struct Column {
  std::string heading;      ///< text, not markup
  bool is_number = true;    ///< set to the right
  bool is_heading = false;  ///< its cells name their rows
  bool is_whole = false;    ///< its cells are words that are not broken into lines
  bool may_go = false;      ///< left out where every cell is "–"
  bool is_answer = false;   ///< what the row is read for: on a narrow screen it stands right behind the row's name
};

/// A table whose head is repeated on each page of paper; a short one stays on one page. On a screen too narrow for its
/// columns each row of a wide one becomes a few lines, each value behind its column's heading.
class Table {
 public:
  Table(std::string_view caption, std::vector<Column> columns);
  /// Cells are text, not markup; as many as columns.
  void add(const std::vector<std::string>& cells);
  /// The same, with a class for the row and cells that are markup.
  void add_markup(const std::vector<std::string>& cells, std::string_view row_class = {});
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] std::string markup(std::string_view attributes = {}) const;

 private:
  std::string caption_;
  std::vector<Column> columns_;
  struct Row {
    std::vector<std::string> cells;  ///< markup
    std::string row_class;
  };
  std::vector<Row> rows_;
};

}  // namespace artcal::html
