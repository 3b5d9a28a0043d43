#include "app/arm/written_arm.h"

#include <fmt/format.h>

#include "app/output/output.h"

namespace artcal {

Expected<int> give_arm(const std::string& output, bool quiet, const std::string& text, const std::string& said) {
  if (output.empty() || output == "-") {
    if (!quiet) {
      fmt::print(stderr, "{}", said);
    }
    fmt::print("{}", text);
    return 0;
  }
  return write_file(output, text).map([&] {
    if (!quiet) {
      fmt::print("{}The arm is in {}.\n", said, output);
    }
    return 0;
  });
}

}  // namespace artcal
