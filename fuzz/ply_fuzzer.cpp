#include "acquisition/point_cloud/ply_file.h"
#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  artcal::fuzzing::read_cloud(data, size, artcal::parse_ply);
  return 0;
}
