#include "artefacts/simulation/plan/plan_file.h"
#include "fuzz/check.h"

namespace {

// The files that a plan of the corpus names.
void write_companions() {
  (void)artcal::fuzzing::folder().write(
      "arm.toml",
      "schema = \"artcal-arm/1\"\nconvention = \"standard\"\nunits = { length = \"mm\", angle = \"deg\" }\n"
      "[[joint]]\na = 0\nd = 300\ntheta = 0\nalpha = 90\n[[probe]]\nl = 100\n");
  (void)artcal::fuzzing::folder().write(
      "bar.toml",
      "schema = \"artcal-artefact/1\"\nname = \"bar\"\nunits = { length = \"mm\" }\n[[feature]]\nname = \"A\"\n"
      "kind = \"sphere\"\ndiameter = 25\n[[feature]]\nname = \"B\"\nkind = \"sphere\"\ndiameter = 25\n"
      "[[distance]]\nbetween = [\"A\", \"B\"]\nvalue = 300\nU = 0.001\nk = 2\n");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  static const bool written = (write_companions(), true);
  (void)written;
  const auto read = read_plan_file(fuzzing::folder().write("plan.toml", fuzzing::bytes_of(data, size)));
  if (!read) {
    fuzzing::require_sentence(read.error());
  }
  return 0;
}
