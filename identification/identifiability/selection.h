#pragma once

#include <string>
#include <vector>

#include "acquisition/arm/arm.h"
#include "core/error.h"
#include "identification/identifiability/coupling.h"
#include "identification/models/model.h"

namespace artcal {

/// Two parameters of the last joint of which readings determine only one sum where α is ±90° and a is zero (Gao 2013
/// Eq. 10, 11, signs put right): θn + an/l and αn − dn/l. Only a standard-DH arm has them; `first` is a or d. Whether
/// they are a pair for the arm and the readings at hand is computed (Coupling), not taken from here.
struct WristPair {
  std::string first, second;
};
std::vector<WristPair> wrist_pairs(const Arm& arm);

/// What is asked for, before the readings have been heard.
struct Selection {
  std::vector<std::string> fixed;        ///< by request: taken as known
  std::vector<std::string> fixed_first;  ///< fixed by preference where they take part in an unidentifiable direction
  std::vector<std::string> rather_free;  ///< requested to be identified
  std::vector<std::string> beside;  ///< radii of tips and joint errors that are parameters here: all others are known
  /// What the model's groups add, without what is held.
  struct Group {
    ParameterGroup group = ParameterGroup::Eccentricity;
    std::vector<std::string> members;
  };
  std::vector<Group> groups;
};

/// Sorts the requests. Of a wrist pair the first member (a, d) is preferred for fixing, or the second where `free`
/// names the first. `arm` is that of the model (arm_for). Usage error: an unknown name, one in both lists, a whole pair
/// in `free` where this arm's tip never separates the two, a group all of whose members are held.
Expected<Selection> select_parameters(const Arm& arm, const std::vector<std::string>& hold,
                                      const std::vector<std::string>& free, const Model& model = {});

/// The same without what the model's groups add: what brings an arm near its readings first.
Selection of_chain(const Selection& selection);

/// The coupling analysis that goes with a selection.
CouplingOptions coupling_options(const Selection& selection);

/// The parameters to identify: all but one for each unidentifiable direction, so that their number is the rank.
/// No solution: a parameter requested to be free is unidentifiable; all members of a group are. Single members that the
/// readings do not identify, alone or in combination with other parameters, are fixed like any unidentifiable
/// parameter.
Expected<std::vector<Parameter>> free_parameters(const Selection& selection, const Coupling& coupling);

}  // namespace artcal
