#include "app/report/sections/uncertainty_section.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/report/numbers.h"
#include "core/units.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using namespace numbers;

std::vector<std::string> cells_of(const std::string& what, const SpreadOfU& spread, const std::string& share) {
  if (spread.count == 0) {
    return {what, "out of reach", "–", "–", "–"};
  }
  return {what, micrometres(spread.rms), micrometres(spread.quantile_95), micrometres(spread.maximum), share};
}

Figure map_of(const std::vector<MapCell>& map) {
  Json x = Json::array(), y = Json::array(), values = Json::array();
  const MapCell *best = nullptr, *worst = nullptr;
  for (const MapCell& cell : map) {
    const bool reached = cell.u.count > 0;
    x.push_back(drawn(cell.from_axis));
    y.push_back(drawn(cell.height));
    values.push_back(reached ? drawn(cell.u.rms / units::micrometre) : Json(nullptr));
    if (reached) {
      best = best == nullptr || cell.u.rms < best->u.rms ? &cell : best;
      worst = worst == nullptr || cell.u.rms > worst->u.rms ? &cell : worst;
    }
  }
  const auto told = [&](const MapCell* cell) {
    return cell == nullptr ? std::string("nowhere")
                           : fmt::format("{} µm at {:.0f} mm from axis 1, height {:.0f} mm", micrometres(cell->u.rms),
                                         cell->from_axis, cell->height);
  };
  return {
      "Standard uncertainty of a point over the working volume, µm",
      fmt::format("Least {}; largest {}. The number in a square is u (k = 1) of all three coordinates together, darker "
                  "is larger; small crosses are out of reach.",
                  told(best), told(worst)),
      {{"kind", "map"}, {"unit", "µm"}, {"x", x}, {"y", y}, {"values", values}},
      true};
}

}  // namespace

void write_uncertainty(const RecordedUncertainty& result, Sheet& sheet) {
  sheet.facts(
      {{"Probe", shown(result.probe)},
       {"Noise of a reading", result.encoder > 0.0
                                  ? fmt::format("{:.3g}″ a joint and {:.3g} µm a coordinate",
                                                result.encoder / units::arcsecond, result.probing / units::micrometre)
                                  : fmt::format("{:.3g} µm a coordinate", result.probing / units::micrometre)}});
  html::Table table("Standard uncertainty (k = 1) of what this arm measures, µm, at random places and postures",
                    {{"", false, true}, {"rms of u"}, {"95 % below"}, {"largest u"}, {"rms of the arm's share"}});
  for (const LengthUncertainty& length : result.volume.lengths) {
    table.add(cells_of(fmt::format("length of {:.0f} mm", length.length), length.u, micrometres(length.u_of_arm.rms)));
  }
  table.add(cells_of("diameter of a sphere, 25 points", result.volume.sphere_diameter, "–"));
  sheet.table(table);
  sheet.figure(map_of(result.volume.map));
  sheet.paragraph(
      "This is what the readings behind the arm and their noise leave open, to first order. Errors that the model does "
      "not know (bending, eccentric encoders, temperature) come on top.");
}

}  // namespace artcal
