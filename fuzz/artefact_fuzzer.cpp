#include "artefacts/artefact/artefact_file.h"

#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  const auto read = read_artefact_file(fuzzing::folder().write("artefact.toml", fuzzing::bytes_of(data, size)));
  if (!read) {
    fuzzing::require_sentence(read.error());
  }
  return 0;
}
