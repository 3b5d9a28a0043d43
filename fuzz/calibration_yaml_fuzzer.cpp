#include "acquisition/arm/exchange/calibration_yaml.h"
#include "fuzz/chain_check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  fuzzing::check_chain(
      read_calibration_yaml(fuzzing::folder().write("calibration.yaml", fuzzing::bytes_of(data, size))));
  return 0;
}
