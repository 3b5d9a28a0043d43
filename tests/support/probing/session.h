#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "artefacts/artefact/artefact.h"
#include "artefacts/constraints/constraint.h"
#include "tests/support/probing/chain.h"

namespace artcal::probing {

enum class Kind { Bar2, Bar3, Bar4, Plate, Ball, Seats, StepGauge, Planes, Mixed };
inline constexpr Kind all_kinds[] = {Kind::Bar2,  Kind::Bar3,      Kind::Bar4,   Kind::Plate, Kind::Ball,
                                     Kind::Seats, Kind::StepGauge, Kind::Planes, Kind::Mixed};
const char* name_of(Kind kind);

/// How a session is probed, as people probe or not.
struct Probing {
  Kind kind = Kind::Bar4;
  int placements = 7;
  double stylus_within = 30.0;  ///< degrees between the stylus and the inward normal at the contact; 180: any direction
  double cap = 90.0;            ///< degrees from the pole of a ball to the rim of what is touched of it
  double noise = 0.015;         ///< mm a coordinate of the tip
  double rough = 1.0;           ///< the nominal arm is off by this times 0.3 mm and 0.1 degrees (normal)
  double last_alpha = 90.0;     ///< degrees, of the nominal arm's last joint
  int wrong_labels = 0;         ///< readings that carry the name of another feature of their placement
  std::uint64_t seed = 1;
};

struct Touch {
  int artefact = 0, placement = 0, feature = 0;
  Eigen::VectorXd q;
};

/// A true arm, a nominal one, and what the true one read.
struct Session {
  Chain truth, nominal;
  double tip_radius = 3.0;
  std::vector<Artefact> artefacts;
  std::vector<Touch> touches;
};
Session probe(const Probing& probing);

/// The same as the program under test gets it, the noise stated (0: not stated).
struct Bound {
  Recording recording;
  Constraints constraints;
};
Bound bound(const Session& session, double stated_noise);

Chain chain_of(const Arm& arm);

/// Rms error in mm of the distance between two tips of `found`, over pairs of postures in the volume, by this chain.
double length_error(const Chain& truth, const Chain& found);

}  // namespace artcal::probing
