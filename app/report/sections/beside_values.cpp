#include "app/report/sections/beside_values.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/output/phrases.h"
#include "app/report/numbers.h"
#include "artefacts/verification/decision/specification.h"
#include "core/units.h"

namespace artcal {
namespace {

using namespace numbers;

void write_plate(const RecordedPlate& plate, Sheet& sheet) {
  sheet.part(shown(fmt::format("{}, placement {}{}", plate.artefact, plate.placement,
                               plate.repeat.empty() ? "" : ", repeat " + plate.repeat)));
  sheet.paragraph(fmt::format("{}: residuals {} µm rms, scale {:+.2f} ppm (u {:.2f}), worst |En| of a distance {:.2f}.",
                              plural(plate.balls.size(), "ball"), micrometres(plate.rms), plate.scale_ppm,
                              plate.u_scale_ppm, plate.en_worst));
  if (!plate.finding.empty()) {
    sheet.note("⚠ " + plate.finding);
  }
  html::Table table(
      "Residuals of the balls in the plate's axes, µm",
      {{"ball", false, true}, {"x"}, {"y"}, {"z"}, {"standardised"}, {"", false, false, false, false, true}});
  for (const RecordedPlate::Ball& ball : plate.balls) {
    table.add_markup({html::cell(shown(ball.feature)), signed_micrometres(ball.residual.x()),
                      signed_micrometres(ball.residual.y()), signed_micrometres(ball.residual.z()),
                      fmt::format("{:.1f}", ball.standardised), ball.is_outlier ? "⚠ outlier" : ""},
                     ball.is_outlier ? "notable" : "");
  }
  sheet.table(table);
}

void write_calibration(const RecordedCalibration& calibration, Sheet& sheet) {
  sheet.part(fmt::format("The plate {} itself", shown(calibration.artefact)));
  sheet.paragraph(fmt::format("By {}, turned by at least {:.0f}° against each other; the scale is the arm's.",
                              plural(calibration.placements, "placement"), calibration.least_turn / units::degree));
  html::Table table("Centres, mm, and what they differ by from the certificate, µm",
                    {{"ball", false, true}, {"x"}, {"y"}, {"z"}, {"Δx"}, {"Δy"}, {"Δz"}, {"u"}});
  for (const RecordedCalibration::Ball& ball : calibration.balls) {
    table.add({shown(ball.feature), mm(ball.at.x()), mm(ball.at.y()), mm(ball.at.z()),
               signed_micrometres(ball.deviation.x()), signed_micrometres(ball.deviation.y()),
               signed_micrometres(ball.deviation.z()), fmt::format("{:.2f}", ball.u / units::micrometre)});
  }
  sheet.table(table);
}

void write_articulations(const std::vector<Articulation>& articulations, Sheet& sheet) {
  html::Table table("Seats, µm: scatter of a single point while the wrist turns", {{"placement", false, true},
                                                                                   {"feature", false},
                                                                                   {"readings"},
                                                                                   {"maximum"},
                                                                                   {"2 s"},
                                                                                   {"half range x"},
                                                                                   {"y"},
                                                                                   {"z"}});
  for (const Articulation& seat : articulations) {
    table.add({shown(seat.placement), shown(seat.feature), fmt::format("{}", seat.readings), micrometres(seat.largest),
               micrometres(seat.twice_s), micrometres(seat.half_range.x()), micrometres(seat.half_range.y()),
               micrometres(seat.half_range.z())});
  }
  sheet.table(table);
}

void write_volumetric(const VolumetricSummary& summary, Sheet& sheet) {
  sheet.facts({{"Volumetric", plural(static_cast<std::size_t>(summary.lengths), "length")},
               {"Maximum", micrometres(summary.largest) + " µm"},
               {"Range", micrometres(summary.range) + " µm"},
               {"2 RMS about zero", micrometres(summary.twice_rms) + " µm"},
               {"2 s about the mean", micrometres(summary.twice_s) + " µm"}});
}

void write_drifts(const std::vector<Drift>& drifts, Sheet& sheet) {
  html::Table table("Drift since the earlier verification, µm", {{"quantity", false, true},
                                                                 {"placement", false},
                                                                 {"feature", false},
                                                                 {"then"},
                                                                 {"now"},
                                                                 {"drift", true, false, false, false, true},
                                                                 {"u"},
                                                                 {"", false, false, false, false, true}});
  for (const Drift& drift : drifts) {
    table.add_markup({html::cell(name_of(drift.quantity)), html::cell(shown(drift.placement)),
                      html::cell(shown(drift.first) + (drift.second.empty() ? "" : " – " + shown(drift.second))),
                      deviation_micrometres(drift.then, is_signed(drift.quantity)),
                      deviation_micrometres(drift.now, is_signed(drift.quantity)), signed_micrometres(drift.drift),
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

void write_beside_values(const RecordedVerification& verification, Sheet& sheet) {
  if (verification.drifts) {
    write_drifts(*verification.drifts, sheet);
  }
  if (verification.volumetric) {
    write_volumetric(*verification.volumetric, sheet);
  }
  write_articulations(verification.articulations, sheet);
  for (const RecordedPlate& plate : verification.plates) {
    write_plate(plate, sheet);
  }
  for (const RecordedCalibration& calibration : verification.calibrations) {
    write_calibration(calibration, sheet);
  }
}

void write_interim_verdict(const std::vector<Drift>& drifts, Sheet& sheet) {
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
