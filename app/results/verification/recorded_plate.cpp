#include "app/results/verification/recorded_plate.h"

namespace artcal {
namespace {

RecordedPlate recorded_plate(const RecordedObject& json) {
  RecordedPlate plate;
  plate.artefact = json.text_or("artefact");
  plate.placement = json.text_or("placement");
  plate.repeat = json.text_or("repeat");
  plate.rms = json.number("rms_mm");
  plate.scale_ppm = json.number("scale_ppm");
  plate.u_scale_ppm = json.number("u_scale_ppm");
  plate.en_worst = json.number("en_worst");
  plate.finding = json.text_or("finding");
  plate.balls = json.list("balls", [](const RecordedObject& ball) {
    return RecordedPlate::Ball{ball.text_or("feature"), ball.point("residual_mm"), ball.number("standardised"),
                               ball.truth("stands_out")};
  });
  return plate;
}

RecordedCalibration recorded_calibration(const RecordedObject& json) {
  RecordedCalibration calibration;
  calibration.artefact = json.text_or("artefact");
  calibration.placements = json.count("placements");
  calibration.least_turn = json.number("least_turn_rad");
  calibration.balls = json.list("balls", [](const RecordedObject& ball) {
    return RecordedCalibration::Ball{ball.text_or("feature"), ball.point("at_mm"), ball.point("deviation_mm"),
                                     ball.number_or_nan("u_mm")};
  });
  return calibration;
}

Articulation recorded_articulation(const RecordedObject& json) {
  return {json.text_or("artefact"),  json.text_or("placement"), json.text_or("feature"),    json.integer("readings"),
          json.number("largest_mm"), json.number("twice_s_mm"), json.point("half_range_mm")};
}

}  // namespace

std::vector<RecordedPlate> recorded_plates(const RecordedObject& verification) {
  return verification.list("plates", recorded_plate);
}

std::vector<RecordedCalibration> recorded_calibrations(const RecordedObject& verification) {
  return verification.list("plate_calibrations", recorded_calibration);
}

std::vector<Articulation> recorded_articulations(const RecordedObject& verification) {
  return verification.list("articulations", recorded_articulation);
}

std::optional<VolumetricSummary> recorded_volumetric(const RecordedObject& verification) {
  if (!verification.has("volumetric")) {
    return std::nullopt;
  }
  const RecordedObject json = verification.object("volumetric");
  return VolumetricSummary{json.integer("lengths"), json.number("largest_mm"), json.number("range_mm"),
                           json.number("twice_rms_mm"), json.number("twice_s_mm")};
}

}  // namespace artcal
