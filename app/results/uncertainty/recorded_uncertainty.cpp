#include "app/results/uncertainty/recorded_uncertainty.h"

namespace artcal {
namespace {

SpreadOfU recorded_spread(const RecordedObject& json) {
  return {json.integer("count"), json.number("rms_mm"), json.number("quantile_95_mm"), json.number("maximum_mm")};
}

}  // namespace

RecordedUncertainty recorded_uncertainty(const RecordedObject& result) {
  RecordedUncertainty read{
      result.text_or("probe"), result.number("encoder_noise_rad"), result.number("probing_noise_mm"), {}};
  read.volume.lengths = result.list("lengths", [](const RecordedObject& json) {
    return LengthUncertainty{json.number("length_mm"), recorded_spread(json.object("u")),
                             recorded_spread(json.object("u_of_the_arm"))};
  });
  read.volume.sphere_diameter = recorded_spread(result.object("sphere_diameter"));
  read.volume.map = result.list("map", [](const RecordedObject& json) {
    return MapCell{json.number("from_axis_mm"), json.number("height_mm"), recorded_spread(json.object("u_of_a_point"))};
  });
  return read;
}

}  // namespace artcal
