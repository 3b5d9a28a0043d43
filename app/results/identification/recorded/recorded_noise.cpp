#include "app/results/identification/recorded/recorded_noise.h"

#include <fmt/format.h>

namespace artcal {

RecordedNoise recorded_noise(const RecordedObject& identification) {
  const RecordedObject json = identification.object("noise");
  const auto range = json.numbers("chi_squared_95");
  if (range.size() != 2) {
    json.refuse("chi_squared_95", fmt::format("a list of {}, expected two numbers", range.size()));
  }
  return {json.number("mm"),
          json.truth("given"),
          json.number("chi_squared"),
          json.integer("degrees_of_freedom"),
          range[0],
          range[1],
          json.number("scale_factor")};
}

std::optional<RecordedCrossValidation> recorded_cross_validation(const RecordedObject& identification) {
  if (!identification.has("cross_validation")) {
    return std::nullopt;
  }
  const RecordedObject json = identification.object("cross_validation");
  return RecordedCrossValidation{json.count("placements"), json.number("ratio"), json.number("ratio_99"),
                                 json.number("scale")};
}

}  // namespace artcal
