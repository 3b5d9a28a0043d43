#include "identification/parallel_axes.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/units.h"
#include "identification/arm_fit.h"
#include "identification/preparation.h"

namespace artcal {
namespace {

Expected<Evaluation> evaluated_with(const Recording& recording, const Constraints& constraints,
                                    const IdentifyOptions& options) {
  const auto preparation = prepare(recording, constraints, options);
  if (!preparation) {
    return tl::unexpected(preparation.error());
  }
  const auto fit = fit_arm(recording, constraints, preparation->start, preparation->free, options.noise,
                           {options.loss, options.max_iterations});
  if (!fit) {
    return tl::unexpected(fit.error());
  }
  return evaluate(recording, constraints, fit->arm);
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
  const bool has_group =
      std::find(options.model.begin(), options.model.end(), ParameterGroup::Hayati) != options.model.end();
  const std::string axes = has_group || options.automatic ? "" : parallel_axes(recording.arm);
  if (axes.empty()) {
    return "";
  }
  IdentifyOptions wider = options;
  wider.model.push_back(ParameterGroup::Hayati);
  const std::string model = model_text(wider.model);
  std::string text = fmt::format(
      "neighbouring axes are nearly parallel: {}. Denavit-Hartenberg parameters do not describe a small tilt of such "
      "axes in every direction; Hayati's angle does. ",
      axes);
  const auto with_angle = evaluated_with(recording, constraints, wider);
  if (!with_angle) {
    return text +
           fmt::format("These readings cannot be fitted with it, --model {} ({})", model, with_angle.error().message);
  }
  const double share = with_angle->overall.rms / after.overall.rms - 1.0;
  return text + (share < 0.0 ? fmt::format("With --model {} the readings are fitted to {:.4g} mm rms instead of {:.4g} "
                                           "mm, {:.3g} % less",
                                           model, with_angle->overall.rms, after.overall.rms, -100.0 * share)
                             : fmt::format("With --model {} the readings are fitted no better: {:.4g} mm rms instead "
                                           "of {:.4g} mm",
                                           model, with_angle->overall.rms, after.overall.rms));
}

}  // namespace artcal
