#include "app/results/uncertainty/monte_carlo_result.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/output/phrases.h"
#include "app/output/table.h"
#include "app/results/identification/result_json.h"
#include "app/results/result_head.h"
#include "app/results/result_names.h"
#include "app/results/shown_unit.h"
#include "app/results/uncertainty/measurand_family.h"
#include "app/results/uncertainty/uncertainty_result.h"
#include "app/version.h"
#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(Measurand::Kind kind) {
  switch (kind) {
    case Measurand::Kind::Parameter: return "parameter";
    case Measurand::Kind::Coordinate: return "coordinate";
    case Measurand::Kind::Length: return "length";
    case Measurand::Kind::EUni: return "E_Uni";
    case Measurand::Kind::PSize: return "P_Size";
    case Measurand::Kind::LDia: break;
  }
  return "L_Dia";
}

Json interval_json(const std::optional<Interval>& interval) {
  return interval ? Json{interval->low, interval->high} : Json(nullptr);
}

Json quantity_json(const Measurand& quantity, const MonteCarloSummary& result) {
  return {{"kind", name_of(quantity.kind)},
          {"name", quantity.name},
          {"unit", quantity.unit},
          {"estimate", quantity.estimate},
          {"u_first_order", quantity.u_linear ? Json(*quantity.u_linear) : Json(nullptr)},
          {"mean", result.mean},
          {"u", result.u},
          {"interval_95", interval_json(result.symmetric)},
          {"shortest_95", interval_json(result.shortest)},
          {"tolerance", result.tolerance},
          {"stable", result.stable},
          {"differs_from_first_order", result.differs_from_linear}};
}

Json noise_json(const Noise& noise) {
  const auto number = [](const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); };
  return {{"reading_mm", number(noise.reading)},
          {"encoder_rad", number(noise.encoder)},
          {"probing_mm", number(noise.probing)}};
}

std::string parameters_text(const MonteCarloResult& result, const std::vector<MonteCarloSummary>& summary) {
  Table table({"parameter", "unit", "identified", "u, first order", "u, Monte Carlo", "95 % from", "to"});
  for (std::size_t i = 0; i < summary.size(); ++i) {
    const Measurand& quantity = result.quantities[i];
    if (quantity.kind != Measurand::Kind::Parameter) {
      continue;
    }
    const ShownUnit unit = shown_unit(quantity.name, quantity.unit);
    const auto digits = [&](double value) { return fmt::format("{:.{}f}", value / unit.size, unit.decimals); };
    const auto& interval = summary[i].symmetric;
    table.add({quantity.name, unit.name, digits(quantity.estimate),
               fmt::format("{:.2g}", quantity.u_linear.value_or(0.0) / unit.size),
               fmt::format("{:.2g}{}", summary[i].u / unit.size, summary[i].differs_from_linear ? " !" : ""),
               interval ? digits(interval->low) : "beyond", interval ? digits(interval->high) : "beyond"});
  }
  return table.text();
}

/// Several quantities of one kind, told in one line.
struct Family {
  std::string name;
  int count = 0;
  double linear = 0.0, monte_carlo = 0.0;  ///< sums of squares
  double widest = 0.0;
  bool differs = false;
};

std::string measured_text(const MonteCarloResult& result, const std::vector<MonteCarloSummary>& summary) {
  std::vector<Family> families;
  for (std::size_t i = 0; i < summary.size(); ++i) {
    const std::string name = measurand_family(name_of(result.quantities[i].kind), result.quantities[i].name);
    if (name.empty()) {
      continue;
    }
    auto family = std::find_if(families.begin(), families.end(), [&](const Family& f) { return f.name == name; });
    if (family == families.end()) {
      family = families.insert(families.end(), {name});
    }
    ++family->count;
    family->linear += std::pow(result.quantities[i].u_linear.value_or(0.0), 2);
    family->monte_carlo += summary[i].u * summary[i].u;
    family->differs = family->differs || summary[i].differs_from_linear;
    if (summary[i].symmetric) {
      family->widest = std::max(family->widest, summary[i].symmetric->high - summary[i].symmetric->low);
    }
  }
  Table table({"what it measures, um", "number", "u, first order", "u, Monte Carlo", "95 %, widest"});
  for (const Family& family : families) {
    const auto rms = [&](double squares) { return std::sqrt(squares / family.count) / units::micrometre; };
    table.add({family.name, fmt::format("{}", family.count),
               family.linear > 0.0 ? fmt::format("{:.2f}", rms(family.linear)) : "not linear",
               fmt::format("{:.2f}{}", rms(family.monte_carlo), family.differs ? " !" : ""),
               fmt::format("{:.2f}", family.widest / units::micrometre)});
  }
  return table.text();
}

