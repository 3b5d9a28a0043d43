#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "acquisition/arm/arm.h"
#include "core/error.h"

namespace artcal {

/// Which field of an event says something, by name (JSON, dots lead into objects) or by column from 1 after the prefix.
using StreamField = std::string;

/// A field that must have a value for an event to count, or must not have it.
struct StreamCondition {
  StreamField field;
  double value = 0.0;
};

/// How the lines of a stream of events are read: stream.toml.
struct StreamFormat {
  bool is_json = false;
  std::string prefix;  ///< of lines that are events, of columns; others are passed over
  char delimiter = ',';
  std::vector<StreamField> joints;
  std::vector<double> joint_scale;  ///< rad (prismatic: mm) per unit of each field; of counts 2π/counts per turn
  bool has_counts = false;
  std::vector<StreamField> xyz;  ///< of the tip by the arm's own software, or none
  double length_scale = 1.0;     ///< mm per unit
  StreamField button;            ///< a reading is taken when it becomes other than 0; empty: every event is one
  StreamField time;              ///< or empty
  double time_scale = 1.0;       ///< s per unit
  StreamField temperature;       ///< of the arm, °C; or empty
  std::optional<StreamCondition> at_rest;     ///< holds at rest
  std::optional<StreamCondition> referenced;  ///< holds when all encoders are referenced
  std::optional<StreamCondition> end_stop;    ///< holds while no joint is at an end stop
  /// Where positive: an event is at rest where no joint moved by more, rad, for a fifth of a second; and it is the last
  /// reading again where no joint is farther from it.
  double at_rest_within = 0.0;
  double max_rate = 20.0;  ///< readings a second; events that come sooner are passed over
};

/// Reads stream.toml. Format: docs/recording.md.
Expected<StreamFormat> read_stream_format(const std::filesystem::path& path);

/// The same for this arm: prismatic joints in the unit of lengths. Refused: another number of joints, counts of a
/// prismatic joint. `path` is the file's, for the message.
Expected<StreamFormat> for_arm(StreamFormat format, const Arm& arm, const std::filesystem::path& path);

}  // namespace artcal
