// A result given to artcal report or to artcal verify --against: shown, or refused in a sentence. The page around the
// report, which holds nothing of the result but its markup and its figures, is left out.
#include "app/report/page.h"
#include "app/report/report.h"
#include "app/results/verification/earlier_values.h"
#include "fuzz/check.h"

std::string artcal::page_html(const Page& page) {
  return page.title + page.body + page.data.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace);
}

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
  const auto page = report_html({*result, *result});
  if (!page) {
    fuzzing::require_sentence(page.error());
  }
  return 0;
}
