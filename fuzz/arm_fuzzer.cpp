#include "acquisition/arm/arm_file.h"
#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  const auto path = fuzzing::folder().write("arm.toml", fuzzing::bytes_of(data, size));
  const auto read = read_arm_file(path);
  if (!read) {
    fuzzing::require_sentence(read.error());
    return 0;
  }
  // What is written is read again as the same arm.
  const std::string text = arm_file_text(read->arm, read->identification);
  const auto again = read_arm_file(fuzzing::folder().write("again.toml", text));
  fuzzing::require(again.has_value() && arm_file_text(again->arm, again->identification) == text);
  return 0;
}
