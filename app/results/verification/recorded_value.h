#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/results/recorded/recorded_object.h"
#include "artefacts/verification/decision/budget.h"
#include "artefacts/verification/decision/decision.h"
#include "artefacts/verification/interim.h"
#include "artefacts/verification/place.h"

namespace artcal {

/// A value of a verification as its result has it (table "test_value" of docs/result-schema.md), mm and °C.
struct RecordedValue {
  static constexpr double not_there = std::numeric_limits<double>::quiet_NaN();

  std::string quantity, artefact, placement;
  std::string first, second;  ///< features; `second` of lengths only
  std::string repeat;
  std::optional<double> certified;  ///< at the reference temperature
  double stated = not_there;        ///< by the certificate; not of diameters, nor in results of earlier versions
  double stated_at = not_there;
  double value = 0.0;
  double temperature = not_there;
  std::optional<double> limit;
  double u = 0.0;                ///< standard uncertainty of the test value
  std::optional<Budget> budget;  ///< its parts; u(points) is 0 in results of earlier versions
  Verdict verdict = Verdict::NotJudged;
  bool set_aside = false;
  Place place;

  [[nodiscard]] bool is_length() const { return !second.empty(); }
  /// How near to its limit; where there is none, how large.
  [[nodiscard]] double severity() const;
};

/// The values of a verification, in their order. Throws NotAsInSchema.
std::vector<RecordedValue> recorded_values(const RecordedObject& verification);

/// The drifts of its interim check; nothing where it was none. Throws as that.
std::optional<std::vector<Drift>> recorded_drifts(const RecordedObject& verification);

}  // namespace artcal
