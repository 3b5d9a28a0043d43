#include "app/results/verification/recorded_plate.h"

#include "app/results/recorded_json.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

Eigen::Vector3d vector_from(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

RecordedPlate plate_from(const Json& json) {
  RecordedPlate plate;
  plate.artefact = recorded_text(json, "artefact");
  plate.placement = recorded_text(json, "placement");
  plate.repeat = recorded_text(json, "repeat");
  plate.rms = json.at("rms_mm");
  plate.scale_ppm = json.at("scale_ppm");
  plate.u_scale_ppm = json.at("u_scale_ppm");
  plate.en_worst = json.at("en_worst");
  plate.finding = recorded_text(json, "finding");
  for (const Json& ball : json.at("balls")) {
    plate.balls.push_back({recorded_text(ball, "feature"), vector_from(ball.at("residual_mm")), ball.at("standardised"),
                           ball.at("stands_out")});
  }
  return plate;
}

RecordedCalibration calibration_from(const Json& json) {
  RecordedCalibration calibration;
  calibration.artefact = recorded_text(json, "artefact");
  calibration.placements = json.at("placements");
  calibration.least_turn = json.at("least_turn_rad");
  for (const Json& ball : json.at("balls")) {
    calibration.balls.push_back({recorded_text(ball, "feature"), vector_from(ball.at("at_mm")),
                                 vector_from(ball.at("deviation_mm")), recorded_number(ball.at("u_mm"))});
  }
  return calibration;
}

Articulation articulation_from(const Json& json) {
  return {recorded_text(json, "artefact"),
          recorded_text(json, "placement"),
          recorded_text(json, "feature"),
          json.at("readings").get<int>(),
          json.at("largest_mm"),
          json.at("twice_s_mm"),
          vector_from(json.at("half_range_mm"))};
}

template <typename Read>
auto all_of(const Json& list, Read&& read) {
  std::vector<decltype(read(list))> all;
  for (const Json& json : list) {
    all.push_back(read(json));
  }
  return all;
}

}  // namespace

std::vector<RecordedPlate> recorded_plates(const Json& plates) { return all_of(plates, plate_from); }

std::vector<RecordedCalibration> recorded_calibrations(const Json& calibrations) {
  return all_of(calibrations, calibration_from);
}

std::vector<Articulation> recorded_articulations(const Json& articulations) {
  return all_of(articulations, articulation_from);
}

VolumetricSummary recorded_volumetric(const Json& summary) {
  return {summary.at("lengths").get<int>(), summary.at("largest_mm"), summary.at("range_mm"),
          summary.at("twice_rms_mm"), summary.at("twice_s_mm")};
}

}  // namespace artcal
