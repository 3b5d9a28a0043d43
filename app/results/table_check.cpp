#include "app/results/table_check.h"

#include <string>

#include "app/results/evaluation/recorded_evaluation.h"
#include "app/results/evaluation/recorded_readings.h"
#include "app/results/identification/recorded/recorded_parameters.h"
#include "app/results/verification/recorded_value.h"

namespace artcal {
namespace {

void read_table(const RecordedObject& result, std::string_view part) {
  const std::string kind = result.text("kind");
  if (part == "readings") {
    (void)recorded_readings(result, recorded_features(result.object("after")).size());
  } else if (kind == "identification" && part == "parameters") {
    (void)recorded_parameters(result);
  } else if (kind == "identification" && part == "lengths") {
    (void)recorded_evaluation(result.object("after"));
  } else if (kind == "verification") {
    (void)recorded_values(result);
  }
}

}  // namespace

Expected<void> check_table(const nlohmann::ordered_json& result, std::string_view part) {
  try {
    read_table(RecordedObject(result), part);
    return {};
  } catch (const NotAsInSchema& reason) {
    return bad_input("the result is not as --json wrote it: " + std::string(reason.what()));
  }
}

}  // namespace artcal
