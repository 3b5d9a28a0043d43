#include "app/results/evaluation/recorded_evaluation.h"

namespace artcal {
namespace {

RecordedDeviation recorded_deviation(const RecordedObject& json) {
  return {json.text_or("artefact"), json.text_or("placement"), json.count("readings"), json.number_or_nan("rms_mm"),
          json.number_or_nan("maximum_mm")};
}

// Results of earlier versions have the length at the temperature of the placement alone, as `certified_mm`.
RecordedLength recorded_length(const RecordedObject& json) {
  RecordedLength length;
  length.artefact = json.text_or("artefact");
  length.placement = json.text_or("placement");
  length.first = json.text_or("first");
  length.second = json.text_or("second");
  length.certified_at = json.optional_number("certified_at_C");
  length.certified = length.certified_at ? json.optional_number("certified_mm") : std::nullopt;
  length.at_temperature = json.number(json.has("at_temperature_mm") ? "at_temperature_mm" : "certified_mm");
  length.error = json.number_or_nan("error_mm");
  return length;
}

}  // namespace

RecordedEvaluation recorded_evaluation(const RecordedObject& evaluation) {
  return {recorded_deviation(evaluation.object("overall")), evaluation.size_of("artefacts"),
          evaluation.list("placements", recorded_deviation), evaluation.list("lengths", recorded_length)};
}

std::vector<RecordedFeature> recorded_features(const RecordedObject& evaluation_or_verification) {
  return evaluation_or_verification.list("features", [](const RecordedObject& json) {
    return RecordedFeature{json.text_or("artefact"), json.text_or("placement"), json.text_or("feature"),
                           json.point("at_mm")};
  });
}

std::vector<RecordedLeftOut> recorded_left_out(const RecordedObject& identification) {
  return identification.list("left_out", [](const RecordedObject& json) {
    return RecordedLeftOut{recorded_deviation(json), json.list("lengths", recorded_length), json.has("refusal")};
  });
}

std::vector<RecordedOutlier> recorded_outliers(const RecordedObject& identification) {
  return identification.list("outliers", [](const RecordedObject& json) {
    return RecordedOutlier{json.text_or("where"),
                           json.text_or("placement"),
                           json.text_or("feature"),
                           json.number("deviation_mm"),
                           json.truth_or("deviation_is_signed", true),
                           json.number("standardised"),
                           json.number("limit")};
  });
}

}  // namespace artcal
