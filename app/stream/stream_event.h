#pragma once

#include <optional>
#include <string_view>

#include <Eigen/Core>

#include "app/stream/stream_format.h"

namespace artcal {

/// One event of an arm, in mm, rad, s, °C.
struct StreamEvent {
  Eigen::VectorXd joints;
  std::optional<Eigen::Vector3d> tip_in_base;  ///< as the arm's own software has it
  std::optional<double> time, temperature;
  bool pressed = true;  ///< a button is, or the stream has none
  bool at_rest = true, referenced = true, off_end_stops = true;
};

/// The longest line that is read, bytes.
inline constexpr std::size_t max_event_bytes = 65536;

/// Reads a line; nothing where it is no event (empty, another prefix). Bad input: a field that is not there, is no
/// number or not finite.
Expected<std::optional<StreamEvent>> parse_event(std::string_view line, const StreamFormat& format);

}  // namespace artcal
