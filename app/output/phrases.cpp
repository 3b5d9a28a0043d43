#include "app/output/phrases.h"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

namespace artcal {

std::string plural(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string text_of_exception(const std::exception& error) {
  const std::string what = error.what();
  // std::thread throws a system_error, TBB an exception of its own; both say what the C library says.
  if (what.find(std::strerror(EAGAIN)) != std::string::npos) {
    return "the system gives this program no more threads; ask for fewer with --threads 1 or --jobs 1, or raise the "
           "limit of processes (ulimit -u)";
  }
  return "internal error: " + what;
}

std::string as_sentence(const std::string& text) {
  const bool ends = text.ends_with('?') || text.ends_with('.') || text.ends_with('!');
  return ends ? text : text + ".";
}

std::string warning_lines(const std::vector<std::string>& warnings) {
  std::string text;
  for (const std::string& warning : warnings) {
    text += fmt::format("Warning: {}\n", as_sentence(warning));
  }
  return text;
}

}  // namespace artcal
