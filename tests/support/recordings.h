#pragma once

#include <stdexcept>
#include <string>

#include "acquisition/recording_file.h"
#include "artefacts/constraint.h"
#include "identification/identify.h"
#include "tests/support/arms.h"

namespace artcal::test {

/// A recording bound to its artefacts; a failure to read one ends the test with its message.
struct Bound {
  Recording recording;
  Constraints constraints;
};

inline Bound bind(Recording recording, std::vector<Artefact> artefacts) {
  auto constraints = build_constraints(recording, std::move(artefacts));
  if (!constraints) throw std::runtime_error(constraints.error().text());
  return {std::move(recording), std::move(*constraints)};
}

inline Bound read_bound(const std::string& path) {
  auto recording = read_recording(path);
  if (!recording) throw std::runtime_error(recording.error().text());
  auto constraints = read_constraints(*recording);
  if (!constraints) throw std::runtime_error(constraints.error().text());
  return {std::move(*recording), std::move(*constraints)};
}

inline Identification identified(const Bound& bound, const IdentifyOptions& options) {
  auto result = identify(bound.recording, bound.constraints, options);
  if (!result) throw std::runtime_error(result.error().text());
  return std::move(*result);
}

inline double identified_value(const Identification& result, const std::string& name) {
  for (const auto& parameter : result.parameters) {
    if (parameter.parameter.name == name) return parameter.identified;
  }
  throw std::runtime_error("no parameter " + name);
}

inline ParameterState state_of(const Identification& result, const std::string& name) {
  for (const auto& parameter : result.parameters) {
    if (parameter.parameter.name == name) return parameter.state;
  }
  throw std::runtime_error("no parameter " + name);
}

}  // namespace artcal::test
