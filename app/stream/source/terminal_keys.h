#pragma once

#include <memory>
#include <optional>

namespace artcal {

/// Keys that a person presses on the terminal that is standard input, each at once and without an echo, as long as this
/// lives. No keys where standard input is no terminal.
class TerminalKeys {
 public:
  TerminalKeys();
  TerminalKeys(const TerminalKeys&) = delete;
  TerminalKeys& operator=(const TerminalKeys&) = delete;
  ~TerminalKeys();

  [[nodiscard]] bool are_there() const { return before_ != nullptr; }
  /// A key that was pressed; does not wait.
  std::optional<char> next();

 private:
  struct Settings;
  std::unique_ptr<Settings> before_;
};

}  // namespace artcal
