#include "acquisition/recording/recording.h"

#include <fmt/format.h>

namespace artcal {

std::string Recording::where(int reading) const {
  const Reading& r = readings[reading];
  return fmt::format("{}:{}", files[r.file], r.line);
}

}  // namespace artcal