std::string differing_text(const MonteCarloResult& result, const std::vector<MonteCarloSummary>& summary) {
  std::vector<std::string> named;
  std::size_t more = 0;
  for (std::size_t i = 0; i < summary.size(); ++i) {
    if (summary[i].differs_from_linear) {
      if (named.size() < 8) {
        named.push_back(fmt::format("{} {} (times {:.2f})", name_of(result.quantities[i].kind),
                                    result.quantities[i].name, summary[i].u / *result.quantities[i].u_linear));
      } else {
        ++more;
      }
    }
  }
  if (named.empty()) {
    return "First order and Monte Carlo agree within 10 % everywhere.\n";
  }
  return fmt::format("! u differs by more than 10 % from first order, rely on the Monte Carlo: {}{}\n",
                     fmt::join(named, ", "), more > 0 ? fmt::format(" and {} more", more) : "");
}

}  // namespace

Json made_from_json(const Recording& recording, const IdentifyOptions& options, const Identification& identification,
                    const MonteCarloOptions& monte_carlo) {
  Json json;
  json["program"] = program_version;
  json["inputs"] = Json::array();
  for (const InputFile& input : recording.inputs) {
    json["inputs"].push_back(input.sha256);
  }
  json["hold"] = options.hold;
  json["free"] = options.free;
  json["model"] = model_text(identification.model);
  json["loss"] = result_name(options.loss);
  json["noise"] = noise_json(options.noise);
  json["u_temperature_K"] = monte_carlo.u_temperature;
  json["u_arm_temperature_K"] = monte_carlo.u_arm_temperature;
  json["seed"] = monte_carlo.seed;
  json["probe"] = monte_carlo.measuring.probe;
  json["points_mm"] = Json::array();
  for (const Eigen::Vector3d& point : monte_carlo.measuring.points_in_base) {
    json["points_mm"].push_back({point.x(), point.y(), point.z()});
  }
  return json;
}

Json to_json(const MonteCarloResult& result) {
  Json json = result_header(result.recording, "monte-carlo", result.monte_carlo.seed);
  json["options"] = {{"hold", result.options.hold},
                     {"free", result.options.free},
                     {"model", result.options.automatic ? "auto" : model_text(result.options.model)},
                     {"loss", result_name(result.options.loss)},
                     {"noise", noise_json(result.options.noise)},
                     {"u_temperature_K", result.monte_carlo.u_temperature},
                     {"u_arm_temperature_K", result.monte_carlo.u_arm_temperature},
                     {"probe", result.recording.arm.probes[result.monte_carlo.measuring.probe].name},
                     {"digits", result.wanted.digits}};
  json["model"] = model_text(result.identification.model);
  json["noise_mm"] = result.identification.noise;
  json["scale_factor"] = result.identification.scale_factor;
  json["trials"] = {{"first", result.count.first},
                    {"made", result.count.end - result.count.first},
                    {"wanted", result.wanted.number ? Json(*result.wanted.number) : Json(nullptr)},
                    {"complete", result.complete},
                    {"not_converged", result.count.not_converged},
                    {"not_converged_first", result.count.not_converged_first}};
  json["resolution"] = 1.0 / Distribution::cells_per_scale;
  json["quantities"] = Json::array();
  const auto summary = result.summary();
  for (std::size_t i = 0; i < summary.size(); ++i) {
    json["quantities"].push_back(quantity_json(result.quantities[i], summary[i]));
  }
  json["warnings"] = result.identification.warnings;
  return json;
}

std::string to_text(const MonteCarloResult& result) {
  const auto summary = result.summary();
  const std::int64_t made = result.count.end - result.count.first;
  const auto open =
      std::count_if(summary.begin(), summary.end(), [](const auto& quantity) { return !quantity.stable; });
  std::string text = fmt::format(
      "{}\narm {}: identified {} times from readings and certificates drawn anew (seed {}); {} did not converge\n",
      truncated(60, result.recording.name), in_quotes(truncated(60, result.recording.arm.name)), made,
      result.monte_carlo.seed, result.count.not_converged);
  if (result.options.automatic) {
    text += fmt::format(
        "model {}, which these readings chose: that they might have chosen another is in none of these numbers\n",
        model_text(result.identification.model));
  } else if (!result.identification.model.empty()) {
    text += fmt::format("model {}\n", model_text(result.identification.model));
  }
  if (!result.complete) {
    text += fmt::format("STOPPED after {} trials, before there were enough.\n", made);
  }
  text += open == 0 ? fmt::format("u and both ends of each interval are stable to {} significant digits of u.\n",
                                  result.wanted.digits)
                    : fmt::format(
                          "{} of {} quantities are not stable to {} significant digits of u yet; more trials would "
                          "help.\n",
                          open, summary.size(), result.wanted.digits);
  return text + warning_lines(result.identification.warnings) + "\n" + parameters_text(result, summary) + "\n" +
         measured_text(result, summary) + at_what_temperature(result.identification.arm) + "\n" +
         differing_text(result, summary);
}

}  // namespace artcal
