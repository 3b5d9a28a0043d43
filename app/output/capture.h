#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "core/error.h"

namespace artcal {

/// What a command gives to a program that calls it, in place of what it prints to a person.
struct Capture {
  std::optional<Error> error;  ///< why it ended, where it did not succeed
  std::string json;            ///< what `--json -` would print
  std::string text;            ///< what a person would read
  /// Told what long work is doing, by one thread at a time; may throw to end the work. Empty: nobody listens.
  std::function<void(const std::string& what, std::size_t done, std::size_t total)> progress;
};

/// That of the command which this thread runs; null in the program itself.
Capture* current_capture();

/// While it lives, what this thread's command says goes to `capture`.
class CaptureScope {
 public:
  explicit CaptureScope(Capture& capture);
  ~CaptureScope();
  CaptureScope(const CaptureScope&) = delete;
  CaptureScope& operator=(const CaptureScope&) = delete;

 private:
  Capture* before_;
};

}  // namespace artcal
