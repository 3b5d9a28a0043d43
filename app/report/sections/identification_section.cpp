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
#include "app/results/evaluation/recorded_evaluation.h"
#include "app/results/shown_unit.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using namespace numbers;

/// How the readings of an identification deviate.
struct Judged {
  RecordedEvaluation before, after;
  std::vector<RecordedLeftOut> left_out;
};

Judged judged_in(const Json& result) {
  return {recorded_evaluation(result.at("before")), recorded_evaluation(result.at("after")),
          recorded_left_out(result.at("left_out"))};
}

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

std::size_t identified_count(const Json& result) {
  const Json& parameters = result.at("parameters");
  return static_cast<std::size_t>(std::count_if(parameters.begin(), parameters.end(), [](const Json& parameter) {
    return parameter.at("state") == "identified";
  }));
}

void write_before_and_after(const Judged& judged, Sheet& sheet) {
  const auto& [before, after, left_out] = judged;
  const LeftOutDeviations left = all_of(left_out);
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

void write_placements(const Judged& judged, Sheet& sheet) {
  html::Table table("Deviation by placement, rms, mm", {{"artefact", false},
                                                        {"placement", false, true},
                                                        {"readings"},
                                                        {"before"},
                                                        {"after"},
                                                        {"largest after"},
                                                        {"cross-val.", true, false, false, true}});
  std::map<std::pair<std::string, std::string>, const RecordedLeftOut*> left_out;
  for (const RecordedLeftOut& left : judged.left_out) {
    left_out.emplace(std::pair(left.deviation.artefact, left.deviation.placement), &left);
  }
  for (std::size_t i = 0; i < judged.after.placements.size(); ++i) {
    const RecordedDeviation& row = judged.after.placements[i];
    const auto left = left_out.find({row.artefact, row.placement});
    const std::string left_rms = left == left_out.end()     ? "–"
                                 : left->second->is_refused ? "not possible"
                                                            : mm(left->second->deviation.rms);
    table.add({shown(row.artefact), shown(row.placement), fmt::format("{}", row.readings),
               mm(judged.before.placements.at(i).rms), mm(row.rms), mm(row.maximum), left_rms});
  }
  sheet.table(table);
}

void write_parameters(const Json& result, Sheet& sheet) {
  html::Table table("Parameters of the arm; u is the standard uncertainty (k = 1)",
                    {{"parameter", false, true}, {"unit", false}, {"nominal"}, {"identified"}, {"change"}, {"u"}});
  for (const Json& parameter : result.at("parameters")) {
    const ShownUnit unit = shown_unit(parameter.at("name").get<std::string>(), parameter.at("unit").get<std::string>());
    const auto number = [&](const char* key) {
      return fmt::format("{:.{}f}", parameter.at(key).get<double>() / unit.size, unit.decimals);
    };
    const std::string state = parameter.at("state");
    const bool identified = state == "identified" || state == "weak";
    const double change = parameter.at("identified").get<double>() - parameter.at("nominal").get<double>();
    table.add({parameter.at("name"), unit.name, number("nominal"), number("identified"),
               identified ? fmt::format("{:+.{}f}", change / unit.size, unit.decimals) : "–",
               identified                  ? two_digits(parameter.at("standard_uncertainty").get<double>() / unit.size)
               : state == "unidentifiable" ? "not identifiable"
                                           : "fixed"});
  }
  sheet.table(table);
}

void write_unidentifiable(const Json& coupling, Sheet& sheet) {
  sheet.part("Not identifiable from these readings");
  std::vector<std::string> unidentifiable, weak;
  for (const Json& direction : coupling.at("unidentifiable")) {
    unidentifiable.push_back(fmt::format("{}; {} is fixed", direction.at("text").get<std::string>(),
                                         direction.at("fixed").get<std::string>()));
  }
  for (const Json& direction : coupling.at("weak")) {
    weak.push_back(direction.at("text"));
  }
  sheet.paragraph(unidentifiable.empty()
                      ? "None: all parameters of the arm are identifiable."
                      : fmt::format("{} of {} combinations of parameters are identifiable. These cannot, whatever "
                                    "the noise, and keep their nominal values:",
                                    coupling.at("rank").get<std::size_t>(),
                                    coupling.at("parameter_count").get<std::size_t>()));
  sheet.list(unidentifiable);
  if (!weak.empty()) {
    sheet.paragraph("Weakly identifiable:");
    sheet.list(weak);
  }
}

void write_cross_validation(const Json& result, Sheet& sheet) {
  if (!result.contains("cross_validation") || result.at("cross_validation").is_null()) {
    return;
  }
  const Json& found = result.at("cross_validation");
  const double scale = found.at("scale");
  sheet.facts(
      {{"Placements left out",
        fmt::format("errors of {:.2f} standard uncertainties (rms) in {}; 99 of 100 sound recordings stay below "
                    "{:.2f}",
                    found.at("ratio").get<double>(), plural(found.at("placements").get<std::size_t>(), "placement"),
                    found.at("ratio_99").get<double>())},
       {"Unmodelled error", scale > 1.0
                                ? fmt::format("all standard uncertainties of this arm are enlarged by {:.3g}", scale)
                                : std::string("not shown by the placements left out")}});
}

void write_noise(const Json& result, Sheet& sheet) {
  const Json& noise = result.at("noise");
  const Json& range = noise.at("chi_squared_95");
  sheet.facts(
      {{"Noise of a reading",
        fmt::format("{:.4g} mm a coordinate, {}", noise.at("mm").get<double>(),
                    noise.at("given").get<bool>() ? "as stated beforehand" : "estimated from the residuals")},
       {"Agreement", fmt::format("χ² = {:.1f} with {} degrees of freedom; 95 of 100 sound fits lie between "
                                 "{:.1f} and {:.1f}",
                                 noise.at("chi_squared").get<double>(), noise.at("degrees_of_freedom").get<long>(),
                                 range.at(0).get<double>(), range.at(1).get<double>())}});
  write_cross_validation(result, sheet);
  if (noise.at("scale_factor").get<double>() > 1.0) {
    sheet.note(fmt::format("The readings scatter more than was stated: all uncertainties are multiplied by {:.3g}.",
                           noise.at("scale_factor").get<double>()));
  }
}

void write_outliers(const Json& outliers, Sheet& sheet) {
  html::Table table("Outliers; without a robust loss they took part like all other readings", {{"where", false, true},
                                                                                               {"placement", false},
                                                                                               {"feature", false},
                                                                                               {"deviation, mm"},
                                                                                               {"standard deviations"},
                                                                                               {"limit"}});
  for (const Json& outlier : outliers) {
    table.add({shown(text_in(outlier, "where")), shown(text_in(outlier, "placement")),
               shown(text_in(outlier, "feature")),
               outlier.value("deviation_is_signed", true) ? signed_mm(outlier.at("deviation_mm"))
                                                          : mm(outlier.at("deviation_mm")),
               fmt::format("{:.1f}", outlier.at("standardised").get<double>()),
               fmt::format("{:.1f}", outlier.at("limit").get<double>())});
  }
  sheet.table(table);
}

}  // namespace

