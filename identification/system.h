#pragma once

#include <vector>

#include <Eigen/Core>

#include "acquisition/parameters.h"
#include "acquisition/recording.h"
#include "acquisition/sweep.h"
#include "artefacts/constraint.h"

namespace artcal {

/// The unknowns of one group (Constraints::groups): the pose's turning (rad) and shift (mm) where it has
/// one, then three coordinates in the base frame (mm) for each unknown point. The artefact's pose is
///     base_from_artefact = (reference · exp(turning), shift)
/// with a reference close to the answer, so that the turning stays small and has no singularity.
struct GroupState {
  Eigen::Matrix3d reference = Eigen::Matrix3d::Identity();
  Eigen::VectorXd values;
};
using Unknowns = std::vector<GroupState>;

/// What a residual is worth. A reading's residual is multiplied by `scalar`, or, where its noise differs by
/// direction, by the lower triangular `matrix` (only for Demand::Coincide, in the residual's own frame).
struct FeatureWeights {
  std::vector<double> scalar;
  std::vector<Eigen::Matrix3d> matrix;
};
struct Weights {
  std::vector<FeatureWeights> features;  ///< as Constraints::features
  std::vector<double> distances;         ///< as Constraints::distances
};

/// All that stays the same while a solver moves the arm: readings, constraints, which parameters are free
/// and the unit each is measured in. The solver's numbers x are steps from the start arm in physical units:
///     parameter = start value + scale · x.
struct System {
  const Constraints* constraints = nullptr;
  Arm start;
  std::vector<Parameter> free;
  Eigen::VectorXd scale;      ///< mm or rad per unit of x
  std::vector<double> sines;  ///< sine and cosine of each joint of each reading
  std::vector<int> probes;    ///< of each reading

  [[nodiscard]] int arm_size() const { return static_cast<int>(free.size()); }
  [[nodiscard]] JointSines sines_of(int reading) const {
    const std::size_t width = 2 * start.joints.size();
    return {sines.data() + width * static_cast<std::size_t>(reading), width};
  }
  [[nodiscard]] Arm arm_at(const double* x) const;
};

/// `angle_scale` is the length that turns an angle into a length, mm; 0 takes the arm's reach.
System make_system(const Recording& recording, const Constraints& constraints, const Arm& start,
                   std::vector<Parameter> free, double angle_scale = 0.0);

/// A sweep for every probe of an arm, with the free parameters as columns.
std::vector<Sweep> sweeps_of(const System& system, const Arm& arm);

}  // namespace artcal
