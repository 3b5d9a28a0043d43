#include "app/stream/source/terminal_keys.h"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace artcal {

struct TerminalKeys::Settings {
  termios values;
};

TerminalKeys::TerminalKeys() {
  auto before = std::make_unique<Settings>();
  if (::isatty(STDIN_FILENO) == 0 || ::tcgetattr(STDIN_FILENO, &before->values) != 0) {
    return;
  }
  termios by_key = before->values;
  by_key.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);  // Ctrl-C still interrupts
  if (::tcsetattr(STDIN_FILENO, TCSANOW, &by_key) == 0) {
    before_ = std::move(before);
  }
}

TerminalKeys::~TerminalKeys() {
  if (before_) {
    ::tcsetattr(STDIN_FILENO, TCSANOW, &before_->values);
  }
}

std::optional<char> TerminalKeys::next() {
  pollfd ready{STDIN_FILENO, POLLIN, 0};
  char key = 0;
  if (!before_ || ::poll(&ready, 1, 0) <= 0 || ::read(STDIN_FILENO, &key, 1) != 1) {
    return std::nullopt;
  }
  return key;
}

}  // namespace artcal
