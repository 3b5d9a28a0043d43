#include "acquisition/arm/exchange/urdf_read.h"
#include "fuzz/chain_check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  fuzzing::check_chain(read_urdf(fuzzing::folder().write("robot.urdf", fuzzing::bytes_of(data, size)), {}));
  return 0;
}
