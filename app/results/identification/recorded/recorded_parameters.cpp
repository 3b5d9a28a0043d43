#include "app/results/identification/recorded/recorded_parameters.h"

#include "app/results/result_names.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

RecordedParameter recorded_parameter(const RecordedObject& json) {
  RecordedParameter parameter{json.text("name"), json.text("unit"), json.number("nominal"), json.number("identified")};
  const std::string state = json.text("state");
  const auto named = parameter_state_named(state);
  if (!named) {
    json.refuse("state", in_quotes(state) + ", expected identified, weak, fixed or unidentifiable");
  }
  parameter.state = *named;
  if (parameter.is_identified()) {
    parameter.u = json.number("standard_uncertainty");
    parameter.degrees_of_freedom = json.optional_number("degrees_of_freedom").value_or(parameter.degrees_of_freedom);
  }
  return parameter;
}

}  // namespace

bool RecordedParameter::is_identified() const {
  return state == ParameterState::Identified || state == ParameterState::Weak;
}

std::vector<RecordedParameter> recorded_parameters(const RecordedObject& identification) {
  return identification.list("parameters", recorded_parameter);
}

RecordedCovariance recorded_covariance(const RecordedObject& identification) {
  const RecordedObject json = identification.object("covariance");
  RecordedCovariance covariance{json.texts("parameters"), {}};
  covariance.matrix = json.square_matrix("matrix", covariance.parameters.size());
  return covariance;
}

RecordedIdentifiability recorded_identifiability(const RecordedObject& identification) {
  const RecordedObject json = identification.object("coupling");
  return {json.count("parameter_count"), json.count("rank"), json.number("angle_scale_mm"),
          json.list("unidentifiable",
                    [](const RecordedObject& direction) {
                      return RecordedIdentifiability::Direction{direction.text("fixed"), direction.text("text"),
                                                                direction.numbers_by_name("motion")};
                    }),
          json.list("weak", [](const RecordedObject& direction) { return direction.text("text"); })};
}

}  // namespace artcal
