#include "identification/problem/start.h"

#include <algorithm>
#include <vector>

#include "identification/identifiability/svd.h"
#include "identification/initial/nuisance_estimation.h"
#include "identification/least_squares/linearisation.h"
#include "identification/least_squares/problem.h"
#include "identification/problem/weights.h"

namespace artcal {
namespace {

// Below this σ/σ1 the readings hardly show some direction of the tip.
constexpr double shown_well = 1e-3;

std::vector<Parameter> rough_tips(const Arm& arm, const std::vector<std::string>& fixed) {
  std::vector<Parameter> tips;
  for (const Parameter& parameter : parameters_of(arm)) {
    if (parameter.is_tip() && !arm.probes[parameter.owner].on_axis &&
        std::find(fixed.begin(), fixed.end(), parameter.name) == fixed.end()) {
      tips.push_back(parameter);
    }
  }
  return tips;
}

}  // namespace

Expected<Arm> arm_with_fitted_tips(const Recording& recording, const Constraints& constraints, const Arm& nominal,
                                   const std::vector<std::string>& fixed) {
  const auto tips = rough_tips(nominal, fixed);
  if (tips.empty()) {
    return nominal;
  }
  const System system = make_system(recording, constraints, nominal, tips);
  auto unknowns = estimate_nuisance_parameters(system, nominal, recording);
  if (!unknowns) {
    return tl::unexpected(unknowns.error());
  }
  const Weights weights = unit_weights(constraints);
  const Linearisation at_nominal = linearise(system, weights, Loss::None, nominal, *unknowns);
  const Eigen::VectorXd sigma = svd(arm_triangle(at_nominal, system.arm_size())).values;
  if (sigma.minCoeff() <= shown_well * sigma.maxCoeff()) {
    return nominal;
  }
  SolveOptions options;
  options.linearise_solution = false;
  const Solution solution =
      solve(system, weights, Eigen::VectorXd::Zero(system.arm_size()), std::move(*unknowns), options);
  return solution.termination == Termination::Converged ? system.arm_at(solution.x.data()) : nominal;
}

}  // namespace artcal
