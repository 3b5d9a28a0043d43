#include "app/results/verification/verification_text.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "app/output/table.h"
#include "app/results/shown_text.h"
#include "app/results/shown_unit.h"
#include "app/results/verification/standard_name.h"
#include "app/results/verification/verification_run.h"
#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

std::string short_name(const std::string& name) { return shown_name(name, 40); }

constexpr std::size_t max_values = 12;  // of a quantity, unless more of them do not conform
constexpr std::size_t max_balls = 150;  // of a plate

// Ranges and diameters have no sign, errors do.
std::string text_in_micrometres(double mm, Quantity quantity) {
  return is_signed(quantity) ? signed_in_micrometres(mm) : in_micrometres(mm);
}

// As the standards write it.
const char* symbol_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::SizeError: return "P_Size.Sph.1x25::Tact.AArm";
    case Quantity::FormError: return "P_Form.Sph.1x25::Tact.AArm";
    case Quantity::SizeErrorAll: return "P_Size.Sph.All";
    case Quantity::FormErrorD95: return "P_Form.Sph.D95%";
    case Quantity::LocationDiameter: return "L_Dia.5x5:Art:Tact.AArm";
    case Quantity::LengthUni: return "E_Uni";
    case Quantity::LengthBi: return "E_Bi";
    case Quantity::EffectiveDiameter: return "effective diameter";
    case Quantity::Articulation: return "SPAT, maximum";
    case Quantity::ArticulationSpread: return "SPAT, 2 s";
    case Quantity::Volumetric: break;
  }
  return "volumetric";
}

std::string limit_text(const TestValue& value) { return value.limit ? in_micrometres(*value.limit) : "-"; }

std::string share_text(const TestValue& value) {
  return value.limit ? fmt::format("{:.0f} %", 100.0 * severity(value)) : "-";
}

std::string verdict_text(const TestValue& value) { return value.set_aside ? "set aside" : text_of(value.verdict); }

