#pragma once

#include "acquisition/recording/recording.h"
#include "acquisition/recording/tip_centres.h"
#include "artefacts/constraints/constraint.h"
#include "artefacts/verification/decision/budget.h"
#include "artefacts/verification/decision/specification.h"

namespace artcal {

/// Everything an evaluation reads. Refers to what its maker keeps.
struct Session {
  const Recording& recording;
  const Constraints& constraints;  ///< which reading is on which feature
  const Arm& arm;                  ///< that the tips were computed with; places are told by it
  const TipCentres& tips;
  const Specification& specification;
  /// How that arm was identified; null where nothing is known of it, or where the arm was not used (tips as reported).
  const ArmIdentification* identification = nullptr;
};

/// Readings of one feature in one go: the same placement, repeat and orientation of the wrist.
struct Touched {
  int artefact = 0;   ///< into Constraints::artefacts
  int placement = 0;  ///< into Recording::placements
  int feature = 0;    ///< into Artefact::features
  int orientation = 0, repeat = 0;
  std::vector<int> readings;

  [[nodiscard]] bool operator==(const Touched&) const = default;
};

/// What keeps readings of one feature in one placement apart beside the repeat.
enum class Orientations { Apart, Together };

/// In order of appearance. With orientations together, that of the first reading stands for all.
std::vector<Touched> touched_features(const Session& session, Orientations orientations);

/// Whether points of a scan are among these readings.
bool is_scanned(const Session& session, const std::vector<int>& readings);

/// Mean temperature of what was read there, °C; NaN where no reading says.
double mean_temperature(const Session& session, const std::vector<int>& readings);

/// What the artefact's lengths do at that temperature; nothing where it is not known.
ThermalState thermal_state(const Session& session, const Artefact& artefact, double temperature);

/// L(T)/L(T_ref), 1 where the temperature is not known.
double expansion_factor_or_one(const Artefact& artefact, double temperature);

}  // namespace artcal
