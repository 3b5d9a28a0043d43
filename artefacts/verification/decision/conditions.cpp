#include "artefacts/verification/decision/conditions.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

void add_once(std::vector<std::string>& list, std::string text) {
  if (std::find(list.begin(), list.end(), text) == list.end()) {
    list.push_back(std::move(text));
  }
}

void check_temperature(const Session& session, const TestValue& value, std::vector<std::string>& missing) {
  const auto& [lowest, highest] =
      std::pair{session.specification.lowest_temperature, session.specification.highest_temperature};
  const std::string where =
      fmt::format("artefact {}, placement {}", in_quotes(value.artefact), in_quotes(value.placement));
  if (!std::isfinite(value.temperature)) {
    add_once(missing, fmt::format("{}: the artefact's temperature was not read; lengths are not compensated", where));
  } else if ((lowest && value.temperature < *lowest) || (highest && value.temperature > *highest)) {
    add_once(missing, fmt::format("{}: {:.1f} degC is outside the rated conditions", where, value.temperature));
  }
}

void check_certificate(const Artefact& artefact, const TestValue& value, std::vector<std::string>& missing) {
  const auto lacks = [&](const char* what) {
    add_once(missing,
             fmt::format("artefact {}: the certificate states no {}; u lacks it", in_quotes(artefact.name), what));
  };
  const bool is_length = value.certified > 0.0;
  if (is_length && value.budget.calibration == 0.0) {
    lacks(value.quantity == Quantity::SizeError || value.quantity == Quantity::EffectiveDiameter
              ? "U of the ball's diameter"
              : "U of a length");
  }
  if (!is_length && artefact.features.front().kind == FeatureKind::Sphere && !artefact.features.front().form) {
    lacks("form deviation of the ball");
  }
  if (is_length && !artefact.expansion_is_known) {
    lacks("thermal expansion");
  } else if (is_length && artefact.u_expansion == 0.0) {
    lacks("uncertainty of the thermal expansion");
  }
}

}  // namespace

void check_conditions(const Session& session, Verification& verification) {
  const bool needs_u = session.specification.rule != DecisionRule::Simple;
  for (const TestValue& value : verification.values) {
    check_temperature(session, value, verification.missing);
    const auto& artefacts = session.constraints.artefacts;
    const auto artefact =
        std::find_if(artefacts.begin(), artefacts.end(), [&](const Artefact& a) { return a.name == value.artefact; });
    if (needs_u && artefact != artefacts.end()) {
      check_certificate(*artefact, value, verification.missing);
    }
    if (!value.limit) {
      add_once(verification.missing, fmt::format("{}: no limit is stated to judge it by", name_of(value.quantity)));
    }
  }
  if (needs_u && !session.specification.u_temperature) {
    add_once(verification.missing,
             "the specification states no uncertainty of the temperature (uncertainty.temperature_K); u lacks it");
  }
}

void add_place_warnings(Verification& verification) {
  std::vector<std::string> above, at_stop;
  bool too_coarse = false;
  for (const TestValue& value : verification.values) {
    if (value.place.above_base) {
      add_once(above, in_quotes(value.placement));
    }
    if (value.place.joint_at_stop > 0) {
      add_once(at_stop, fmt::format("{} (joint {})", in_quotes(value.placement), value.place.joint_at_stop));
    }
    too_coarse = too_coarse || (value.limit && guard_band(verification.rule, value.budget.total(),
                                                          value.budget.degrees_of_freedom()) > *value.limit);
  }
  const auto list = [](const std::vector<std::string>& names) {
    std::string text;
    for (const auto& name : names) {
      text += (text.empty() ? "" : ", ") + name;
    }
    return truncated(200, text);
  };
  if (!above.empty()) {
    verification.warnings.push_back("straight above the base, where an arm is at its worst: placement " + list(above));
  }
  if (!at_stop.empty()) {
    verification.warnings.push_back("a joint within 2 degrees of the end of its travel: placement " + list(at_stop));
  }
  if (too_coarse) {
    verification.warnings.push_back(
        "the guard band is wider than the limit: with this uncertainty nothing can be shown to conform");
  }
}

}  // namespace artcal