std::vector<Quantity> quantities_of(const Verification& verification) {
  std::vector<Quantity> all;
  for (const TestValue& value : verification.values) {
    if (std::find(all.begin(), all.end(), value.quantity) == all.end()) {
      all.push_back(value.quantity);
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::string answer(const Verification& verification) {
  std::string text = text_of(verification.conclusion);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c; });
  return text;
}

std::string interim_answer(const InterimCheck& check) {
  return check.any_significant() ? "SIGNIFICANT DRIFT"
         : check.drifts.empty()  ? "NOTHING COULD BE COMPARED"
         : !check.any_judged()   ? "NOT EVALUATED: without repeats no drift can be called significant"
                                 : "NO SIGNIFICANT DRIFT";
}

std::string list_text(const char* heading, const std::vector<std::string>& lines) {
  std::string text;
  for (const auto& line : lines) {
    text += fmt::format("  {}\n", line);
  }
  return text.empty() ? text : fmt::format("{}\n{}\n", heading, text);
}

// What cannot be, waived or not: a verdict by it would look right.
std::vector<std::string> implausible(const Verification& verification) {
  std::vector<std::string> lines;
  for (const bool waived : {false, true}) {
    for (const MissingEvidence& missing : verification.evidence) {
      if (missing.evidence == Evidence::PlausibleValues && missing.is_waived == waived) {
        lines.push_back(missing.line());
      }
    }
  }
  return lines;
}

std::string title_text(const Session& session, const Verification& verification) {
  const std::string by = session.tips.source == TipSource::Reported
                             ? "coordinates as the arm's own software reported them"
                             : "coordinates from joint angles";
  return fmt::format("{}\narm {}: {} readings, {}\n\n{}{}: {}\n  specification: {}; decision rule: {}\n\n",
                     short_name(session.recording.name), in_quotes(session.arm.name), session.recording.readings.size(),
                     by, list_text("Implausible values:", implausible(verification)),
                     standard_in_words(verification.standard), answer(verification),
                     session.specification.name.empty() ? "none" : in_quotes(session.specification.name),
                     text_of(verification.rule));
}

std::string summary_text(const Verification& verification) {
  Table table({"worst of each, um", "values", "value", "limit", "share", "u (k = 1)", "verdict", "where"});
  for (const Quantity quantity : quantities_of(verification)) {
    const TestValue* worst = worst_of(verification, quantity);
    const auto count = std::count_if(verification.values.begin(), verification.values.end(),
                                     [&](const TestValue& value) { return value.quantity == quantity; });
    if (worst != nullptr) {
      table.add(
          {symbol_of(quantity), fmt::format("{}", count), text_in_micrometres(worst->value, worst->quantity),
           limit_text(*worst), share_text(*worst), fmt::format("{:.2f}", worst->budget.total() / units::micrometre),
           verdict_text(*worst),
           fmt::format("{} at {}",
                       short_name(worst->first) + (worst->second.empty() ? "" : " - " + short_name(worst->second)),
                       worst->placement.empty() ? text_of(worst->place) : short_name(worst->placement))});
    }
  }
  return table.text() + "  Worst: the value with the largest share of its limit (without a limit, the largest).\n\n";
}

// All in their order; or the worst first: whatever does not conform and, up to a dozen, those nearest to their limit.
std::vector<const TestValue*> to_show(const Verification& verification, Quantity quantity, bool all) {
  std::vector<const TestValue*> values;
  for (const TestValue& value : verification.values) {
    if (value.quantity == quantity) {
      values.push_back(&value);
    }
  }
  if (all || values.size() <= max_values) {
    return values;
  }
  std::stable_sort(values.begin(), values.end(), [](const TestValue* a, const TestValue* b) {
    const auto rank = [](const TestValue* v) {
      return std::pair(v->verdict != Verdict::NonConformityProven, -severity(*v));
    };
    return rank(a) < rank(b);
  });
  const auto not_conforming = static_cast<std::size_t>(std::count_if(
      values.begin(), values.end(), [](const TestValue* v) { return v->verdict == Verdict::NonConformityProven; }));
  values.resize(std::max(max_values, not_conforming));
  return values;
}

std::string values_text(const Verification& verification, Quantity quantity, bool all) {
  const bool is_length =
      quantity == Quantity::LengthUni || quantity == Quantity::LengthBi || quantity == Quantity::Volumetric;
  Table table({symbol_of(quantity), is_length ? "certified, mm" : "", is_length ? "at, degC" : "",
               is_length ? "at reference, mm" : "", "value, um", "limit", "u", "verdict", "where"});
  const auto values = to_show(verification, quantity, all);
  for (const TestValue* value : values) {
    const std::string features =
        short_name(value->first) + (value->second.empty() ? "" : " - " + short_name(value->second));
    const std::string repeat = value->repeat.empty() ? "" : ", " + short_name(value->repeat);
    table.add({fmt::format("{}: {}{}", short_name(value->placement), features, repeat),
               is_length ? fmt::format("{:.4f}", value->stated.value) : "",
               is_length ? fmt::format("{:.4g}", value->stated.temperature) : "",
               is_length ? fmt::format("{:.4f}", value->certified) : "",
               text_in_micrometres(value->value, value->quantity), limit_text(*value),
               fmt::format("{:.2f}", value->budget.total() / units::micrometre), verdict_text(*value),
               text_of(value->place)});
  }
  std::string text = table.text();
  const auto count =
      static_cast<std::size_t>(std::count_if(verification.values.begin(), verification.values.end(),
                                             [&](const TestValue& value) { return value.quantity == quantity; }));
  if (values.size() < count) {
    text += fmt::format("  and {} more: --all shows them, --json has them\n", count - values.size());
  }
  return text + "\n";
}

std::string plate_text(const PlatePlacement& plate, bool all) {
  std::string text = fmt::format(
      "{}, placement {}: {} balls, residuals {:.2f} um rms, scale {:+.2f} ppm (u {:.2f}), worst |En| of a distance "
      "{:.2f}\n",
      short_name(plate.artefact),
      in_quotes(plate.placement) + (plate.repeat.empty() ? "" : ", repeat " + in_quotes(plate.repeat)),
      plate.balls.size(), plate.rms / units::micrometre, 1e6 * plate.scale, 1e6 * plate.u_scale, plate.en_worst);
  Table table({"ball, residual in the plate's axes, um", "x", "y", "z", "standardised", ""});
  for (const BallResidual& ball : plate.balls) {
    if (all || plate.balls.size() <= max_balls || ball.is_outlier) {
      table.add({short_name(ball.feature), signed_in_micrometres(ball.residual_in_plate.x()),
                 signed_in_micrometres(ball.residual_in_plate.y()), signed_in_micrometres(ball.residual_in_plate.z()),
                 fmt::format("{:.1f}", ball.standardised), ball.is_outlier ? "outlier" : ""});
    }
  }
  return text + table.text() + "\n";
}

std::string calibration_text(const PlateCalibration& calibration) {
  std::string text = fmt::format(
      "The plate {} itself, by {} placements turned by at least {:.0f} degrees against each other (scale: the arm's)\n",
      short_name(calibration.artefact), calibration.placements, calibration.least_turn / units::degree);
  Table table({"ball, mm", "x", "y", "z", "less certified, um: x", "y", "z", "u"});
  for (Eigen::Index i = 0; i < calibration.centres.cols(); ++i) {
    const auto at = calibration.centres.col(i);
    const auto off = calibration.deviations.col(i);
    const auto mm = [](double value) { return fmt::format("{:.5f}", value); };
    table.add({short_name(calibration.features[i]), mm(at.x()), mm(at.y()), mm(at.z()), signed_in_micrometres(off.x()),
               signed_in_micrometres(off.y()), signed_in_micrometres(off.z()),
               fmt::format("{:.2f}", calibration.u(i) / units::micrometre)});
  }
  return text + table.text() + "\n";
}

std::string b89_text(const VerificationResult& result) {
  std::string text;
  for (const Articulation& a : result.articulations) {
    text += fmt::format("{} at {}: {} readings, maximum {}, 2 s {}, (max - min)/2 {} {} {} um (x y z)\n",
                        short_name(a.feature), short_name(a.placement), a.readings, in_micrometres(a.largest),
                        in_micrometres(a.twice_s), in_micrometres(a.half_range.x()), in_micrometres(a.half_range.y()),
                        in_micrometres(a.half_range.z()));
  }
  if (const auto& v = result.volumetric) {
    text += fmt::format("volumetric, {} lengths: maximum {}, range {}, 2 RMS about zero {}, 2 s about the mean {} um\n",
                        v->lengths, in_micrometres(v->largest), in_micrometres(v->range), in_micrometres(v->twice_rms),
                        in_micrometres(v->twice_s));
  }
  return text.empty() ? text : text + "\n";
}

std::string interim_text(const InterimCheck& check) {
  Table table({"drift since, um", "then", "now", "drift", "u (k = 1)", "repeatability", ""});
  for (const Drift& drift : check.drifts) {
    const std::string features =
        short_name(drift.first) + (drift.second.empty() ? "" : " - " + short_name(drift.second));
    const bool told = drift.degrees_of_freedom > 0;
    table.add({fmt::format("{} {}: {}", name_of(drift.quantity), short_name(drift.placement), features),
               text_in_micrometres(drift.then, drift.quantity), text_in_micrometres(drift.now, drift.quantity),
               signed_in_micrometres(drift.drift), fmt::format("{:.2f}", drift.u / units::micrometre),
               told ? fmt::format("{:.2f}", drift.repeatability / units::micrometre) : "no repeats",
               drift.significant ? "significant" : ""});
  }
  return fmt::format("Interim check: {}\n{}\n", interim_answer(check), table.text()) +
         list_text("Not in the earlier verification:", check.not_compared);
}

// In lines of a terminal's width.
std::string wrapped_places() {
  constexpr std::size_t width = 110;
  std::string text = "Where:", line = text;
  std::istringstream words(places_are);
  for (std::string word; words >> word;) {
    const bool fits = line.size() + 1 + word.size() <= width;
    line = fits ? line + " " + word : "  " + word;
    text += fits ? " " + word : "\n  " + word;
  }
  return text + "\n";
}

// A long list must not hide that the test failed: its end stands nearest to the next prompt.
std::string closing_text(const VerificationResult& result) {
  const Verification& verification = result.verification;
  const std::string interim = result.interim ? fmt::format("Interim check: {}\n", interim_answer(*result.interim)) : "";
  const auto failed = std::count_if(verification.values.begin(), verification.values.end(), [](const TestValue& value) {
    return value.verdict == Verdict::NonConformityProven && !value.set_aside;
  });
  return fmt::format(
      "\n{}{}: {} (non-conformity in {} of {} values{})\n", interim, standard_in_words(verification.standard),
      answer(verification), failed, verification.values.size(),
      verification.missing.empty() ? "" : fmt::format("; {} missing, listed above", verification.missing.size()));
}

}  // namespace

std::string to_text(const Session& session, const VerificationResult& result, bool all) {
  const Verification& verification = result.verification;
  std::string text = title_text(session, verification) + summary_text(verification) + b89_text(result);
  text += result.interim ? interim_text(*result.interim) : "";
  text += list_text("Missing for a proof of conformity, beside the values:", verification.missing);
  text += list_text("Waived by the specification:", verification.waived);
  text += list_text("Warnings:", verification.warnings);
  for (const PlatePlacement& plate : result.plates) {
    text += plate_text(plate, all);
  }
  for (const PlateCalibration& calibration : result.calibrations) {
    text += calibration_text(calibration);
  }
  for (const Quantity quantity : quantities_of(verification)) {
    text += values_text(verification, quantity, all);
  }
  text += verification.values.empty() ? "" : wrapped_places();
  return is_shown(result) ? text : text + closing_text(result);
}

}  // namespace artcal
