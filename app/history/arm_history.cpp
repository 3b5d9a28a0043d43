#include "app/history/arm_history.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/result_names.h"
#include "core/in_quotes.h"

namespace artcal {
namespace {

std::string text_of(const StoreValue& value) {
  const auto* text = std::get_if<std::string>(&value);
  return text != nullptr ? *text : std::string();
}
double number_of(const StoreValue& value, double otherwise = 0.0) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? *number : otherwise;
}

/// Rows of queries, and the first error there was.
class Reader {
 public:
  explicit Reader(Store& store) : store_(store) {}
  std::vector<StoreRow> rows(const std::string& sql, const StoreRow& values = {}) {
    auto rows = store_.rows(sql, values);
    if (!rows) {
      error_ = error_ ? error_ : std::optional(rows.error());
      return {};
    }
    return std::move(*rows);
  }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  Store& store_;
  std::optional<Error> error_;
};

std::string certificate_in_words(const StoreRow& row) {
  std::string text = fmt::format("{} {}", text_of(row[1]), in_quotes(text_of(row[0])));
  if (!text_of(row[2]).empty()) {
    text += ", certificate " + at_most(60, text_of(row[2]));
  }
  if (!text_of(row[3]).empty()) {
    text += " of " + at_most(60, text_of(row[3]));
  }
  return text_of(row[4]).empty() ? text : text + ", " + text_of(row[4]);
}

HistoryEntry read_entry(Reader& reader, const StoreRow& row) {
  HistoryEntry entry{text_of(row[0]), text_of(row[1]), text_of(row[2]), {}};
  for (const StoreRow& certificate :
       reader.rows("SELECT a.name, a.type, c.number, c.laboratory, c.issued_on FROM used_certificates u "
                   "JOIN certificates c ON c.certificate = u.certificate JOIN artefacts a ON a.artefact = c.artefact "
                   "WHERE u.recording = :v0",
                   {entry.recording})) {
    entry.certificates.push_back(certificate_in_words(certificate));
  }
  std::sort(entry.certificates.begin(), entry.certificates.end());
  return entry;
}

// Rows up to the diagonal, as the store has them.
Eigen::MatrixXd matrix_of(const std::string& lower) {
  const auto rows = nlohmann::json::parse(lower, nullptr, false);
  const auto size = static_cast<Eigen::Index>(rows.is_array() ? rows.size() : 0);
  Eigen::MatrixXd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      matrix(i, j) = matrix(j, i) = rows.at(i).at(j).get<double>();
    }
  }
  return matrix;
}

std::vector<CalibratedParameter> read_parameters(Reader& reader, const std::string& recording) {
  std::vector<CalibratedParameter> parameters;
  for (const StoreRow& row :
       reader.rows("SELECT name, unit, state, identified, u FROM parameters WHERE recording = :v0 ORDER BY position",
                   {recording})) {
    parameters.push_back({text_of(row[0]), text_of(row[1]), text_of(row[2]), number_of(row[3]), number_of(row[4])});
  }
  return parameters;
}

std::vector<TestValue> read_values(Reader& reader, const std::string& recording) {
  std::vector<TestValue> values;
  for (const StoreRow& row : reader.rows(
           "SELECT quantity, artefact, placement, feature, other_feature, repetition, certified_mm, measured_mm, "
           "value_mm, "
           "u_calibration_mm, u_expansion_mm, u_temperature_mm, u_alignment_mm, u_fixture_mm, u_form_mm, set_aside, "
           "limit_mm, verdict "
           "FROM verification_values WHERE recording = :v0 ORDER BY position",
           {recording})) {
    TestValue value;
    value.quantity = quantity_named(text_of(row[0])).value_or(Quantity::LengthUni);
    value.artefact = text_of(row[1]);
    value.placement = text_of(row[2]);
    value.first = text_of(row[3]);
    value.second = text_of(row[4]);
    value.repeat = text_of(row[5]);
    value.certified = number_of(row[6]);
    value.measured = number_of(row[7]);
    value.value = number_of(row[8]);
    value.budget = {number_of(row[9]),  number_of(row[10]), number_of(row[11]),
                    number_of(row[12]), number_of(row[13]), number_of(row[14])};
    value.set_aside = std::get<long long>(row[15]) != 0;
    if (const auto* limit = std::get_if<double>(&row[16])) {
      value.limit = *limit;
    }
    value.verdict = verdict_named(text_of(row[17]));
    values.push_back(std::move(value));
  }
  return values;
}

