#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "artefacts/verification/decision/decision.h"
#include "artefacts/verification/decision/evidence.h"
#include "artefacts/verification/decision/limit.h"

namespace artcal {

/// The quantities that a limit can be stated for, as the standards' symbols begin.
enum class Quantity {
  SizeError,           ///< P_Size: diameter of a ball
  FormError,           ///< P_Form: range of its radial residuals
  SizeErrorAll,        ///< P_Size.Sph.All: diameter of a scanned ball, of all its points
  FormErrorD95,        ///< P_Form.Sph.D95%: range of the narrowest 95 % of its radial residuals
  LocationDiameter,    ///< L_Dia: spread of its centre over the wrist's orientations
  LengthUni,           ///< E_Uni: a length between two like-sided features, such as balls
  LengthBi,            ///< E_Bi: a length between two faces that look away from or at each other
  EffectiveDiameter,   ///< B89.4.22: diameter of a ball
  Articulation,        ///< B89.4.22: single-point articulation (SPAT), range of deviations
  ArticulationSpread,  ///< B89.4.22: SPAT, 2·s
  Volumetric,          ///< B89.4.22: a length of the ball bar
};

/// "E_Uni": the name in specification files and results.
const char* name_of(Quantity quantity);
std::optional<Quantity> quantity_named(const std::string& name);
/// Whether its values are errors, above or below zero; a range, a diameter of a spread and 2·s have no sign.
bool is_signed(Quantity quantity);
/// All of these names, for a message.
std::string quantity_names();

/// One position of the artefact of lengths, and what is to be measured there.
struct PlannedPosition {
  std::string placement;                                     ///< label; empty: any that no other asks for
  std::vector<std::pair<std::string, std::string>> lengths;  ///< pairs of features; empty: any
};

/// What must be measured. Zero: nothing is asked. These numbers are data, never code: they come from the
/// specification file.
struct TestPlan {
  int sphere_positions = 0;  ///< of the single ball
  int points = 0;            ///< on it, for P_Size and P_Form
  int orientations = 0;      ///< of the wrist, for L_Dia
  int points_per_orientation = 0;
  int lengths = 0;  ///< different ones in each position
  int positions = 0;
  int repeats = 0;
  double longest_share = 0.0;          ///< of the measuring range that the longest length must reach
  std::vector<PlannedPosition> named;  ///< where single positions are prescribed
  int effective_diameter_repeats = 0;  ///< B89.4.22
  int articulation_positions = 0;
  int articulation_readings = 0;
  int volumetric_lengths = 0;
};

/// One bad value among repeats may be measured again. Zero sets: none may.
struct OutlierRule {
  int sets = 0;    ///< how many sets of repeats may hold bad values
  int values = 0;  ///< in each of them
  int again = 0;   ///< times such a length is measured again, all of which must conform
};

/// What an arm is verified against. Format: docs/files.md, "specification.toml". Lengths in mm.
struct Specification {
  std::string name;
  std::map<Quantity, Limit> limits;
  DecisionRule rule = DecisionRule::Iso14253_2017;
  std::optional<double> measuring_range;                          ///< mm
  std::optional<double> lowest_temperature, highest_temperature;  ///< rated conditions, °C
  std::optional<double> u_temperature;  ///< standard uncertainty of the artefact's temperature, K
  double u_alignment = 0.0;             ///< mm
  double u_fixture = 0.0;               ///< mm
  std::optional<TestPlan> plan;
  OutlierRule outliers;
  std::set<Evidence>
      waived;  ///< conformity may be stated without these; whoever writes the specification answers for it
};

}  // namespace artcal
