#include "acquisition/point_cloud/ptx_file.h"
#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  artcal::fuzzing::read_cloud(data, size, [](const artcal::FileBytes& file, const artcal::CloudUnits& units) {
    return artcal::parse_ptx(file, units).map([](artcal::ReadCloud&& read) { return std::move(read.cloud); });
  });
  return 0;
}
