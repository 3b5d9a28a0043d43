#include "app/results/uncertainty/recorded_monte_carlo.h"

#include <fmt/format.h>

namespace artcal {
namespace {

std::optional<Interval> recorded_interval(const RecordedObject& json) {
  if (!json.has("interval_95")) {
    return std::nullopt;
  }
  const auto ends = json.numbers("interval_95");
  if (ends.size() != 2) {
    json.refuse("interval_95", fmt::format("a list of {}, expected two numbers", ends.size()));
  }
  return Interval{ends[0], ends[1]};
}

RecordedQuantity recorded_quantity(const RecordedObject& json) {
  return {json.text("kind"),
          json.text("name"),
          json.text("unit"),
          json.number("estimate"),
          json.optional_number("u_first_order"),
          json.number("u"),
          recorded_interval(json),
          json.truth("stable"),
          json.truth("differs_from_first_order")};
}

}  // namespace

RecordedMonteCarlo recorded_monte_carlo(const RecordedObject& result) {
  const RecordedObject options = result.object("options");
  const RecordedObject noise = options.object("noise");
  const RecordedObject trials = result.object("trials");
  RecordedMonteCarlo read;
  read.model = result.text_or("model");
  read.probe = options.text_or("probe");
  read.noise = {noise.optional_number("reading_mm"), noise.optional_number("encoder_rad"),
                noise.optional_number("probing_mm")};
  read.digits = options.integer("digits");
  read.trials = trials.count("made");
  read.not_converged = trials.count("not_converged");
  read.is_complete = trials.truth("complete");
  read.seed = result.count("seed");
  read.quantities = result.list("quantities", recorded_quantity);
  read.warnings = result.texts("warnings");
  return read;
}

}  // namespace artcal
