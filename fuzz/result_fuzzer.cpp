// A result given to artcal report or to artcal verify --against: shown, or refused in a sentence. As a page of a batch,
// whose plots are not in it.
#include "app/report/report.h"
#include "app/results/verification/earlier_values.h"
#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  const std::string path = fuzzing::folder().write("result.json", fuzzing::bytes_of(data, size)).string();
  std::vector<InputFile> inputs;
  if (const auto earlier = read_earlier_values(path, "iso10360-12", inputs); !earlier) {
    fuzzing::require_sentence(earlier.error());
  }
  const auto result = read_result(path, inputs);
  if (!result) {
    fuzzing::require_sentence(result.error());
    return 0;
  }
  // Twice: results of one arm over time.
  const auto page = report_html({*result, *result}, Scripts::SharedPlots);
  if (!page) {
    fuzzing::require_sentence(page.error());
  }
  return 0;
}
