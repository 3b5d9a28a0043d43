#include "app/results/identification/recorded/recorded_identification.h"

#include <set>
#include <string>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// The covariance is read by place: it must be of what is identified, in that order.
void require_covariance_of_parameters(const RecordedObject& result, const RecordedIdentification& read) {
  std::vector<std::string> identified;
  for (const RecordedParameter& parameter : read.parameters) {
    if (parameter.is_identified()) {
      identified.push_back(parameter.name);
    }
  }
  if (read.covariance.parameters != identified) {
    result.refuse("covariance.parameters", "not the list of the identified parameters in their order");
  }
}

void require_known_parameters(const RecordedObject& result, const RecordedIdentification& read) {
  std::set<std::string> names;
  for (const RecordedParameter& parameter : read.parameters) {
    names.insert(parameter.name);
  }
  for (const auto& direction : read.identifiability.unidentifiable) {
    for (const auto& [name, coefficient] : direction.motion) {
      if (!names.contains(name)) {
        result.refuse("coupling.unidentifiable", fmt::format("a motion of {}, expected a parameter", in_quotes(name)));
      }
    }
  }
}

void require_same_size(const RecordedObject& result, const char* key, std::size_t before, std::size_t after) {
  if (before != after) {
    result.refuse(key, fmt::format("a list of {}, expected {} as in before", after, before));
  }
}

}  // namespace

RecordedIdentification recorded_identification(const RecordedObject& result) {
  const RecordedObject after = result.object("after");
  RecordedIdentification read;
  read.circumstances = recorded_circumstances(result);
  read.left_out_chose_the_model = result.object("model").truth_or("chosen_by_left_out", false);
  read.parameters = recorded_parameters(result);
  read.covariance = recorded_covariance(result);
  read.identifiability = recorded_identifiability(result);
  read.noise = recorded_noise(result);
  read.cross_validation = recorded_cross_validation(result);
  read.before = recorded_evaluation(result.object("before"));
  read.after = recorded_evaluation(after);
  read.features = recorded_features(after);
  read.left_out = recorded_left_out(result);
  read.outliers = recorded_outliers(result);
  read.arm_path = recorded_arm_path(result);
  read.readings = recorded_readings(result, read.features.size());
  require_covariance_of_parameters(result, read);
  require_known_parameters(result, read);
  require_same_size(result, "after.placements", read.before.placements.size(), read.after.placements.size());
  require_same_size(result, "after.lengths", read.before.lengths.size(), read.after.lengths.size());
  return read;
}

}  // namespace artcal
