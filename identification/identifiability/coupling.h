#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "acquisition/arm/parameters.h"
#include "acquisition/recording/recording.h"
#include "artefacts/constraints/constraint.h"
#include "core/error.h"

namespace artcal {

/// A motion of the parameters. `coefficients` are in mm and rad, as Coupling::parameters.
struct ParameterMotion {
  Eigen::VectorXd coefficients;
  int leading = 0;  ///< the parameter whose coefficient is 1; of an unidentifiable motion, the one that is held
};

/// A direction that the readings see, but poorly.
struct WeakDirection {
  double singular_value = 0.0;
  ParameterMotion motion;       ///< no fixed parameter takes part
  double share_of_scale = 0.0;  ///< |cosine| between it and the common scale of all lengths
};

enum class ScaleState { Determined, Weak, Unidentifiable };

/// What a set of readings can tell of an arm, and what it cannot.
struct Coupling {
  std::vector<Parameter> parameters;  ///< those that were asked about
  int rank = 0;
  Eigen::VectorXd singular_values;  ///< largest first; columns in mm and angle_scale·rad
  double angle_scale = 0.0;         ///< mm
  std::vector<ParameterMotion>
      unidentifiable;  ///< one an unidentifiable dimension; together they span what is unidentifiable
  std::vector<WeakDirection> weak;
  ScaleState scale = ScaleState::Determined;
  int residual_count = 0;
  int unknown_count = 0;       ///< nuisance unknowns, eliminated
  int readings_not_moved = 0;  ///< see project_onto_constraints()

  [[nodiscard]] std::vector<int> fixed() const;  ///< indices of the parameters that hold the unidentifiable motions
};

struct CouplingOptions {
  std::vector<std::string> not_asked;  ///< parameters taken as known
  std::vector<std::string>
      beside_asked;  ///< radii of tips and joint errors that are parameters here; the others are known
  std::vector<std::string> preferred_fixed;  ///< hold these first, where they take part in an unidentifiable motion
  std::vector<std::string> rather_free;      ///< and these last
  Noise noise;                               ///< for what distances and readings are worth to each other
  double angle_scale = 0.0;                  ///< mm; 0 takes the reach
  double rank_tolerance = 1e-8;  ///< σ/σ1; an unidentifiable direction comes out at 1e-13 and a weak one at 1e-4
  double weak_below = 2e-2;      ///< σ/σ1: a fiftieth of the best direction is poor
};

/// Linearises the constraints at the arm, with every reading on its constraint (see make_consistent),
/// eliminates the unknown points and poses, and takes the singular values of what remains (QR, then SVD of
/// the triangle, in physical units: never of JᵀJ, never with normalised columns).
Expected<Coupling> analyse_coupling(const Recording& recording, const Constraints& constraints, const Arm& arm,
                                    const CouplingOptions& options = {});

/// The order in which parameters are held where the readings leave the choice: the last joint's a and d
/// (Gao 2013: a6, d6; θ6 and α6 take over their part), then what only moves the base frame (d1, θ1; in
/// modified DH also a0, α0). In modified DH the last joint's d and θ go with the tip.
std::vector<std::string> default_hold_order(const Arm& arm);

}  // namespace artcal
