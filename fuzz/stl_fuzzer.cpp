#include "acquisition/point_cloud/mesh/stl_file.h"
#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  fuzzing::read_cloud(
      data, size,
      [](const FileBytes& file, const CloudUnits& units) {
        return parse_stl(file, units).map([](ReadCloud&& read) { return std::move(read.cloud); });
      },
      fuzzing::Repeated::Merged);
  return 0;
}
