#include "app/report/sections/identification_section.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "app/output/phrases.h"
#include "app/report/numbers.h"
#include "app/report/scene.h"
#include "app/report/sections/correlation.h"
#include "app/report/sections/lengths.h"
#include "app/report/sections/readings.h"
#include "app/results/shown_unit.h"

namespace artcal {
namespace {

using namespace numbers;

/// All placements that were left out, put together.
struct LeftOutDeviations {
  std::size_t readings = 0;
  double rms = 0.0, maximum = 0.0;
  std::size_t lengths = 0;
  double worst_length = 0.0;  // its error
};

double worst_error(const std::vector<RecordedLength>& lengths) {
  double worst = 0.0;
  for (const RecordedLength& length : lengths) {
    worst = std::isnan(length.error) ? length.error : worst;
    worst = std::abs(length.error) > std::abs(worst) ? length.error : worst;
  }
  return worst;
}

LeftOutDeviations all_of(const std::vector<RecordedLeftOut>& left_out) {
  LeftOutDeviations all;
  double squares = 0.0;
  for (const RecordedLeftOut& left : left_out) {
    const RecordedDeviation& deviation = left.deviation;
    all.readings += deviation.readings;
    squares += static_cast<double>(deviation.readings) * deviation.rms * deviation.rms;
    const double worst = worst_error(left.lengths);
    all.lengths += left.lengths.size();
    all.worst_length = std::abs(worst) > std::abs(all.worst_length) ? worst : all.worst_length;
    all.maximum = std::max(all.maximum, deviation.maximum);
  }
  all.rms = all.readings > 0 ? std::sqrt(squares / static_cast<double>(all.readings)) : 0.0;
  return all;
}

// Without those that a weak prior holds.
std::size_t identified_count(const std::vector<RecordedParameter>& parameters) {
  return static_cast<std::size_t>(std::count_if(parameters.begin(), parameters.end(), [](const auto& parameter) {
    return parameter.state == ParameterState::Identified;
  }));
}

void write_before_and_after(const RecordedIdentification& result, Sheet& sheet) {
  const RecordedEvaluation& before = result.before;
  const RecordedEvaluation& after = result.after;
  const LeftOutDeviations left = all_of(result.left_out);
  const auto left_or_dash = [&](double value) { return left.readings > 0 ? mm(value) : "–"; };
  html::Table table("Deviation of the readings, mm",
                    {{"", false, true}, {"before"}, {"after"}, {"cross-validation", true, false, false, true}});
  table.add({"root mean square", mm(before.overall.rms), mm(after.overall.rms), left_or_dash(left.rms)});
  table.add({"largest", mm(before.overall.maximum), mm(after.overall.maximum), left_or_dash(left.maximum)});
  if (!after.lengths.empty()) {
    table.add({"worst certified length, error", signed_mm(worst_error(before.lengths)),
               signed_mm(worst_error(after.lengths)), left.lengths > 0 ? signed_mm(left.worst_length) : "–"});
  }
  sheet.table(table);
  if (left.readings > 0) {
    sheet.paragraph(
        "Before: the nominal arm. After: the identified arm, judged by the readings it was identified from. "
        "Cross-validation: each placement evaluated with an arm identified without it; expect this of new readings.");
  }
}

void write_placements(const RecordedIdentification& result, Sheet& sheet) {
  html::Table table("Deviation by placement, rms, mm", {{"artefact", false},
                                                        {"placement", false, true},
                                                        {"readings"},
                                                        {"before"},
                                                        {"after"},
                                                        {"largest after"},
                                                        {"cross-val.", true, false, false, true}});
  std::map<std::pair<std::string, std::string>, const RecordedLeftOut*> left_out;
  for (const RecordedLeftOut& left : result.left_out) {
    left_out.emplace(std::pair(left.deviation.artefact, left.deviation.placement), &left);
  }
  for (std::size_t i = 0; i < result.after.placements.size(); ++i) {
    const RecordedDeviation& row = result.after.placements[i];
    const auto left = left_out.find({row.artefact, row.placement});
    const std::string left_rms = left == left_out.end()     ? "–"
                                 : left->second->is_refused ? "not possible"
                                                            : mm(left->second->deviation.rms);
    table.add({shown(row.artefact), shown(row.placement), fmt::format("{}", row.readings),
               mm(result.before.placements[i].rms), mm(row.rms), mm(row.maximum), left_rms});
  }
  sheet.table(table);
}

void write_parameters(const std::vector<RecordedParameter>& parameters, Sheet& sheet) {
  html::Table table("Parameters of the arm; u is the standard uncertainty (k = 1)",
                    {{"parameter", false, true}, {"unit", false}, {"nominal"}, {"identified"}, {"change"}, {"u"}});
  for (const RecordedParameter& parameter : parameters) {
    const ShownUnit unit = shown_unit(parameter.name, parameter.unit);
    const auto digits = [&](double value) { return fmt::format("{:.{}f}", value / unit.size, unit.decimals); };
    const double change = parameter.identified - parameter.nominal;
    table.add({parameter.name, unit.name, digits(parameter.nominal), digits(parameter.identified),
               parameter.is_identified() ? fmt::format("{:+.{}f}", change / unit.size, unit.decimals) : "–",
               parameter.is_identified()                           ? two_digits(parameter.u / unit.size)
               : parameter.state == ParameterState::Unidentifiable ? "not identifiable"
                                                                   : "fixed"});
  }
  sheet.table(table);
}

void write_unidentifiable(const RecordedIdentifiability& found, Sheet& sheet) {
  sheet.part("Not identifiable from these readings");
  std::vector<std::string> unidentifiable;
  for (const auto& direction : found.unidentifiable) {
    unidentifiable.push_back(fmt::format("{}; {} is fixed", direction.text, direction.fixed));
  }
  sheet.paragraph(unidentifiable.empty()
                      ? "None: all parameters of the arm are identifiable."
                      : fmt::format("{} of {} combinations of parameters are identifiable. These cannot, whatever "
                                    "the noise, and keep their nominal values:",
                                    found.rank, found.parameters));
  sheet.list(unidentifiable);
  if (!found.weak.empty()) {
    sheet.paragraph("Weakly identifiable:");
    sheet.list(found.weak);
  }
}

void write_cross_validation(const RecordedCrossValidation& found, Sheet& sheet) {
  sheet.facts(
      {{"Placements left out",
        fmt::format("errors of {:.2f} standard uncertainties (rms) in {}; 99 of 100 sound recordings stay below "
                    "{:.2f}",
                    found.ratio, plural(found.placements, "placement"), found.ratio_99)},
       {"Unmodelled error",
        found.scale > 1.0 ? fmt::format("all standard uncertainties of this arm are enlarged by {:.3g}", found.scale)
                          : std::string("not shown by the placements left out")}});
}

void write_noise(const RecordedIdentification& result, Sheet& sheet) {
  const RecordedNoise& noise = result.noise;
  sheet.facts(
      {{"Noise of a reading", fmt::format("{:.4g} mm a coordinate, {}", noise.noise,
                                          noise.is_given ? "as stated beforehand" : "estimated from the residuals")},
       {"Agreement",
        fmt::format("χ² = {:.1f} with {} degrees of freedom; 95 of 100 sound fits lie between "
                    "{:.1f} and {:.1f}",
                    noise.chi_squared, noise.degrees_of_freedom, noise.chi_squared_low, noise.chi_squared_high)}});
  if (result.cross_validation) {
    write_cross_validation(*result.cross_validation, sheet);
  }
  if (noise.scale_factor > 1.0) {
    sheet.note(fmt::format("The readings scatter more than was stated: all uncertainties are multiplied by {:.3g}.",
                           noise.scale_factor));
  }
}

void write_outliers(const std::vector<RecordedOutlier>& outliers, Sheet& sheet) {
  html::Table table("Outliers; without a robust loss they took part like all other readings", {{"where", false, true},
                                                                                               {"placement", false},
                                                                                               {"feature", false},
                                                                                               {"deviation, mm"},
                                                                                               {"standard deviations"},
                                                                                               {"limit"}});
  for (const RecordedOutlier& outlier : outliers) {
    table.add({shown(outlier.where), shown(outlier.placement), shown(outlier.feature),
               outlier.is_signed ? signed_mm(outlier.deviation) : mm(outlier.deviation),
               fmt::format("{:.1f}", outlier.standardised), fmt::format("{:.1f}", outlier.limit)});
  }
  sheet.table(table);
}

}  // namespace

void write_identification_verdict(const RecordedIdentification& result, Sheet& sheet) {
  const std::size_t warnings = result.circumstances.warnings.size();
  const std::size_t outliers = result.outliers.size();
  const LeftOutDeviations left = all_of(result.left_out);
  std::string text = fmt::format(
      "{} of {} parameters. Readings deviate by {} mm rms, {} mm at most; by the nominal arm {} mm and {} mm.",
      identified_count(result.parameters), result.parameters.size(), mm(result.after.overall.rms),
      mm(result.after.overall.maximum), mm(result.before.overall.rms), mm(result.before.overall.maximum));
  if (left.readings > 0) {
    text += result.left_out_chose_the_model
                ? fmt::format(
                      " Placements left out deviate by {} mm rms; they also chose the model, and new readings "
                      "may deviate by more.",
                      mm(left.rms))
                : fmt::format(" Expect {} mm rms of new readings.", mm(left.rms));
  }
  if (warnings + outliers > 0) {
    const std::string first = warnings > 0 ? plural(warnings, "warning") : "";
    const std::string second = outliers > 0 ? plural(outliers, "outlying reading") : "";
    text += fmt::format(" See {}{}{} below.", first, warnings > 0 && outliers > 0 ? " and " : "", second);
  }
  if (left.readings == 0) {
    text += result.after.placements.size() < 2
                ? " Nothing could be left out for cross-validation, for there is one placement: what the arm measures "
                  "elsewhere is not known."
                : " Nothing was left out for cross-validation: what the arm measures elsewhere is not known.";
  }
  const bool clear = warnings + outliers == 0 && left.readings > 0;
  sheet.verdict(clear ? Mood::Good : Mood::Unsure,
                clear                      ? "✓ Identified"
                : warnings + outliers == 0 ? "⚠ Identified; nothing could be left out"
                                           : "⚠ Identified, with reservations",
                text);
}

void write_identification(const RecordedIdentification& result, Sheet& sheet) {
  write_before_and_after(result, sheet);
  write_placements(result, sheet);
  if (result.readings) {
    sheet.figure(residuals_by_placement(result));
  } else {
    sheet.note("This result was written with --no-residuals: its readings cannot be drawn.");
  }
  write_outliers(result.outliers, sheet);
  if (result.readings) {
    sheet.figure(scene_of(result));
  }
  if (!result.after.lengths.empty()) {
    write_length_errors(result.before, result.after, result.left_out, sheet);
  }
  sheet.part("Parameters");
  write_parameters(result.parameters, sheet);
  write_noise(result, sheet);
  write_unidentifiable(result.identifiability, sheet);
  if (result.covariance.parameters.size() > 1) {
    sheet.figure(correlation_of(result.covariance));
  }
  if (result.readings && !result.readings->joints.empty()) {
    sheet.figure(residuals_by_joint(*result.readings));
  }
}

}  // namespace artcal
