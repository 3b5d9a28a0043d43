#pragma once

#include <memory>
#include <string>

#include "core/error.h"

namespace artcal {

/// Where lines come from.
class LineSource {
 public:
  enum class Kind {
    Line,     ///< a line is there
    TooLong,  ///< a line was longer than max_event_bytes; it was read past and not kept
    CutOff,   ///< the last line, which has no line end
    Nothing,  ///< none within the time that was waited
    End       ///< there will be no more
  };

  virtual ~LineSource() = default;
  /// Waits for the next line, at most so long; less where a signal arrives.
  virtual Kind next(std::string& line, int wait_ms) = 0;
  /// Whether lines come as they are made, so that the time of their arrival says something.
  [[nodiscard]] virtual bool is_live() const = 0;
};

/// "-" standard input; tcp://HOST:PORT a connection; listen://PORT one connection on the loopback address, which
/// next() waits for; serial://DEVICE?baud=115200 a serial port; else the path of a file, which is followed as it grows
/// where `follow` is.
/// Usage: an address that is none. Bad input: it cannot be opened.
Expected<std::unique_ptr<LineSource>> open_source(const std::string& address, bool follow);

}  // namespace artcal
