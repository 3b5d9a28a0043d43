#include "acquisition/import/pcdmis_report.h"
#include "fuzz/import_check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  const auto file = read_text_file(fuzzing::folder().write("points.txt", fuzzing::bytes_of(data, size)));
  if (!file) {
    fuzzing::require_sentence(file.error());
    return 0;
  }
  for (const char* columns : {"", "name,x,y,z", "q1,q2,-,x,y,z"}) {
    fuzzing::check_import(is_pcdmis_report(*file) ? import_pcdmis_report(*file)
                                                  : import_text(*file, {columns, std::nullopt, 0}));
  }
  return 0;
}
