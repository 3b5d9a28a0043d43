#pragma once

#include <string>
#include <vector>

#include "artefacts/simulation/simulate.h"
#include "core/error.h"

namespace artcal {

/// A mistake of measuring that a virtual session is to contain.
struct PlantedMistake {
  enum class Kind {
    JointsExchanged,  ///< "joints:2,3": the driver hands two joints on in the wrong order
    JointSign,        ///< "sign:3": it hands a joint on with the other sign
    EncoderSlipped,   ///< "slip:4,30": from the middle of the session on an encoder reads so many deg more
    ArtefactMoved,    ///< "moved:12": in the middle of a placement the artefact is pushed by so many mm
    WrongFeature,     ///< "wrong-feature": in one placement the touches of one ball are on another
  };
  Kind kind = Kind::JointsExchanged;
  int first = 0, second = 0;  ///< joints, from 0
  double size = 0.0;          ///< rad or mm
};

/// Usage: a text that is none of those above; `joints` is the arm's number of them.
Expected<PlantedMistake> parse_mistake(const std::string& text, int joints);

/// Puts what happens while measuring into the readings of a plan: slip, motion, wrong feature. Readings that the arm
/// would not reach any more are looked for in another placement. Usage: the plan has no room for the mistake.
Expected<void> plant(const PlantedMistake& mistake, const SimulationPlan& plan, Simulation& simulation);

/// What the driver hands on of the joints that the encoders have: exchanged joints, signs.
Eigen::VectorXd handed_on(const std::vector<PlantedMistake>& mistakes, Eigen::VectorXd joints);

}  // namespace artcal
