#pragma once

#include <vector>

#include "identification/identify.h"
#include "identification/least_squares/arm_fit.h"
#include "identification/problem/preparation.h"

namespace artcal {

/// A fit of an arm with the groups of a model, of which only those members are free that the readings determine within
/// what a joint that works can have.
struct GroupFit {
  Preparation preparation;  ///< its free parameters are those of the fit
  ArmFit fit;
  std::vector<FixedMember> fixed;
};

/// Looks at the first fit_arm() of a preparation: as long as a member of a group is beyond most_of(), has a standard
/// uncertainty beyond it or is a compliance below zero, fixes the worst such member at its nominal value and fits
/// again. One at a time, the least determined first: what such a member takes up distorts the others. A fit that did
/// not converge is repeated without the least determined member. Members named by options.free are never fixed. No
/// solution: see fit_arm(); nothing of a group is left.
Expected<GroupFit> fix_undetermined_members(Expected<ArmFit> first, const Recording& recording,
                                            const Constraints& constraints, Preparation preparation,
                                            const IdentifyOptions& options, const WeakPrior& prior = {});

/// Whether fix_undetermined_members() would leave all members of the model's groups free that are in `free`, at an arm
/// fitted to these with this covariance, which may be an upper bound.
bool keeps_all_members(const Recording& recording, const std::vector<Parameter>& free, const IdentifyOptions& options,
                       const Arm& arm, const Eigen::MatrixXd& covariance);

}  // namespace artcal
