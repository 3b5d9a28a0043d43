#include "app/stream/recorder.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>

namespace artcal {
namespace {

constexpr int wait_ms = 50;

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

Expected<void> Recorder::run(LineSource& source, const std::atomic<bool>& stop) {
  std::string line;
  while (!stop.load() && !is_ended_ && !session_.labels().has_ended()) {
    for (auto key = person_.next_key ? person_.next_key() : std::nullopt; key; key = person_.next_key()) {
      if (auto done = press(*key); !done) {
        return done;
      }
    }
    const LineSource::Kind kind = source.next(line, wait_ms);
    if (kind == LineSource::Kind::End) {
      break;
    }
    if (auto done = take(step(kind, line, source.is_live())); !done) {
      return done;
    }
  }
  return {};
}

RecordingSession::Step Recorder::step(LineSource::Kind kind, const std::string& line, bool is_live) {
  switch (kind) {
    case LineSource::Kind::Line: return session_.feed(line, is_live ? std::optional(now()) : std::nullopt);
    case LineSource::Kind::CutOff: return session_.cut_off(line);
    case LineSource::Kind::TooLong: return session_.too_long();
    case LineSource::Kind::Nothing:
    case LineSource::Kind::End: break;
  }
  return {};
}

Expected<void> Recorder::press(char key) {
  for (const auto& [known, words] : {std::pair('n', "next feature"), {'p', "next placement"}, {'u', "undo"}}) {
    if (key == known) {
      return take(session_.operate(words));
    }
  }
  is_ended_ = is_ended_ || key == 'q';
  return {};
}

Expected<void> Recorder::take(const RecordingSession::Step& step) {
  if (step.removes_last) {
    if (auto removed = table_.remove_last(); !removed) {
      return removed;
    }
  }
  if (!step.row.empty()) {
    if (auto written = table_.append(step.row); !written) {
      return written;
    }
    person_.tell_reading(fmt::format("{} {}{}{}", table_.rows(), step.label, step.note.empty() ? "" : "  ", step.note));
  }
  if (!step.message.empty()) {
    person_.tell(step.message);
  }
  return {};
}

}  // namespace artcal
