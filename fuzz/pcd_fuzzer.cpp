#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  artcal::fuzzing::read_cloud(data, size, artcal::parse_pcd);
  return 0;
}
