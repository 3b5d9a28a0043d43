// A store whose rows anybody may have changed, asked for the history of an arm. The input's lines are the covariance of
// a calibration, its arm's file and what was not identifiable, then of each parameter its state, value, u and degrees
// of freedom, then of each value of a verification its words and numbers.
#include <algorithm>
#include <charconv>
#include <sstream>

#include <fmt/format.h>

#include "app/history/arm_history.h"
#include "app/store/shape.h"
#include "fuzz/check.h"

namespace {

using namespace artcal;

std::string line_of(std::istringstream& lines) {
  std::string line;
  std::getline(lines, line);
  return line;
}

// A file in one line of the input, its own lines apart by a bar.
std::string file_of(std::string line) {
  std::replace(line.begin(), line.end(), '|', '\n');
  return line;
}

StoreValue number_of(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end != text.data() ? StoreValue(value) : StoreValue();
}

/// A row of a table, made from the columns that the store has today.
class Row {
 public:
  explicit Row(StoreTable table) : table_(table), values_(shape_of(table).columns.size()) {
    for (std::size_t i = 0; i < values_.size(); ++i) {
      switch (shape_of(table).columns[i].kind) {
        case ColumnKind::Text: values_[i] = std::string(); break;
        case ColumnKind::Whole: values_[i] = 1LL; break;
        case ColumnKind::Real: values_[i] = 0.1; break;
      }
    }
  }
  Row& set(std::string_view column, StoreValue value) {
    const auto& columns = shape_of(table_).columns;
    const auto at = std::find_if(columns.begin(), columns.end(), [&](const auto& c) { return c.name == column; });
    fuzzing::require(at != columns.end());
    values_[static_cast<std::size_t>(at - columns.begin())] = std::move(value);
    return *this;
  }
  void put_into(StoreEntry& entry) const { entry[table_].push_back(values_); }

 private:
  StoreTable table_;
  StoreRow values_;
};

StoreEntry entry_of(const std::string& name, const std::string& text) {
  std::istringstream lines(text);
  StoreEntry entry;
  Row(StoreTable::Arms).set("arm", "arm").put_into(entry);
  Row(StoreTable::Recordings)
      .set("recording", name)
      .set("name", name)
      .set("measured_on", StoreValue())
      .set("arm", "arm")
      .set("exit_code", 0LL)
      .set("error", StoreValue())
      .put_into(entry);
  Row(StoreTable::Files).set("path", "/" + name).set("recording", name).set("exit_code", 0LL).put_into(entry);
  Row(StoreTable::Identifications)
      .set("recording", name)
      .set("covariance", line_of(lines))
      .set("arm_file", file_of(line_of(lines)))
      .set("unidentifiable", line_of(lines))
      .put_into(entry);
  for (long long i = 0; i < 3; ++i) {
    Row row(StoreTable::Parameters);
    row.set("recording", name).set("position", i).set("name", fmt::format("a{}", i)).set("unit", "mm");
    row.set("state", line_of(lines));
    if (const StoreValue identified = number_of(line_of(lines)); std::holds_alternative<double>(identified)) {
      row.set("identified", identified);
    }
    row.set("u", number_of(line_of(lines))).set("degrees_of_freedom", number_of(line_of(lines)));
    row.put_into(entry);
  }
  Row(StoreTable::Verifications)
      .set("recording", name)
      .set("standard", line_of(lines))
      .set("conclusion", line_of(lines))
      .put_into(entry);
  for (long long i = 0; i < 2; ++i) {
    Row row(StoreTable::VerificationValues);
    row.set("recording", name).set("position", i).set("quantity", line_of(lines)).set("verdict", line_of(lines));
    row.set("artefact", "bar")
        .set("placement", "1")
        .set("feature", "A")
        .set("other_feature", "B")
        .set("repetition", "1");
    for (const StoreColumn& column : shape_of(StoreTable::VerificationValues).columns) {
      if (column.kind == ColumnKind::Real) {
        const StoreValue value = number_of(line_of(lines));
        const std::string_view column_name = column.name;
        const bool may_be_null = column_name == "certified_mm" || column_name == "temperature_c" ||
                                 column_name == "limit_mm" || column_name == "degrees_of_freedom";
        row.set(column.name, may_be_null || std::holds_alternative<double>(value) ? value : StoreValue(0.0));
      }
    }
    row.put_into(entry);
  }
  return entry;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(fuzzing::bytes_of(data, size));
  static Store store = Store::open((fuzzing::folder().path() / "s.sqlite").string(), Database::Access::Write).value();
  const auto written = store.write({entry_of("0001", text), entry_of("0002", text)}, Known::Replace);
  if (!written) {
    return 0;  // refused by the tables themselves
  }
  const auto history = read_history(store, "arm");
  if (!history) {
    fuzzing::require_sentence(history.error());
    return 0;
  }
  for (const Calibration& calibration : history->calibrations) {
    fuzzing::require(calibration.covariance.allFinite());
  }
  return 0;
}
