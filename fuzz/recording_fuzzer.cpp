#include "acquisition/recording/recording_file.h"
#include "fuzz/check.h"

namespace {

// The files that a recording of the corpus names.
void write_companions() {
  (void)artcal::fuzzing::folder().write(
      "arm.toml",
      "schema = \"artcal-arm/1\"\nconvention = \"standard\"\nunits = { length = \"mm\", angle = \"deg\" }\n"
      "[[joint]]\na = 0\nd = 300\ntheta = 0\nalpha = 90\n[[probe]]\nl = 100\n");
  (void)artcal::fuzzing::folder().write("readings.csv", "feature,q1\nA,10\nB,-20\n");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  static const bool written = (write_companions(), true);
  (void)written;
  const auto read = read_recording(fuzzing::folder().write("recording.toml", fuzzing::bytes_of(data, size)));
  if (!read) {
    fuzzing::require_sentence(read.error());
  }
  return 0;
}
