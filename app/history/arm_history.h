#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "acquisition/arm/arm.h"
#include "app/history/length_change.h"
#include "app/store/store.h"
#include "artefacts/verification/interim.h"

namespace artcal {

/// A parameter as a calibration left it, mm or rad.
struct CalibratedParameter {
  std::string name, unit, state;
  double value = 0.0;
  double u = 0.0;                                                       ///< standard uncertainty; 0 unless identified
  double degrees_of_freedom = std::numeric_limits<double>::infinity();  ///< effective, of u
};

/// What all results of a store have.
struct HistoryEntry {
  std::string recording;                  ///< name of the result
  std::string date;                       ///< of the measurement; empty: not stated
  std::string name;                       ///< of the recording
  std::vector<std::string> certificates;  ///< "ball bar "X", certificate 4711 of Laboratory", sorted
};

struct Calibration {
  HistoryEntry entry;
  std::optional<double> rms_before;  ///< mm; nothing where the readings cannot evaluate the nominal arm
  double rms_after = 0.0;            ///< mm
  std::vector<CalibratedParameter> parameters;
  Eigen::MatrixXd covariance;      ///< of the identified ones, in their order
  Eigen::MatrixXd unidentifiable;  ///< by all parameters, a column for each combination that no reading sees
  std::optional<Arm> arm;          ///< as identified; nothing where an earlier version of artcal stored the result
};

struct PastVerification {
  HistoryEntry entry;
  std::string standard;
  Conclusion conclusion = Conclusion::ConformityNotShown;
  std::vector<TestValue> values;  ///< with what compare() asks for
};

/// How a parameter changed from one calibration to the next.
struct ParameterChange {
  std::string name, unit;
  double then = 0.0, now = 0.0;
  double u = 0.0;            ///< √(u²(then) + u²(now))
  double limit = 0.0;        ///< significance_factor() of all changes, by the effective degrees of freedom of u
  double expanded = 0.0;     ///< k·u, k = 2 or Student's factor where larger
  bool significant = false;  ///< beyond `limit` times u
};

/// What changed between two calibrations of an arm. Parameters hang together: readings tell theta6 + a6/l, and which of
/// the two takes what depends on the value at which the other is fixed. Therefore the later one is compared in the
/// gauge of the earlier one (app/results/verification/gauge.h), where there is such a statement of it.
struct CalibrationStep {
  std::size_t then = 0, now = 0;  ///< into ArmHistory::calibrations
  std::string not_comparable;     ///< why not; empty where it is
  std::vector<std::string>
      moved;  ///< fixed parameters whose value differed; the later parameters are stated without it
  std::vector<ParameterChange> changes;
  double chi_squared = 0.0;             ///< of all changes together, by the sum of both covariances
  double limit = 0.0;                   ///< what chance stays below in 95 of 100 cases
  std::vector<std::string> in_common;   ///< certificates that both rest on
  std::optional<LengthChange> lengths;  ///< by how much measured lengths change; nothing where an arm is not known
  [[nodiscard]] bool significant() const { return chi_squared > limit; }
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
