#include "app/report/sections/beside_values.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/output/phrases.h"
#include "app/report/numbers.h"
#include "app/results/verification/recorded_value.h"
#include "artefacts/verification/decision/specification.h"
#include "core/units.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using namespace numbers;

void write_plate(const Json& plate, Sheet& sheet) {
  const std::string repeat = text_in(plate, "repeat");
  sheet.part(shown(fmt::format("{}, placement {}{}", text_in(plate, "artefact"), text_in(plate, "placement"),
                               repeat.empty() ? "" : ", repeat " + repeat)));
  sheet.paragraph(fmt::format("{}: residuals {} µm rms, scale {:+.2f} ppm (u {:.2f}), worst |En| of a distance {:.2f}.",
                              plural(plate.at("balls").size(), "ball"), micrometres(plate.at("rms_mm")),
                              plate.at("scale_ppm").get<double>(), plate.at("u_scale_ppm").get<double>(),
                              plate.at("en_worst").get<double>()));
  if (!plate.at("finding").is_null()) {
    sheet.note("⚠ " + plate.at("finding").get<std::string>());
  }
  html::Table table(
      "Residuals of the balls in the plate's axes, µm",
      {{"ball", false, true}, {"x"}, {"y"}, {"z"}, {"standardised"}, {"", false, false, false, false, true}});
  for (const Json& ball : plate.at("balls")) {
    const Json& residual = ball.at("residual_mm");
    const bool is_outlier = ball.at("stands_out");
    table.add_markup({html::cell(shown(text_in(ball, "feature"))), signed_micrometres(residual.at(0)),
                      signed_micrometres(residual.at(1)), signed_micrometres(residual.at(2)),
                      fmt::format("{:.1f}", ball.at("standardised").get<double>()), is_outlier ? "⚠ outlier" : ""},
                     is_outlier ? "notable" : "");
  }
  sheet.table(table);
}

void write_calibration(const Json& calibration, Sheet& sheet) {
  sheet.part(fmt::format("The plate {} itself", shown(text_in(calibration, "artefact"))));
  sheet.paragraph(fmt::format("By {}, turned by at least {:.0f}° against each other; the scale is the arm's.",
                              plural(calibration.at("placements").get<std::size_t>(), "placement"),
                              calibration.at("least_turn_rad").get<double>() / units::degree));
  html::Table table("Centres, mm, and what they differ by from the certificate, µm",
                    {{"ball", false, true}, {"x"}, {"y"}, {"z"}, {"Δx"}, {"Δy"}, {"Δz"}, {"u"}});
  for (const Json& ball : calibration.at("balls")) {
    const Json& at = ball.at("at_mm");
    const Json& off = ball.at("deviation_mm");
    table.add({shown(text_in(ball, "feature")), mm(at.at(0)), mm(at.at(1)), mm(at.at(2)), signed_micrometres(off.at(0)),
               signed_micrometres(off.at(1)), signed_micrometres(off.at(2)),
               fmt::format("{:.2f}", number_in(ball.at("u_mm")) / units::micrometre)});
  }
  sheet.table(table);
}

void write_articulations(const Json& articulations, Sheet& sheet) {
  html::Table table("Seats, µm: scatter of a single point while the wrist turns", {{"placement", false, true},
                                                                                   {"feature", false},
                                                                                   {"readings"},
                                                                                   {"maximum"},
                                                                                   {"2 s"},
                                                                                   {"half range x"},
                                                                                   {"y"},
                                                                                   {"z"}});
  for (const Json& seat : articulations) {
    const Json& half = seat.at("half_range_mm");
    table.add({shown(text_in(seat, "placement")), shown(text_in(seat, "feature")),
               fmt::format("{}", seat.at("readings").get<std::size_t>()), micrometres(seat.at("largest_mm")),
               micrometres(seat.at("twice_s_mm")), micrometres(half.at(0)), micrometres(half.at(1)),
               micrometres(half.at(2))});
  }
  sheet.table(table);
}

void write_volumetric(const Json& summary, Sheet& sheet) {
  sheet.facts({{"Volumetric", plural(summary.at("lengths").get<std::size_t>(), "length")},
               {"Maximum", micrometres(summary.at("largest_mm")) + " µm"},
               {"Range", micrometres(summary.at("range_mm")) + " µm"},
               {"2 RMS about zero", micrometres(summary.at("twice_rms_mm")) + " µm"},
               {"2 s about the mean", micrometres(summary.at("twice_s_mm")) + " µm"}});
}

void write_drifts(const Json& interim, Sheet& sheet) {
  html::Table table("Drift since the earlier verification, µm", {{"quantity", false, true},
                                                                 {"placement", false},
                                                                 {"feature", false},
                                                                 {"then"},
                                                                 {"now"},
                                                                 {"drift", true, false, false, false, true},
                                                                 {"u"},
                                                                 {"", false, false, false, false, true}});
  for (const Drift& drift : recorded_drifts(interim)) {
    table.add_markup({html::cell(name_of(drift.quantity)), html::cell(shown(drift.placement)),
                      html::cell(shown(drift.first) + (drift.second.empty() ? "" : " – " + shown(drift.second))),
                      signed_micrometres(drift.then), signed_micrometres(drift.now), signed_micrometres(drift.drift),
                      fmt::format("{:.2f}", drift.u / units::micrometre),
                      drift.significant               ? "⚠ significant"
                      : drift.degrees_of_freedom == 0 ? "not evaluated: no repeats"
                                                      : ""},
                     drift.significant ? "notable" : "");
  }
  sheet.part("Interim check");
  sheet.table(table);
}

}  // namespace

void write_beside_values(const Json& verification, Sheet& sheet) {
  if (!verification.at("interim").is_null()) {
    write_drifts(verification.at("interim"), sheet);
  }
  if (!verification.at("volumetric").is_null()) {
    write_volumetric(verification.at("volumetric"), sheet);
  }
  write_articulations(verification.at("articulations"), sheet);
  for (const Json& plate : verification.at("plates")) {
    write_plate(plate, sheet);
  }
  for (const Json& calibration : verification.at("plate_calibrations")) {
    write_calibration(calibration, sheet);
  }
}

void write_interim_verdict(const Json& interim, Sheet& sheet) {
  const std::vector<Drift> drifts = recorded_drifts(interim);
  const auto significant =
      std::count_if(drifts.begin(), drifts.end(), [](const Drift& drift) { return drift.significant; });
  const bool told =
      std::any_of(drifts.begin(), drifts.end(), [](const Drift& drift) { return drift.degrees_of_freedom > 0; });
  sheet.verdict(significant > 0 ? Mood::Bad
                : told          ? Mood::Good
                                : Mood::Unsure,
                significant > 0 ? "✗ Significant drift"
                : told          ? "✓ No significant drift"
                                : "? Drift not evaluated",
                fmt::format("{} compared with the earlier verification, {} of them significantly different.",
                            plural(drifts.size(), "value"), significant));
}

}  // namespace artcal
