#include "app/arm/reported_text.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/output/table.h"
#include "app/results/hayati_angles.h"
#include "app/results/identification/coupling_text.h"
#include "app/results/identification/result_json.h"
#include "app/results/shown_unit.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

// rms of a coordinate: the root mean square of the readings' deviations is of three.
double of_coordinate(const ReportedModel& model) { return model.identification.after.overall.rms / std::sqrt(3.0); }

std::string assignment_text(const JointAssignment& assignment) {
  if (assignment.changes_nothing()) {
    return "order, signs and unit of the joints are as the arm's file and the recording state them\n";
  }
  std::string text;
  if (!assignment.keeps_order()) {
    std::vector<std::string> columns;
    for (const int column : assignment.column) {
      columns.push_back(fmt::format("q{}", column + 1));
    }
    text += fmt::format(
        "the columns are in another order: joints 1 to {} are {}; rename the columns of the readings, the arm's file "
        "cannot say it\n",
        columns.size(), fmt::join(columns, ", "));
  }
  std::vector<std::string> turned;
  for (std::size_t i = 0; i < assignment.sign.size(); ++i) {
    if (assignment.sign[i] < 0.0) {
      turned.push_back(fmt::format("{}", i + 1));
    }
  }
  if (!turned.empty()) {
    text += fmt::format("joints that count the other way than the arm's file says: {}; the arm found has their signs\n",
                        fmt::join(turned, ", "));
  }
  if (assignment.factor != 1.0) {
    text +=
        fmt::format("the angles are in {}, not in the unit that the recording states; correct `units.joint` there\n",
                    assignment.factor > 1.0 ? "radians" : "degrees");
  }
  return text;
}

// How far the next best assignment is behind, so that a person sees whether there is any doubt.
std::string rivals_text(const ReportedModel& model) {
  if (!model.next_best) {
    return fmt::format("  of {} orders, signs and units that were tried no other leads to an arm\n", model.tried);
  }
  const bool is_rival = *model.next_best < 2.0 * model.identification.after.overall.rms;
  return fmt::format("  the next best of {} orders, signs and units leaves {:.4g} mm rms{}\n", model.tried,
                     *model.next_best,
                     is_rival ? ": it fits as well, these coordinates do not decide between them" : "");
}

std::string reported_parameters_text(const Identification& result) {
  Table table({"parameter", "unit", "stated", "found", "u (k = 1)"});
  for (const IdentifiedParameter& each : result.parameters) {
    const ShownUnit unit = shown_unit(each.parameter.name, each.parameter.unit());
    const bool found = each.state == ParameterState::Identified || each.state == ParameterState::Weak;
    table.add({each.parameter.name, std::string(unit.name),
               fmt::format("{:.{}f}", each.nominal / unit.size, unit.decimals),
               fmt::format("{:.{}f}", each.identified / unit.size, unit.decimals),
               found ? fmt::format("{:.2g}", each.u / unit.size) : "not identifiable or fixed"});
  }
  return table.text();
}

}  // namespace

std::string reported_text(const ReportedModel& model, const std::string& output) {
  const Identification& result = model.identification;
  std::string text = fmt::format(
      "{}\narm {}: {} readings\n\n{}\ndeviations of the reported coordinates: {:.3g} um rms a coordinate, largest "
      "{:.3g} "
      "um (before: {:.4g} mm rms)\n{}rank {} of {} parameters\n\n{}\n{}{}",
      truncated(60, model.recording.name), in_quotes(model.recording.arm.name), model.recording.readings.size(),
      assignment_text(model.assignment), 1e3 * of_coordinate(model), 1e3 * result.after.overall.maximum,
      result.before.overall.rms, rivals_text(model), result.coupling.rank, result.coupling.parameters.size(),
      hayati_angles_text(model.recording, result), reported_parameters_text(result), cannot_text(result.coupling));
  for (const std::string& warning : result.warnings) {
    text += fmt::format("Warning: {}\n", warning);
  }
  return text + (output.empty() ? "The arm was not written; add -o ARM.toml to keep it.\n"
                                : fmt::format("The arm is in {}.\n", output));
}

Json reported_json(const ReportedModel& model) {
  const Identification& result = model.identification;
  Json json = result_header(model.recording, "reported_model", std::nullopt);
  Json columns = Json::array(), signs = Json::array(), parameters = Json::array();
  for (std::size_t i = 0; i < model.assignment.column.size(); ++i) {
    columns.push_back(model.assignment.column[i] + 1);
    signs.push_back(model.assignment.sign[i]);
  }
  for (const IdentifiedParameter& each : result.parameters) {
    const bool found = each.state == ParameterState::Identified || each.state == ParameterState::Weak;
    parameters.push_back({{"name", each.parameter.name},
                          {"unit", each.parameter.unit()},
                          {"stated", each.nominal},
                          {"found", each.identified},
                          {"standard_uncertainty", found ? Json(each.u) : Json(nullptr)}});
  }
  json["assignment"] = {{"columns", columns},
                        {"signs", signs},
                        {"unit_factor", model.assignment.factor},
                        {"tried", model.tried},
                        {"next_best_rms_mm", model.next_best ? Json(*model.next_best) : Json(nullptr)}};
  json["rank"] = result.coupling.rank;
  json["parameter_count"] = result.coupling.parameters.size();
  json["rms_of_coordinate_mm"] = of_coordinate(model);
  json["largest_mm"] = result.after.overall.maximum;
  json["rms_before_mm"] = result.before.overall.rms;
  json["parameters"] = parameters;
  json["warnings"] = result.warnings;
  return json;
}

}  // namespace artcal
