#include "app/arm/rounding_options.h"

#include <fmt/format.h>

#include "app/arm/rounding.h"

namespace artcal {

void RoundingOptions::add_to(CLI::App& parser) {
  parser.add_option("--digits", digits, "round to decimals of a mm and of a degree")
      ->check(CLI::Range(0, 12))
      ->type_name("N")
      ->default_str("");
  parser.add_option("--steps", steps, "round to steps, such as length=0.001in,angle=19.8arcsec")->type_name("STEPS");
}

Expected<void> RoundingOptions::check() const {
  if (digits >= 0 && !steps.empty()) {
    return wrong_usage("--digits and --steps both say how to round, expected one of them");
  }
  return steps.empty() ? Expected<void>{} : steps_of_text(steps).map([](const RoundingSteps&) {});
}

Expected<RoundedArm> RoundingOptions::rounded_arm(const Arm& arm) const {
  if (!are_given()) {
    return RoundedArm{arm, ""};
  }
  if (auto checked = check(); !checked) {
    return tl::unexpected(checked.error());
  }
  const auto rounding = digits >= 0 ? Expected<RoundingSteps>(steps_of_digits(digits)) : steps_of_text(steps);
  if (!rounding) {
    return tl::unexpected(rounding.error());
  }
  RoundedArm made{rounded(*rounding, arm), ""};
  const TipChange change = tip_change(arm, made.arm);
  made.said = fmt::format(
      "rounding moves the tip by {:.4g} mm rms, {:.4g} mm at most, and changes lengths by {:.4g} mm rms (of {} random "
      "postures)\n",
      change.rms, change.maximum, change.rms_of_lengths, change.postures);
  return made;
}

}  // namespace artcal
