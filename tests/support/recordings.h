#pragma once

#include <stdexcept>
#include <string>

#include "acquisition/recording/recording_file.h"
#include "artefacts/constraints/bound_recording.h"
#include "identification/identify.h"
#include "tests/support/arms.h"

namespace artcal::test {

/// A failure to read or bind a recording ends the test with its message.
using Bound = BoundRecording;

inline Bound bind(Recording recording, std::vector<Artefact> artefacts) {
  auto constraints = build_constraints(recording, std::move(artefacts));
  if (!constraints) throw std::runtime_error(constraints.error().text());
  return {std::move(recording), std::move(*constraints)};
}

inline Bound read_bound(const std::string& path) {
  auto recording = read_recording(path);
  if (!recording) throw std::runtime_error(recording.error().text());
  auto bound = bind_recording(std::move(*recording));
  if (!bound) throw std::runtime_error(bound.error().text());
  return std::move(*bound);
}

/// The readings of two sessions of one arm as one recording; artefacts of the same name are the same.
inline Bound joined(Bound first, const Bound& second) {
  Recording& all = first.recording;
  const Recording& more = second.recording;
  const Eigen::Index before = all.joints.cols();
  all.joints.conservativeResize(Eigen::NoChange, before + more.joints.cols());
  all.joints.rightCols(more.joints.cols()) = more.joints;
  std::vector<Artefact> artefacts = first.constraints.artefacts;
  for (const Artefact& artefact : second.constraints.artefacts) artefacts.push_back(artefact);
  // A reading that names no artefact means the only one, which it no longer is.
  const auto name_of = [](const Bound& bound, const Reading& reading) {
    const std::string& name = bound.recording.artefacts.name(reading.artefact);
    return name.empty() ? bound.constraints.artefacts.front().name : name;
  };
  for (Reading& reading : all.readings) reading.artefact = all.artefacts.index_of(name_of(first, reading));
  for (Reading reading : more.readings) {
    reading.artefact = all.artefacts.index_of(name_of(second, reading));
    reading.placement = all.placements.index_of(more.placements.name(reading.placement));
    reading.feature = all.features.index_of(more.features.name(reading.feature));
    all.readings.push_back(reading);
  }
  return bind(std::move(first.recording), std::move(artefacts));
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
