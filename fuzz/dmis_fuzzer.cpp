#include "acquisition/import/dmis_file.h"
#include "fuzz/import_check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  const auto file = read_text_file(fuzzing::folder().write("results.dmo", fuzzing::bytes_of(data, size)));
  if (file) {
    (void)is_dmis_file(*file);
    fuzzing::check_import(import_dmis(*file, false));
    fuzzing::check_import(import_dmis(*file, true));
  }
  return 0;
}
