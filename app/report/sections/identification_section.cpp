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

using Json = nlohmann::ordered_json;
using namespace numbers;

/// All placements that were left out, put together.
struct LeftOutDeviations {
  std::size_t readings = 0;
  double rms = 0.0, maximum = 0.0;
  std::size_t lengths = 0;
  double worst_length = 0.0;  // its error
};

double worst_error(const Json& lengths) {
  double worst = 0.0;
  for (const Json& length : lengths) {
    const double error = number_in(length.at("error_mm"));
    worst = std::isnan(error) ? error : worst;
    worst = std::abs(error) > std::abs(worst) ? error : worst;
  }
  return worst;
}

LeftOutDeviations left_out_of(const Json& result) {
  LeftOutDeviations all;
  double squares = 0.0;
  for (const Json& left : result.at("left_out")) {
    const auto readings = left.at("readings").get<std::size_t>();
    const double rms = left.at("rms_mm");
    all.readings += readings;
    squares += static_cast<double>(readings) * rms * rms;
    const double worst = worst_error(left.at("lengths"));
    all.lengths += left.at("lengths").size();
    all.worst_length = std::abs(worst) > std::abs(all.worst_length) ? worst : all.worst_length;
    all.maximum = std::max(all.maximum, left.at("maximum_mm").get<double>());
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

void write_before_and_after(const Json& result, Sheet& sheet) {
  const Json& before = result.at("before");
  const Json& after = result.at("after");
  const LeftOutDeviations left = left_out_of(result);
  const auto left_or_dash = [&](double value) { return left.readings > 0 ? mm(value) : "–"; };
  html::Table table("Deviation of the readings, mm",
                    {{"", false, true}, {"before"}, {"after"}, {"cross-validation", true, false, false, true}});
  table.add({"root mean square", mm(number_in(before.at("overall").at("rms_mm"))), mm(after.at("overall").at("rms_mm")),
             left_or_dash(left.rms)});
  table.add({"largest", mm(number_in(before.at("overall").at("maximum_mm"))), mm(after.at("overall").at("maximum_mm")),
             left_or_dash(left.maximum)});
  if (!after.at("lengths").empty()) {
    table.add({"worst certified length, error", signed_mm(worst_error(before.at("lengths"))),
               signed_mm(worst_error(after.at("lengths"))), left.lengths > 0 ? signed_mm(left.worst_length) : "–"});
  }
  sheet.table(table);
  if (left.readings > 0) {
    sheet.paragraph(
        "Before: the nominal arm. After: the identified arm, judged by the readings it was identified from. "
        "Cross-validation: each placement evaluated with an arm identified without it; expect this of new readings.");
  }
}

void write_placements(const Json& result, Sheet& sheet) {
  const Json& after = result.at("after").at("placements");
  const Json& before = result.at("before").at("placements");
  html::Table table("Deviation by placement, rms, mm", {{"artefact", false},
                                                        {"placement", false, true},
                                                        {"readings"},
                                                        {"before"},
                                                        {"after"},
                                                        {"largest after"},
                                                        {"cross-val.", true, false, false, true}});
  std::map<std::pair<std::string, std::string>, const Json*> left_out;
  for (const Json& left : result.at("left_out")) {
    left_out.emplace(std::pair(text_in(left, "artefact"), text_in(left, "placement")), &left);
  }
  for (std::size_t i = 0; i < after.size(); ++i) {
    const Json& row = after[i];
    const auto left = left_out.find({text_in(row, "artefact"), text_in(row, "placement")});
    const std::string left_rms = left == left_out.end()                  ? "–"
                                 : left->second->at("refusal").is_null() ? mm(left->second->at("rms_mm"))
                                                                         : "not possible";
    table.add({shown(text_in(row, "artefact")), shown(text_in(row, "placement")),
               fmt::format("{}", row.at("readings").get<std::size_t>()), mm(number_in(before.at(i).at("rms_mm"))),
               mm(row.at("rms_mm")), mm(row.at("maximum_mm")), left_rms});
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
               shown(text_in(outlier, "feature")), signed_mm(outlier.at("deviation_mm")),
               fmt::format("{:.1f}", outlier.at("standardised").get<double>()),
               fmt::format("{:.1f}", outlier.at("limit").get<double>())});
  }
  sheet.table(table);
}

}  // namespace

void write_identification_verdict(const Json& result, Sheet& sheet) {
  const std::size_t warnings = result.at("warnings").size();
  const std::size_t outliers = result.at("outliers").size();
  const LeftOutDeviations left = left_out_of(result);
  std::string text = fmt::format(
      "{} of {} parameters. Readings deviate by {} mm rms, {} mm at most; by the nominal arm {} mm and {} mm.",
      identified_count(result), result.at("parameters").size(), mm(result.at("after").at("overall").at("rms_mm")),
      mm(result.at("after").at("overall").at("maximum_mm")),
      mm(number_in(result.at("before").at("overall").at("rms_mm"))),
      mm(number_in(result.at("before").at("overall").at("maximum_mm"))));
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
    text += result.at("after").at("placements").size() < 2
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
  write_before_and_after(result, sheet);
  write_placements(result, sheet);
  if (has_readings) {
    sheet.figure(residuals_by_placement(result, readings));
  } else {
    sheet.note("This result was written with --no-residuals: its readings cannot be drawn.");
  }
  write_outliers(result.at("outliers"), sheet);
  if (has_readings) {
    sheet.figure(scene_of(result, readings));
  }
  if (!result.at("after").at("lengths").empty()) {
    write_length_errors(result, sheet);
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
