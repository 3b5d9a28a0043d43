#include "app/phrases.h"

#include <fmt/format.h>

namespace artcal {

std::string plural(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string warning_lines(const std::vector<std::string>& warnings) {
  std::string text;
  for (const std::string& warning : warnings) {
    text += fmt::format("Warning: {}.\n", warning);
  }
  return text;
}

}  // namespace artcal
