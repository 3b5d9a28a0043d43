#include "app/batch/result_rows.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "acquisition/arm/arm_file.h"
#include "app/results/identification/coupling_json.h"
#include "app/results/result_names.h"
#include "app/version.h"
#include "artefacts/artefact/artefact_type.h"
#include "core/files/hash.h"
#include "core/statistics.h"

namespace artcal {
namespace {

StoreValue text_or_null(const std::string& text) { return text.empty() ? StoreValue() : StoreValue(text); }
StoreValue stored_number(double value) { return std::isfinite(value) ? StoreValue(value) : StoreValue(); }
long long stored_whole(auto value) { return static_cast<long long>(value); }

std::string name_of_content(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) {
    text += std::string(part) + '\0';
  }
  return sha256(text).substr(0, 32);
}

void add_artefact(StoreRows& rows, const std::string& key, const Artefact& artefact) {
  const Certificate& certificate = artefact.certificate;
  const std::string type(name_of(artefact.type));
  const std::string artefact_id = name_of_content({artefact.name, type});
  const std::string certificate_id = name_of_content(
      {artefact_id, certificate.number, certificate.laboratory, certificate.date, certificate.valid_until});
  rows[StoreTable::Artefacts].push_back({artefact_id, artefact.name, type});
  rows[StoreTable::Certificates].push_back({certificate_id, artefact_id, text_or_null(certificate.number),
                                            text_or_null(certificate.laboratory), text_or_null(certificate.date),
                                            text_or_null(certificate.valid_until)});
  rows[StoreTable::UsedCertificates].push_back({key, certificate_id});
}

// Rows up to the diagonal, every digit.
std::string lower_triangle(const Eigen::MatrixXd& matrix) {
  std::string text = "[";
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    text += i > 0 ? ",[" : "[";
    for (Eigen::Index j = 0; j <= i; ++j) {
      text += fmt::format("{}{}", j > 0 ? "," : "", matrix(i, j));
    }
    text += "]";
  }
  return text + "]";
}

// [{"a6":1,"theta6":-0.00545}]: of each combination its parameters, in mm and rad.
std::string combinations_text(const Coupling& coupling) {
  nlohmann::ordered_json combinations = nlohmann::ordered_json::array();
  for (const ParameterMotion& motion : coupling.unidentifiable) {
    combinations.push_back(motion_json(coupling, motion));
  }
  return combinations.dump();
}

StoreValue rms_left_out(const Identification& result) {
  double sum = 0.0;
  int readings = 0;
  for (const LeftOut& left : result.left_out) {
    sum += left.deviation.rms * left.deviation.rms * left.deviation.readings;
    readings += left.deviation.readings;
  }
  return readings > 0 ? StoreValue(std::sqrt(sum / readings)) : StoreValue();
}

StoreRow value_row(const std::string& key, std::size_t position, const TestValue& value) {
  const Budget& budget = value.budget;
  return {key,
          stored_whole(position),
          std::string(name_of(value.quantity)),
          value.artefact,
          value.placement,
          value.first,
          text_or_null(value.second),
          value.repeat,
          value.certified > 0.0 ? StoreValue(value.certified) : StoreValue(),
          value.measured,
          value.value,
          stored_number(value.temperature),
          value.limit ? StoreValue(*value.limit) : StoreValue(),
          budget.total(),
          budget.calibration,
          budget.expansion,
          budget.temperature,
          budget.alignment,
          budget.fixture,
          budget.form,
          std::string(result_name(value.verdict)),
          stored_whole(value.set_aside),
          budget.points,
          stored_number(budget.degrees_of_freedom()),
          stated_coverage_factor(budget.degrees_of_freedom())};
}

}  // namespace

void add_recording(StoreRows& rows, const std::string& key, const std::string& options, const Recording& recording,
                   const Constraints& constraints, const std::vector<InputFile>& inputs) {
  rows[StoreTable::Arms].push_back({recording.arm.name});
  rows[StoreTable::Recordings].push_back({key, std::string(program_version), options, recording.name,
                                          text_or_null(recording.date), recording.arm.name,
                                          stored_whole(recording.readings.size()), 0LL, StoreValue()});
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    rows[StoreTable::Inputs].push_back({key, stored_whole(i), inputs[i].path, inputs[i].sha256});
  }
  for (const Artefact& artefact : constraints.artefacts) {
    add_artefact(rows, key, artefact);
  }
}

void add_identification(StoreRows& rows, const std::string& key, const Identification& result) {
  rows[StoreTable::Identifications].push_back(
      {key, stored_whole(result.coupling.rank), result.noise, stored_whole(result.noise_is_given), result.chi_squared,
       stored_whole(result.degrees_of_freedom), result.scale_factor, stored_number(result.before.overall.rms),
       stored_number(result.before.overall.maximum), result.after.overall.rms, result.after.overall.maximum,
       rms_left_out(result), stored_whole(result.outliers.size()), lower_triangle(result.covariance),
       arm_file_text(result.arm, std::nullopt), combinations_text(result.coupling)});
  for (std::size_t i = 0; i < result.parameters.size(); ++i) {
    const IdentifiedParameter& parameter = result.parameters[i];
    const bool identified = parameter.state == ParameterState::Identified || parameter.state == ParameterState::Weak;
    rows[StoreTable::Parameters].push_back({key, stored_whole(i), parameter.parameter.name,
                                            std::string(parameter.parameter.unit()),
                                            std::string(result_name(parameter.state)), parameter.nominal,
                                            parameter.identified, identified ? StoreValue(parameter.u) : StoreValue(),
                                            identified ? stored_number(parameter.degrees_of_freedom) : StoreValue(),
                                            identified ? StoreValue(parameter.coverage_factor()) : StoreValue()});
  }
}

void add_verification(StoreRows& rows, const std::string& key, const VerificationResult& result,
                      const std::string& specification) {
  const Verification& verification = result.verification;
  rows[StoreTable::Verifications].push_back({key, verification.standard, text_or_null(specification),
                                             std::string(text_of(verification.rule)),
                                             std::string(result_name(verification.conclusion))});
  for (std::size_t i = 0; i < verification.values.size(); ++i) {
    rows[StoreTable::VerificationValues].push_back(value_row(key, i, verification.values[i]));
  }
}

void add_remarks(StoreRows& rows, const std::string& key, const std::string& kind,
                 const std::vector<std::string>& texts) {
  auto& remarks = rows[StoreTable::Remarks];
  for (const std::string& text : texts) {
    const bool known = std::any_of(remarks.begin(), remarks.end(), [&](const StoreRow& row) {
      return std::get<std::string>(row[2]) == kind && std::get<std::string>(row[3]) == text;
    });
    if (!known) {
      remarks.push_back({key, stored_whole(remarks.size()), kind, text});
    }
  }
}

}  // namespace artcal