void write_identification_verdict(const Json& result, Sheet& sheet) {
  const std::size_t warnings = result.at("warnings").size();
  const std::size_t outliers = result.at("outliers").size();
  const Judged judged = judged_in(result);
  const LeftOutDeviations left = all_of(judged.left_out);
  std::string text = fmt::format(
      "{} of {} parameters. Readings deviate by {} mm rms, {} mm at most; by the nominal arm {} mm and {} mm.",
      identified_count(result), result.at("parameters").size(), mm(judged.after.overall.rms),
      mm(judged.after.overall.maximum), mm(judged.before.overall.rms), mm(judged.before.overall.maximum));
  if (left.readings > 0) {
    const Json& model = result.at("model");
    const bool chose = model.contains("chosen_by_left_out") && model.at("chosen_by_left_out").get<bool>();
    text += chose ? fmt::format(
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
    text += judged.after.placements.size() < 2
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

void write_identification(const Json& result, Sheet& sheet) {
  const bool has_readings = result.contains("residuals");
  const ReportedReadings readings = has_readings ? readings_in(result) : ReportedReadings();
  const Judged judged = judged_in(result);
  write_before_and_after(judged, sheet);
  write_placements(judged, sheet);
  if (has_readings) {
    sheet.figure(residuals_by_placement(result, readings));
  } else {
    sheet.note("This result was written with --no-residuals: its readings cannot be drawn.");
  }
  write_outliers(result.at("outliers"), sheet);
  if (has_readings) {
    sheet.figure(scene_of(result, readings));
  }
  if (!judged.after.lengths.empty()) {
    write_length_errors(judged.before, judged.after, judged.left_out, sheet);
  }
  sheet.part("Parameters");
  write_parameters(result, sheet);
  write_noise(result, sheet);
  write_unidentifiable(result.at("coupling"), sheet);
  if (result.at("covariance").at("parameters").size() > 1) {
    sheet.figure(correlation_of(result.at("covariance")));
  }
  if (has_readings && !readings.joints.empty()) {
    sheet.figure(residuals_by_joint(readings));
  }
}

}  // namespace artcal
