#pragma once

#include <vector>

#include <Eigen/Core>

#include "acquisition/arm/forward_kinematics.h"
#include "acquisition/arm/parameters.h"
#include "acquisition/recording/recording.h"
#include "artefacts/constraints/constraint.h"

namespace artcal {

/// What the unknowns of a group count from: a place close to the answer, so that turnings and tilts stay small
/// and have no singularity. Of a point alone it means nothing.
struct GroupReference {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();  ///< of a pose; of planes, its z axis is near their normal
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();        ///< of planes, in the base frame, among the readings
  double size = 1.0;                                       ///< of planes, mm: how far readings lie from the origin
  std::vector<double> sides{};     ///< of each plane: 1 where the tip lies on the side of the axis, else -1
  PoseTurn turn = PoseTurn::Free;  ///< of a pose (UnknownGroup)
  PointLine line{};                ///< of a pose whose turn is not free
};

/// The unknowns of one group (Constraints::groups). A pose: turning (rad) and shift (mm), then three
/// coordinates in the base frame (mm) for each unknown point:
///     base_from_artefact = (reference.rotation · exp(turning), shift)
/// A pose whose turn about a line is not free (PoseTurn): the two components of the turning across the line, the shift,
/// and of a scaled turn u and v.
/// Parallel planes: two tilts s, t (mm), then each plane's place o along their common axis:
///     axis = rotation · (s/size, t/size, 1), normalised;  the plane: axis · (X − origin) = o
struct GroupState {
  GroupReference reference;
  Eigen::VectorXd values;
};

/// All that is found along with the arm.
struct Unknowns {
  std::vector<GroupState> groups;  ///< as Constraints::groups
  Eigen::VectorXd shared;          ///< as Constraints::shared
};

/// Of the group that a feature's unknowns belong to; an empty one where it has none.
const GroupState& state_of(const FeatureConstraint& feature, const Unknowns& unknowns);

/// What a residual is worth. A reading's residual is multiplied by `scalar`, or, where its noise differs by
/// direction, by the lower triangular `matrix` (only for Coincide, in the residual's own frame).
struct FeatureWeights {
  std::vector<double> scalar;
  std::vector<Eigen::Matrix3d> matrix;
  /// For a loss: the variance of each reading's weighted residual in a good fit, mean over its components. Empty: 1.
  std::vector<double> variance{};
};
struct Weights {
  std::vector<FeatureWeights> features;  ///< as Constraints::features
  std::vector<double> distances;         ///< as Constraints::distances
  std::vector<double> shared;            ///< as Constraints::shared; 0 where the certificate says nothing
  /// The same variances of distances and shared; empty: a loss does not reach them.
  std::vector<double> distance_variance{}, shared_variance{};
};

/// All that stays the same while a solver moves the arm: readings, constraints, which parameters are free
/// and the unit each is measured in. The solver's numbers x are steps from the start arm in physical units:
///     parameter = start value + scale · x.
struct System {
  const Constraints* constraints = nullptr;
  Arm start;
  std::vector<Parameter> free;
  Eigen::VectorXd scale;                ///< in the parameters' units per unit of x
  std::vector<double> sines;            ///< sine and cosine of each joint of each reading
  std::vector<double> joints;           ///< of each reading, rad
  std::vector<double> temperatures;     ///< of the arm at each reading, °C; NaN where it was not read
  std::vector<int> probes;              ///< of each reading
  std::vector<Eigen::Vector3d> shifts;  ///< of each reading's tip in the base frame, mm; or empty: none

  [[nodiscard]] int arm_size() const { return static_cast<int>(free.size()); }
  [[nodiscard]] int shared_size() const { return static_cast<int>(constraints->shared.size()); }
  [[nodiscard]] JointReading sines_of(int reading) const {
    const std::size_t width = start.joints.size();
    const std::size_t first = width * static_cast<std::size_t>(reading);
    return {{sines.data() + 2 * first, 2 * width},
            {joints.data() + first, width},
            temperatures[static_cast<std::size_t>(reading)]};
  }
  [[nodiscard]] Arm arm_at(const double* x) const;
};

/// `angle_scale` is the length that turns an angle into a length, mm; 0 takes the arm's reach.
System make_system(const Recording& recording, const Constraints& constraints, const Arm& start,
                   std::vector<Parameter> free, double angle_scale = 0.0);

/// A pass for every probe of an arm, with the free parameters as columns.
std::vector<ForwardKinematics> forward_kinematics_of(const System& system, const Arm& arm);

}  // namespace artcal
