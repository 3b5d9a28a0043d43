#include "app/report/sections/uncertainty_section.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/report/numbers.h"
#include "core/units.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using namespace numbers;

std::vector<std::string> cells_of(const std::string& what, const Json& spread, const std::string& share) {
  if (spread.at("count").get<int>() == 0) {
    return {what, "out of reach", "–", "–", "–"};
  }
  return {what, micrometres(spread.at("rms_mm")), micrometres(spread.at("quantile_95_mm")),
          micrometres(spread.at("maximum_mm")), share};
}

Figure map_of(const Json& map) {
  Json x = Json::array(), y = Json::array(), values = Json::array();
  const Json *best = nullptr, *worst = nullptr;
  const auto u = [](const Json& cell) { return cell.at("u_of_a_point").at("rms_mm").get<double>(); };
  for (const Json& cell : map) {
    const bool reached = cell.at("u_of_a_point").at("count").get<int>() > 0;
    x.push_back(drawn(cell.at("from_axis_mm")));
    y.push_back(drawn(cell.at("height_mm")));
    values.push_back(reached ? drawn(u(cell) / units::micrometre) : Json(nullptr));
    if (reached) {
      best = best == nullptr || u(cell) < u(*best) ? &cell : best;
      worst = worst == nullptr || u(cell) > u(*worst) ? &cell : worst;
    }
  }
  const auto told = [&](const Json* cell) {
    return cell == nullptr ? std::string("nowhere")
                           : fmt::format("{} µm at {:.0f} mm from axis 1, height {:.0f} mm", micrometres(u(*cell)),
                                         cell->at("from_axis_mm").get<double>(), cell->at("height_mm").get<double>());
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

void write_uncertainty(const Json& result, Sheet& sheet) {
  const double encoder = result.at("encoder_noise_rad");
  const double probing = result.at("probing_noise_mm");
  sheet.facts(
      {{"Probe", shown(text_in(result, "probe"))},
       {"Noise of a reading", encoder > 0.0 ? fmt::format("{:.3g}″ a joint and {:.3g} µm a coordinate",
                                                          encoder / units::arcsecond, probing / units::micrometre)
                                            : fmt::format("{:.3g} µm a coordinate", probing / units::micrometre)}});
  html::Table table("Standard uncertainty (k = 1) of what this arm measures, µm, at random places and postures",
                    {{"", false, true}, {"rms of u"}, {"95 % below"}, {"largest u"}, {"rms of the arm's share"}});
  for (const Json& length : result.at("lengths")) {
    table.add(cells_of(fmt::format("length of {:.0f} mm", length.at("length_mm").get<double>()), length.at("u"),
                       micrometres(length.at("u_of_the_arm").at("rms_mm"))));
  }
  table.add(cells_of("diameter of a sphere, 25 points", result.at("sphere_diameter"), "–"));
  sheet.table(table);
  sheet.figure(map_of(result.at("map")));
  sheet.paragraph(
      "This is what the readings behind the arm and their noise leave open, to first order. Errors that the model does "
      "not know (bending, eccentric encoders, temperature) come on top.");
}

}  // namespace artcal
