#include "app/history/arm_history.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "acquisition/arm/arm_text.h"
#include "app/history/store_reader.h"
#include "app/results/result_names.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

std::string certificate_in_words(const StoreRow& row) {
  std::string text = fmt::format("{} {}", text_or_empty(row[1]), in_quotes(text_or_empty(row[0])));
  if (!text_or_empty(row[2]).empty()) {
    text += ", certificate " + truncated(60, text_or_empty(row[2]));
  }
  if (!text_or_empty(row[3]).empty()) {
    text += " of " + truncated(60, text_or_empty(row[3]));
  }
  return text_or_empty(row[4]).empty() ? text : text + ", " + text_or_empty(row[4]);
}

HistoryEntry read_entry(StoreReader& reader, const StoreRow& row) {
  HistoryEntry entry{text_or_empty(row[0]), text_or_empty(row[1]), text_or_empty(row[2]), {}};
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

double noise_freedom(const StoreValue& is_given, const StoreValue& degrees_of_freedom) {
  const auto* given = std::get_if<long long>(&is_given);
  const auto* freedom = std::get_if<long long>(&degrees_of_freedom);
  const bool is_estimated = given != nullptr && *given == 0 && freedom != nullptr && *freedom > 0;
  return is_estimated ? static_cast<double>(*freedom) : std::numeric_limits<double>::infinity();
}

// Rows of earlier versions have no coverage factor and no degrees of freedom but those of the noise.
double parameter_freedom(StoreReader& reader, const StoreValue& of_parameter, const StoreValue& coverage_factor,
                         double of_noise) {
  if (std::holds_alternative<std::monostate>(coverage_factor)) {
    return of_noise;
  }
  const double freedom = reader.optional_number(of_parameter, "degrees of freedom of a parameter")
                             .value_or(std::numeric_limits<double>::infinity());
  if (!(freedom > 0.0)) {
    reader.fail(fmt::format("the degrees of freedom of a parameter are {}", freedom));
    return of_noise;
  }
  return freedom;
}

std::vector<CalibratedParameter> read_parameters(StoreReader& reader, const std::string& recording, double of_noise) {
  std::vector<CalibratedParameter> parameters;
  for (const StoreRow& row :
       reader.rows("SELECT name, unit, state, identified, u, degrees_of_freedom, coverage_factor FROM parameters "
                   "WHERE recording = :v0 ORDER BY position",
                   {recording})) {
    CalibratedParameter parameter{text_or_empty(row[0]), text_or_empty(row[1]), text_or_empty(row[2]),
                                  reader.number(row[3], "parameter")};
    if (is_identified(parameter)) {
      parameter.u = reader.number(row[4], "standard uncertainty of a parameter");
      parameter.degrees_of_freedom = parameter_freedom(reader, row[5], row[6], of_noise);
    } else if (parameter.state != result_name(ParameterState::Fixed) &&
               parameter.state != result_name(ParameterState::Unidentifiable)) {
      reader.fail(fmt::format("the state of a parameter is {}", in_quotes(parameter.state)));
    }
    parameters.push_back(std::move(parameter));
  }
  return parameters;
}

// Of u(points), by those of the whole u: all other parts are known (Welch, Satterthwaite).
void set_degrees_of_freedom(const std::optional<double>& of_total, Budget& budget) {
  if (of_total && *of_total > 0.0 && budget.points > 0.0) {
    budget.points_freedom = *of_total * std::pow(budget.points / budget.total(), 4);
  }
}

TestValue read_value(StoreReader& reader, const StoreRow& row) {
  TestValue value;
  const auto quantity = quantity_named(text_or_empty(row[0]));
  if (!quantity) {
    reader.fail(fmt::format("the quantity of a value is {}", in_quotes(text_or_empty(row[0]))));
  }
  value.quantity = quantity.value_or(Quantity::LengthUni);
  value.artefact = text_or_empty(row[1]);
  value.placement = text_or_empty(row[2]);
  value.first = text_or_empty(row[3]);
  value.second = text_or_empty(row[4]);
  value.repeat = text_or_empty(row[5]);
  value.certified = reader.optional_number(row[6], "certified value").value_or(0.0);
  value.measured = reader.number(row[7], "measured value");
  value.value = reader.number(row[8], "value");
  std::array<double, 7> u{};
  for (std::size_t i = 0; i < u.size(); ++i) {
    u[i] = reader.number(row[9 + i], "standard uncertainty of a value");
  }
  value.budget = {u[0], u[1], u[2], u[3], u[4], u[5], u[6]};
  set_degrees_of_freedom(reader.optional_number(row[19], "degrees of freedom of a value"), value.budget);
  value.set_aside = reader.truth(row[16], "set_aside");
  value.limit = reader.optional_number(row[17], "limit");
  value.verdict = verdict_named(text_or_empty(row[18]));
  return value;
}

std::vector<TestValue> read_values(StoreReader& reader, const std::string& recording) {
  std::vector<TestValue> values;
  for (const StoreRow& row : reader.rows("SELECT quantity, artefact, placement, feature, other_feature, repetition, "
                                         "certified_mm, measured_mm, value_mm, u_calibration_mm, u_expansion_mm, "
                                         "u_temperature_mm, u_alignment_mm, u_fixture_mm, u_form_mm, u_points_mm, "
                                         "set_aside, limit_mm, verdict, degrees_of_freedom "
                                         "FROM verification_values WHERE recording = :v0 ORDER BY position",
                                         {recording})) {
    values.push_back(read_value(reader, row));
  }
  return values;
}

Calibration read_calibration(StoreReader& reader, const StoreRow& row) {
  Calibration calibration;
  calibration.entry = read_entry(reader, row);
  reader.set_recording(calibration.entry.recording);
  calibration.rms_before = reader.optional_number(row[3], "rms before");
  calibration.rms_after = reader.number(row[4], "rms after");
  calibration.parameters = read_parameters(reader, calibration.entry.recording, noise_freedom(row[6], row[7]));
  const auto identified = std::count_if(calibration.parameters.begin(), calibration.parameters.end(), is_identified);
  calibration.covariance = reader.covariance(row[5], static_cast<std::size_t>(identified));
  if (const std::string text = text_or_empty(row[8]); !text.empty()) {
    if (auto arm = arm_of_text(text, "arm_file")) {
      calibration.arm = std::move(*arm);
    } else {
      reader.fail("its arm is none: " + truncated(200, arm.error().message));
    }
  }
  std::vector<std::string> names;
  for (const CalibratedParameter& parameter : calibration.parameters) {
    names.push_back(parameter.name);
  }
  calibration.unidentifiable = reader.combinations(row[9], names);
  return calibration;
}

constexpr const char* in_order = " WHERE r.arm = :v0 ORDER BY coalesce(r.measured_on, ''), r.name, r.recording";

void read_calibrations(StoreReader& reader, ArmHistory& history) {
  for (const StoreRow& row : reader.rows(
           std::string("SELECT r.recording, r.measured_on, r.name, i.rms_before_mm, i.rms_after_mm, i.covariance, "
                       "i.noise_is_given, i.degrees_of_freedom, i.arm_file, i.unidentifiable "
                       "FROM current_recordings r JOIN identifications i ON i.recording = r.recording") +
               in_order,
           {history.arm})) {
    history.calibrations.push_back(read_calibration(reader, row));
  }
  if (reader.error()) {
    return;  // covariances that do not fit their parameters are not computed with
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

void read_verifications(StoreReader& reader, ArmHistory& history) {
  auto& all = history.verifications;
  for (const StoreRow& row :
       reader.rows(std::string("SELECT r.recording, r.measured_on, r.name, v.standard, v.conclusion "
                               "FROM current_recordings r JOIN verifications v ON v.recording = r.recording") +
                       in_order,
                   {history.arm})) {
    reader.set_recording(text_or_empty(row[0]));
    all.push_back({read_entry(reader, row), text_or_empty(row[3]), conclusion_named(text_or_empty(row[4])),
                   read_values(reader, text_or_empty(row[0]))});
  }
  if (reader.error()) {
    return;
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

std::string arms_in_words(StoreReader& reader) {
  std::string text;
  for (const StoreRow& row : reader.rows("SELECT arm FROM arms ORDER BY arm LIMIT 12")) {
    text += (text.empty() ? "" : ", ") + in_quotes(text_or_empty(row[0]));
  }
  return text.empty() ? "none" : text;
}

}  // namespace

Expected<ArmHistory> read_history(Store& store, const std::string& arm) {
  StoreReader reader(store);
  ArmHistory history;
  history.arm = arm;
  const auto whole = store.in_snapshot([&] {
    read_calibrations(reader, history);
    read_verifications(reader, history);
  });
  if (!whole) {
    return tl::unexpected(whole.error());
  }
  if (reader.error()) {
    return tl::unexpected(*reader.error());
  }
  if (history.calibrations.empty() && history.verifications.empty()) {
    return bad_input(
        fmt::format("no result is of an arm called {}; the store has {}", in_quotes(arm), arms_in_words(reader)),
        store.name());
  }
  return history;
}

}  // namespace artcal
