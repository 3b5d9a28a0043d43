#pragma once

#include <string>
#include <vector>

#include "acquisition/arm.h"
#include "core/error.h"
#include "identification/coupling.h"

namespace artcal {

/// Two parameters of the last joint of which readings tell only one sum (Gao 2013 Eq. 10, 11, signs put
/// right): θn + an/l and αn − dn/l. Only a standard-DH arm has them; `first` is a or d.
struct WristPair {
  std::string first, second;
};
std::vector<WristPair> wrist_pairs(const Arm& arm);

/// What is asked for, before the readings have been heard.
struct Selection {
  std::vector<std::string> held;         ///< by request: taken as known
  std::vector<std::string> pair_held;    ///< the member of each wrist pair that is held in any case
  std::vector<std::string> rather_free;  ///< requested to be identified
  std::vector<std::string> radii;        ///< of these, the radii of tips: all others are known
};

/// Sorts the requests. Of a wrist pair the first member (a, d) is held, or the second where `free` names
/// the first or `hold` names the second. Usage error: an unknown name, one in both lists, a whole pair in
/// `free`.
Expected<Selection> select_parameters(const Arm& arm, const std::vector<std::string>& hold,
                                      const std::vector<std::string>& free);

/// The coupling analysis that goes with a selection.
CouplingOptions coupling_options(const Selection& selection);

/// Names of the parameters to identify, given what the readings cannot tell.
/// No solution: a parameter requested to be free is lost.
Expected<std::vector<Parameter>> free_parameters(const Selection& selection, const Coupling& coupling);

}  // namespace artcal
