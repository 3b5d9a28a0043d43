#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "artefacts/constraints/constraint.h"
#include "core/error.h"
#include "identification/problem/system.h"
#include "identification/problem/tips.h"

namespace artcal {

/// The pose of an artefact in one placement that fits its readings best with the arm held: least squares over all that
/// is posed. Of a pose that lies nearly on a line, the turn about that line is found whatever the start: first with a
/// scaled turn, in which the residual is linear, then from four turns about it, of which the best is kept. No solution:
/// readings that do not determine the unknowns of the group; `called` names one of its features.
Expected<GroupState> estimate_pose(const std::vector<Tips>& features, const Eigen::VectorXd& shared,
                                   const UnknownGroup& group, const std::string& called);

/// The pose of a state with a scaled turn, as one with a free turn.
GroupState with_free_turn(const GroupState& scaled);

/// `posed`, with a free turn, turned about its line by `angle`, rad.
GroupState turned_about_line(const GroupState& posed, const PointLine& line, double angle);

}  // namespace artcal
