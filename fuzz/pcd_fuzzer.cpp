#include "acquisition/point_cloud/pcd/pcd_file.h"
#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  fuzzing::read_cloud(data, size,
                      [](const FileBytes& file, const CloudUnits& units) { return parse_pcd(file, units); });
  return 0;
}
