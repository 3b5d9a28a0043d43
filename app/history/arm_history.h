#pragma once

#include <optional>
#include <string>
#include <vector>

#include "acquisition/arm/arm.h"
#include "app/history/length_change.h"
#include "app/results/drift/parameter_comparison.h"
#include "app/store/store.h"
#include "artefacts/verification/interim.h"

namespace artcal {

/// What all results of a store have.
struct HistoryEntry {
  std::string recording;                  ///< name of the result
  std::string date;                       ///< of the measurement; empty: not stated
  std::string name;                       ///< of the recording
  std::vector<std::string> certificates;  ///< "ball bar "X", certificate 4711 of Laboratory", sorted
};

struct Calibration : CalibratedParameters {
  HistoryEntry entry;
  std::optional<double> rms_before;  ///< mm; nothing where the readings cannot evaluate the nominal arm
  double rms_after = 0.0;            ///< mm
  std::optional<Arm> arm;            ///< as identified; nothing where an earlier version of artcal stored the result
};

struct PastVerification {
  HistoryEntry entry;
  std::string standard;
  Conclusion conclusion = Conclusion::ConformityNotShown;
  std::vector<TestValue> values;  ///< with what compare() asks for
};

/// What changed between two calibrations of an arm.
struct CalibrationStep : ParameterComparison {
  std::size_t then = 0, now = 0;        ///< into ArmHistory::calibrations
  std::vector<std::string> in_common;   ///< certificates that both rest on
  std::optional<LengthChange> lengths;  ///< by how much measured lengths change; nothing where an arm is not known
};

/// What changed between two verifications by the same standard.
struct VerificationStep {
  std::size_t then = 0, now = 0;  ///< into ArmHistory::verifications
  InterimCheck check;
  std::vector<std::string> in_common;

  /// How many changes can be called significant or not: those of quantities that were repeated.
  [[nodiscard]] std::size_t told() const;
  [[nodiscard]] std::size_t significant() const;
};

/// "3 of 35 values changed significantly; 6 that were not repeated are not judged".
std::string change_in_words(const VerificationStep& step);

/// An arm over time, by the results that stand (docs/store.md), the oldest first; those without a date before all.
struct ArmHistory {
  std::string arm;
  std::vector<Calibration> calibrations;
  std::vector<PastVerification> verifications;
  std::vector<CalibrationStep> calibration_steps;
  std::vector<VerificationStep> verification_steps;
  /// From the first to the last, where others lie between: a slow drift may be significant over all and in no step.
  std::optional<CalibrationStep> calibrations_overall;  ///< from the first that is comparable with the last
  std::vector<VerificationStep> verifications_overall;  ///< one a standard
};

/// Refused: an arm that no result of the store is of; the arms that there are, are named.
Expected<ArmHistory> read_history(Store& store, const std::string& arm);

/// What changed from `then` to `now`.
CalibrationStep step_between(const Calibration& then, const Calibration& now);

/// The same of verifications, by their places among all.
VerificationStep step_between(const std::vector<PastVerification>& all, std::size_t then, std::size_t now);

}  // namespace artcal