constexpr const char* in_order = " WHERE r.arm = :v0 ORDER BY coalesce(r.measured_on, ''), r.name, r.recording";

void read_calibrations(Reader& reader, ArmHistory& history) {
  for (const StoreRow& row : reader.rows(
           std::string("SELECT r.recording, r.measured_on, r.name, i.rms_before_mm, i.rms_after_mm, i.covariance "
                       "FROM current_recordings r JOIN identifications i ON i.recording = r.recording") +
               in_order,
           {history.arm})) {
    history.calibrations.push_back({read_entry(reader, row), number_of(row[3]), number_of(row[4]),
                                    read_parameters(reader, text_of(row[0])), matrix_of(text_of(row[5]))});
  }
  for (std::size_t i = 1; i < history.calibrations.size(); ++i) {
    history.calibration_steps.push_back(step_between(history.calibrations[i - 1], history.calibrations[i]));
    history.calibration_steps.back().then = i - 1;
    history.calibration_steps.back().now = i;
  }
  for (std::size_t first = 0; first + 2 < history.calibrations.size(); ++first) {
    CalibrationStep step = step_between(history.calibrations[first], history.calibrations.back());
    if (step.not_comparable.empty()) {
      step.then = first;
      step.now = history.calibrations.size() - 1;
      history.calibrations_overall = std::move(step);
      break;
    }
  }
}

std::map<std::string, std::vector<std::size_t>> by_standard(const std::vector<PastVerification>& all) {
  std::map<std::string, std::vector<std::size_t>> places;
  for (std::size_t i = 0; i < all.size(); ++i) {
    places[all[i].standard].push_back(i);
  }
  return places;
}

void read_verifications(Reader& reader, ArmHistory& history) {
  auto& all = history.verifications;
  for (const StoreRow& row :
       reader.rows(std::string("SELECT r.recording, r.measured_on, r.name, v.standard, v.conclusion "
                               "FROM current_recordings r JOIN verifications v ON v.recording = r.recording") +
                       in_order,
                   {history.arm})) {
    all.push_back({read_entry(reader, row), text_of(row[3]), conclusion_named(text_of(row[4])),
                   read_values(reader, text_of(row[0]))});
  }
  for (const auto& [standard, places] : by_standard(all)) {
    for (std::size_t i = 1; i < places.size(); ++i) {
      history.verification_steps.push_back(step_between(all, places[i - 1], places[i]));
    }
    if (places.size() > 2) {
      history.verifications_overall.push_back(step_between(all, places.front(), places.back()));
    }
  }
}

std::string arms_in_words(Reader& reader) {
  std::string text;
  for (const StoreRow& row : reader.rows("SELECT arm FROM arms ORDER BY arm LIMIT 12")) {
    text += (text.empty() ? "" : ", ") + in_quotes(text_of(row[0]));
  }
  return text.empty() ? "none" : text;
}

}  // namespace

Expected<ArmHistory> read_history(Store& store, const std::string& arm) {
  Reader reader(store);
  ArmHistory history;
  history.arm = arm;
  const auto whole = store.in_snapshot([&] {
    read_calibrations(reader, history);
    read_verifications(reader, history);
  });
  if (!whole) {
    return tl::unexpected(whole.error());
  }
  if (history.calibrations.empty() && history.verifications.empty() && !reader.error()) {
    return bad_input(
        fmt::format("no result is of an arm called {}; the store has {}", in_quotes(arm), arms_in_words(reader)),
        store.name());
  }
  if (reader.error()) {
    return tl::unexpected(*reader.error());
  }
  return history;
}

}  // namespace artcal
