#include "identification/identifiability/fixed_hayati_angles.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/arm/parallel_axes.h"
#include "identification/estimation.h"

namespace artcal {
namespace {

std::vector<std::string> fixed_angles(const Recording& recording, const IdentifyOptions& options) {
  const Arm nominal = arm_for(options.model, recording.arm);
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters_of(nominal)) {
    if (parameter.kind == ParameterKind::Beta &&
        joins_parallel_axes(nominal, static_cast<std::size_t>(parameter.owner)) &&
        std::find(options.hold.begin(), options.hold.end(), parameter.name) != options.hold.end()) {
      names.push_back(parameter.name);
    }
  }
  return names;
}

IdentifyOptions without_holding(const std::vector<std::string>& names, IdentifyOptions options) {
  std::erase_if(options.hold,
                [&](const std::string& name) { return std::find(names.begin(), names.end(), name) != names.end(); });
  options.start.reset();
  return options;
}

}  // namespace

std::string note_on_fixed_hayati_angles(const Recording& recording, const Constraints& constraints,
                                        const IdentifyOptions& options, const Evaluation& after) {
  const auto names = fixed_angles(recording, options);
  if (names.empty()) {
    return "";
  }
  const std::string text = fmt::format(
      "neighbouring axes are nearly parallel: {}, and {} fixed. Denavit-Hartenberg parameters do not describe a small "
      "tilt of such axes in every direction; Hayati's angle does. ",
      parallel_axes(recording.arm), fmt::format("{} {}", fmt::join(names, ", "), names.size() == 1 ? "is" : "are"));
  const auto found = search_solution(recording, constraints, without_holding(names, options));
  if (!found || !found->misfits.empty()) {
    return text + "With it free there is no solution: " + (found ? found->misfits.front() : found.error().message);
  }
  const double share = found->after.overall.rms / after.overall.rms - 1.0;
  if (!(share < 0.0)) {
    return text + fmt::format("With it free the residuals are not smaller: {:.4g} mm rms instead of {:.4g} mm",
                              found->after.overall.rms, after.overall.rms);
  }
  return text + fmt::format("With it free the residuals are {:.4g} mm rms instead of {:.4g} mm, {:.3g} % less",
                            found->after.overall.rms, after.overall.rms, -100.0 * share);
}

Error with_fixed_hayati_angles(Error error, const Recording& recording, const Constraints& constraints,
                               const IdentifyOptions& options) {
  const auto names =
      error.code == ErrorCode::NoSolution ? fixed_angles(recording, options) : std::vector<std::string>{};
  if (names.empty()) {
    return error;
  }
  const auto found = search_solution(recording, constraints, without_holding(names, options));
  if (found && found->misfits.empty()) {
    error.message += fmt::format(
        ". Neighbouring axes are nearly parallel: {}; with Hayati's angle free ({}) there is a solution with residuals "
        "of {:.4g} mm rms",
        parallel_axes(recording.arm), fmt::join(names, ", "), found->after.overall.rms);
  }
  return error;
}

}  // namespace artcal
