#include "app/results/uncertainty/uncertainty_result.h"

#include <fmt/format.h>

#include "app/output/table.h"
#include "app/results/result_head.h"
#include "app/results/shown_unit.h"
#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

Json spread_json(const SpreadOfU& spread) {
  return {{"count", spread.count},
          {"rms_mm", spread.rms},
          {"quantile_95_mm", spread.quantile_95},
          {"maximum_mm", spread.maximum}};
}

std::string lengths_text(const WorkingVolume& volume) {
  Table table({"length", "mm", "rms of u", "95 % below", "largest u", "rms of the arm's share"});
  const auto add = [&](const std::string& what, const std::string& length, const SpreadOfU& u,
                       const std::string& share) {
    table.add(u.count == 0 ? std::vector<std::string>{what, length, "out of reach", "", "", ""}
                           : std::vector<std::string>{what, length, in_micrometres(u.rms),
                                                      in_micrometres(u.quantile_95), in_micrometres(u.maximum), share});
  };
  for (const LengthUncertainty& length : volume.lengths) {
    add("between two points", fmt::format("{:.0f}", length.length), length.u, in_micrometres(length.u_of_arm.rms));
  }
  add("diameter of a sphere, 25 points", "", volume.sphere_diameter, "");
  return table.text();
}

// Heights down the page, distances from axis 1 across it; a point where the arm does not get to.
std::string map_text(const WorkingVolume& volume, int rings) {
  std::vector<std::string> header{"height \\ from axis 1"};
  const int levels = 2 * rings;
  for (int ring = 0; ring < rings; ++ring) {
    header.push_back(fmt::format("{:.0f}", volume.map[ring * levels].from_axis));
  }
  Table table(header);
  for (int level = levels - 1; level >= 0; --level) {
    std::vector<std::string> row{fmt::format("{:.0f}", volume.map[level].height)};
    for (int ring = 0; ring < rings; ++ring) {
      const SpreadOfU& u = volume.map[ring * levels + level].u;
      row.push_back(u.count == 0 ? "." : in_micrometres(u.rms));
    }
    table.add(row);
  }
  return table.text();
}

std::string noise_text(const UncertaintySources& sources) {
  return sources.encoder > 0.0 ? fmt::format("{:.3g} arc seconds a joint and {:.3g} um a coordinate",
                                             sources.encoder / units::arcsecond, sources.probing / units::micrometre)
                               : fmt::format("{:.3g} um a coordinate", sources.probing / units::micrometre);
}

std::string unmodelled_text(const std::optional<ArmIdentification>& known) {
  if (known && known->unmodelled > 1.0) {
    return fmt::format(
        "Unmodelled error is in it as\nfar as placements left out showed it: the arm's share is enlarged by {:.3g}.\n",
        known->unmodelled);
  }
  return "Errors that its model\n"
         "does not have (with the chain alone: bending, eccentric encoders, temperature) come on top.\n";
}

}  // namespace

std::string at_what_temperature(const Arm& arm) {
  return expands(arm)
             ? fmt::format("All of it with the arm at {:g} C, its reference temperature.\n", arm.reference_temperature)
             : "";
}

Json to_json(const SurveyResult& result) {
  Json json = result_head("uncertainty");
  json["arm"] = result.file.arm.name;
  json["probe"] = result.file.arm.probes[result.probe].name;
  json["inputs"] = inputs_json({result.file.input});
  json["seed"] = result.sampling.seed;
  json["encoder_noise_rad"] = result.sources.encoder;
  json["probing_noise_mm"] = result.sources.probing;
  json["unmodelled"] = result.file.identification ? result.file.identification->unmodelled : 1.0;
  json["lengths"] = Json::array();
  for (const LengthUncertainty& length : result.volume.lengths) {
    json["lengths"].push_back(
        {{"length_mm", length.length}, {"u", spread_json(length.u)}, {"u_of_the_arm", spread_json(length.u_of_arm)}});
  }
  json["sphere_diameter"] = spread_json(result.volume.sphere_diameter);
  json["map"] = Json::array();
  for (const MapCell& cell : result.volume.map) {
    json["map"].push_back(
        {{"from_axis_mm", cell.from_axis}, {"height_mm", cell.height}, {"u_of_a_point", spread_json(cell.u)}});
  }
  return json;
}

std::string to_text(const SurveyResult& result) {
  return fmt::format(
      "arm {}, {} identified parameters; noise of a reading: {}\n\n"
      "Standard uncertainty (k = 1, um) of what this arm measures, at random places and postures:\n\n{}\n"
      "Standard uncertainty of a point (um, all three coordinates together) over the working volume, in the base\n"
      "frame of this arm; mm, . = out of reach:\n\n{}\n"
      "{}This is what the readings behind the arm and their noise leave open, to first order. {}",
      in_quotes(truncated(60, result.file.arm.name)), result.sources.parameters.size(), noise_text(result.sources),
      lengths_text(result.volume), map_text(result.volume, result.sampling.rings), at_what_temperature(result.file.arm),
      unmodelled_text(result.file.identification));
}

}  // namespace artcal
