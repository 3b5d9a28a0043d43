#include "identification/models/model_study.h"

#include <cmath>

#include <fmt/format.h>

#include "core/units.h"

namespace artcal {

std::string in_words(const ModelFinding& finding) {
  const int joint = finding.joint + 1;
  const double arcsec = finding.amplitude / units::arcsecond;
  const double degrees = finding.phase / units::degree;
  switch (finding.effect) {
    case Effect::OncePerTurn:
      return fmt::format("joint {}: once per turn (eccentric encoder?), {:.3g} arcsec x sin(q{} {:+.0f} deg)", joint,
                         arcsec, joint, degrees);
    case Effect::TwicePerTurn:
      return fmt::format("joint {}: twice per turn, {:.3g} arcsec x sin(2 q{} {:+.0f} deg)", joint, arcsec, joint,
                         degrees);
    case Effect::Gain: return fmt::format("joint {}: {:.3g} ppm of the angle", joint, 1e6 * finding.amplitude);
    case Effect::Gravity:
      return fmt::format("joint {}: bends under gravity, by {:.3g} arcsec rms", joint, std::abs(arcsec));
    case Effect::Drift:
      return fmt::format("joint {}: its zero drifts by {:.3g} arcsec from the first reading to the last", joint,
                         2.0 * arcsec);
    case Effect::TemperatureOffset:
      return fmt::format("joint {}: its zero moves by {:.3g} arcsec a kelvin", joint, arcsec);
    case Effect::Expansion: break;
  }
  return fmt::format("the arm grows by {:.3g} ppm a kelvin", 1e6 * finding.amplitude);
}

std::string warning_of(const ModelStudy& study) {
  constexpr std::size_t max_named = 2;
  if (study.findings.empty()) {
    return study.implausible == 0
               ? ""
               : "the residuals are more than noise, and none of the effects that they were searched for explains them "
                 "with values that a working joint can have: some other error, of the readings, an artefact or the "
                 "arm, is in them";
  }
  std::string named;
  for (std::size_t i = 0; i < study.findings.size() && i < max_named; ++i) {
    const ModelFinding& finding = study.findings[i];
    named += fmt::format("{}{} (at the tip {:.2g} mm rms)", i == 0 ? "" : "; ", in_words(finding), finding.rms_at_tip);
  }
  if (study.findings.size() > max_named) {
    named += fmt::format("; and {} more", study.findings.size() - max_named);
  }
  return fmt::format("the residuals exceed the noise; unmodelled effects: {}", named);
}

}  // namespace artcal
