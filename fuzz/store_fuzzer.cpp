// A store whose rows anybody may have changed, asked for the history of an arm. The input's lines are the covariance of
// a calibration, then of each parameter its state, value, u and degrees of freedom, then of each value of a
// verification its words and numbers.
#include <charconv>
#include <sstream>

#include <fmt/format.h>

#include "app/history/arm_history.h"
#include "fuzz/check.h"

namespace {

using namespace artcal;

std::string line_of(std::istringstream& lines) {
  std::string line;
  std::getline(lines, line);
  return line;
}

StoreValue number_of(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end != text.data() ? StoreValue(value) : StoreValue();
}

StoreEntry entry_of(const std::string& name, const std::string& text) {
  std::istringstream lines(text);
  StoreEntry entry;
  entry[StoreTable::Arms] = {{std::string("arm")}};
  entry[StoreTable::Recordings] = {{name, std::string("1"), std::string(), name, {}, std::string("arm"), 1LL, 0LL, {}}};
  entry[StoreTable::Files] = {{"/" + name, name, 0LL, {}}};
  entry[StoreTable::Identifications] = {
      {name, 1LL, 0.1, 1LL, 1.0, 1LL, 1.0, 0.1, 0.1, 0.1, 0.1, {}, 0LL, line_of(lines)}};
  for (long long i = 0; i < 3; ++i) {
    const std::string state = line_of(lines), value = line_of(lines), u = line_of(lines), freedom = line_of(lines);
    const StoreValue identified = number_of(value);
    entry[StoreTable::Parameters].push_back({name, i, fmt::format("a{}", i), std::string("mm"), state, 0.0,
                                             std::holds_alternative<double>(identified) ? identified : StoreValue(0.0),
                                             number_of(u), number_of(freedom), 2.0});
  }
  entry[StoreTable::Verifications] = {{name, line_of(lines), {}, std::string("simple"), line_of(lines)}};
  for (long long i = 0; i < 2; ++i) {
    const std::string quantity = line_of(lines), verdict = line_of(lines);
    StoreRow row{
        name, i, quantity, std::string("bar"), std::string("1"), std::string("A"), std::string("B"), std::string("1")};
    for (int j = 0; j < 12; ++j) {
      const StoreValue value = number_of(line_of(lines));
      const bool may_be_null = j == 0 || j == 3 || j == 4;  // certified, temperature, limit
      row.push_back(may_be_null || std::holds_alternative<double>(value) ? value : StoreValue(0.0));
    }
    row.emplace_back(verdict);
    row.emplace_back(0LL);
    row.insert(row.end(), {0.001, StoreValue(), 2.0});  // u(points), degrees of freedom, coverage factor
    entry[StoreTable::VerificationValues].push_back(std::move(row));
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
