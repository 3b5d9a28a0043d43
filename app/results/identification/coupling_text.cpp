#include "app/results/identification/coupling_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/output/phrases.h"
#include "core/text/in_quotes.h"
#include "identification/identifiability/unidentifiable_text.h"

namespace artcal {

std::string cannot_text(const Coupling& coupling) {
  std::string text;
  if (!coupling.unidentifiable.empty()) {
    text += fmt::format("Not identifiable from these readings ({} of {} parameters are identifiable):\n", coupling.rank,
                        coupling.parameters.size());
    for (const ParameterMotion& motion : coupling.unidentifiable) {
      text += fmt::format("  {}; {} is fixed\n", unidentifiable_in_words(coupling, motion),
                          coupling.parameters[motion.leading].name);
    }
  }
  if (!coupling.weak.empty()) {
    text += "Weakly identifiable (see the large u):\n";
    for (const WeakDirection& weak : coupling.weak) {
      text += fmt::format("  {} (singular value {:.2g} of {:.3g})\n", weak_in_words(coupling, weak),
                          weak.singular_value, coupling.singular_values[0]);
    }
  }
  return text.empty() ? text : text + "\n";
}

std::string to_text(const Recording& recording, const Coupling& coupling) {
  std::string text = fmt::format("{}\narm {}: {} residuals, {} unknown coordinates and angles of features\n\n",
                                 truncated(60, recording.name), in_quotes(recording.arm.name), coupling.residual_count,
                                 coupling.unknown_count);
  text += fmt::format("rank {} of {}: {} are identifiable, {} are not\n", coupling.rank, coupling.parameters.size(),
                      plural(static_cast<std::size_t>(coupling.rank), "combination"),
                      coupling.parameters.size() - static_cast<std::size_t>(coupling.rank));
  text += coupling.scale == ScaleState::Unidentifiable ? "scale: not identifiable. All lengths can change in "
                                                         "proportion without any effect on the readings; measure a "
                                                         "calibrated length as well\n"
          : coupling.scale == ScaleState::Weak         ? "scale: weakly identifiable; a calibrated length would help\n"
                                                       : "scale: identifiable\n";
  text += "\n" + (recording.warnings.empty() ? "" : warning_lines(recording.warnings) + "\n") + cannot_text(coupling);
  if (!coupling.unidentifiable.empty()) {
    text += "Unidentifiable directions (mm and rad):\n";
    for (const ParameterMotion& motion : coupling.unidentifiable) {
      text += fmt::format("  {}\n", unidentifiable_as_motion(coupling, motion));
    }
    text += "\n";
  }
  if (coupling.readings_not_moved > 0) {
    text += fmt::format("{} could not be put exactly on their points; directions that look weak may be lost\n\n",
                        plural(static_cast<std::size_t>(coupling.readings_not_moved), "reading"));
  }
  std::vector<std::string> values;
  for (const double value : coupling.singular_values) {
    values.push_back(fmt::format("{:.3g}", value));
  }
  return text + fmt::format("singular values (mm per mm, angles times {:.0f} mm):\n  {}\n", coupling.angle_scale,
                            fmt::join(values, " "));
}

}  // namespace artcal
