#include "acquisition/recording.h"

#include <fmt/format.h>

namespace artcal {

std::string Recording::where(int reading) const {
  const Reading& r = readings[static_cast<std::size_t>(reading)];
  return fmt::format("{}:{}", files[static_cast<std::size_t>(r.file)], r.line);
}

}  // namespace artcal
