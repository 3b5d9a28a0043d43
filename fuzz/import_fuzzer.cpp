#include "acquisition/import/imported_readings.h"
#include "acquisition/import/pcdmis_report.h"
#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  const auto file = read_text_file(fuzzing::folder().write("points.txt", fuzzing::bytes_of(data, size)));
  if (!file) {
    fuzzing::require_sentence(file.error());
    return 0;
  }
  for (const char* columns : {"", "name,x,y,z", "q1,q2,-,x,y,z"}) {
    const auto readings =
        is_pcdmis_report(*file) ? import_pcdmis_report(*file) : import_text(*file, {columns, std::nullopt, 0});
    if (!readings) {
      fuzzing::require_sentence(readings.error());
      continue;
    }
    for (const auto& row : readings->rows) {
      fuzzing::require(row.size() == readings->columns.size());
    }
    fuzzing::require(!readings_csv(*readings).empty());
  }
  return 0;
}
