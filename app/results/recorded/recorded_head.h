#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "app/results/recorded/recorded_object.h"
#include "core/files/input_file.h"

namespace artcal {

/// What results of all kinds state of their origin.
struct RecordedHead {
  std::string kind, arm;
  std::string recording;  ///< its name; empty where the result is of an arm alone
  std::string date;       ///< of the measurement; empty: not stated
  std::string program, version;
  std::vector<InputFile> inputs;
};

/// An artefact and its certificate (table "artefact" of docs/result-schema.md). Texts that are not stated are empty.
struct RecordedArtefact {
  std::string name, type;
  bool is_certified = false;
  std::string number, laboratory, date, valid_until;
};

/// What was measured with what, and what was warned of.
struct RecordedCircumstances {
  struct Temperatures {
    double lowest = 0.0, highest = 0.0;  ///< °C
  };
  std::optional<Temperatures> temperatures;  ///< nothing where none was read
  std::size_t readings = 0;
  std::optional<std::size_t> features, placements;  ///< of an identification
  std::vector<RecordedArtefact> artefacts;
  std::vector<std::string> warnings;
};

/// Each throws NotAsInSchema.
RecordedHead recorded_head(const RecordedObject& result);
RecordedCircumstances recorded_circumstances(const RecordedObject& result);
/// "arm_shape": points from the base to the tip, mm; none without joint angles.
std::vector<Eigen::Vector3d> recorded_arm_path(const RecordedObject& result);

}  // namespace artcal
