#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>

#include "app/stream/recording_session.h"
#include "app/stream/row_file.h"
#include "app/stream/source/line_source.h"

namespace artcal {

/// What the keys of Recorder::run() do.
inline constexpr const char* recorder_keys = "n next feature, p next placement, u undo the last reading, q end";

/// Joins a source of events, the session that makes readings of them, and the table that these are appended to: a
/// reading is told only after it is on disk. Knows no terminal: keys and messages come and go by functions.
class Recorder {
 public:
  struct Person {
    std::function<void(const std::string&)> tell_reading;  ///< "12 bar 1 A  u of a length 34 µm"
    std::function<void(const std::string&)> tell;          ///< a message
    std::function<std::optional<char>()> next_key = {};    ///< does not wait; empty: there are no keys
  };

  Recorder(RecordingSession& session, RowFile& table, Person person)
      : session_(session), table_(table), person_(std::move(person)) {}

  /// Until the source or the plan ends, `stop` is set, or q is pressed.
  Expected<void> run(LineSource& source, const std::atomic<bool>& stop);

 private:
  RecordingSession::Step step(LineSource::Kind kind, const std::string& line, bool is_live);
  Expected<void> press(char key);
  Expected<void> take(const RecordingSession::Step& step);

  RecordingSession& session_;
  RowFile& table_;
  Person person_;
  bool is_ended_ = false;
};

}  // namespace artcal
