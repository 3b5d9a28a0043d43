#include "identification/identifiability/parallel_axes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/units.h"
#include "identification/estimation.h"

namespace artcal {
namespace {

// Whether such axes are to be spoken of: not where the model has Hayati's angle, or may be given it.
bool is_asked(const IdentifyOptions& options) {
  return !options.automatic &&
         std::find(options.model.begin(), options.model.end(), ParameterGroup::Hayati) == options.model.end();
}

IdentifyOptions with_hayati(IdentifyOptions options) {
  options.model.push_back(ParameterGroup::Hayati);
  return options;
}

}  // namespace

std::string parallel_axes(const Arm& arm) {
  std::string text;
  const Arm with_beta = arm_for({ParameterGroup::Hayati}, arm);
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    if (arm.joints[i].has_beta || !with_beta.joints[i].has_beta) {
      continue;
    }
    // The link of a joint ends at the next axis; in modified DH it begins at the one before.
    const std::size_t first = arm.convention == Convention::Standard ? i + 1 : i;
    const double angle = std::abs(std::asin(std::sin(arm.joints[i].alpha))) / units::degree;
    text += fmt::format("{}axes {} and {} ({:.2g} deg)", text.empty() ? "" : ", ", first, first + 1, angle);
  }
  return text;
}

std::string note_on_parallel_axes(const Recording& recording, const Constraints& constraints,
                                  const IdentifyOptions& options, const Evaluation& after) {
  const std::string axes = is_asked(options) ? parallel_axes(recording.arm) : "";
  if (axes.empty()) {
    return "";
  }
  const IdentifyOptions wider = with_hayati(options);
  const std::string model = model_text(wider.model);
  const std::string text = fmt::format(
      "neighbouring axes are nearly parallel: {}. Denavit-Hartenberg parameters do not describe a small tilt of such "
      "axes in every direction; Hayati's angle does. ",
      axes);
  const auto found = search_solution(recording, constraints, wider);
  if (!found || !found->misfits.empty()) {
    return text + fmt::format("With --model {} there is no solution: {}", model,
                              found ? found->misfits.front() : found.error().message);
  }
  const double share = found->after.overall.rms / after.overall.rms - 1.0;
  if (!(share < 0.0)) {
    return text + fmt::format("With --model {} the residuals are not smaller: {:.4g} mm rms instead of {:.4g} mm",
                              model, found->after.overall.rms, after.overall.rms);
  }
  return text + fmt::format("With --model {} the residuals are {:.4g} mm rms instead of {:.4g} mm, {:.3g} % less",
                            model, found->after.overall.rms, after.overall.rms, -100.0 * share);
}

Error with_parallel_axes(Error error, const Recording& recording, const Constraints& constraints,
                         const IdentifyOptions& options) {
  const bool no_solution = error.code == ErrorCode::NoSolution;
  const std::string axes = no_solution && is_asked(options) ? parallel_axes(recording.arm) : "";
  if (axes.empty()) {
    return error;
  }
  const IdentifyOptions wider = with_hayati(options);
  if (const auto found = search_solution(recording, constraints, wider); found && found->misfits.empty()) {
    error.message += fmt::format(
        ". Neighbouring axes are nearly parallel: {}; with Hayati's angle, --model {}, there is a solution with "
        "residuals of {:.4g} mm rms",
        axes, model_text(wider.model), found->after.overall.rms);
  }
  return error;
}

}  // namespace artcal
