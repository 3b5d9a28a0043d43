#include "app/results/uncertainty/monte_carlo_state.h"
#include "fuzz/check.h"

// A Monte Carlo's state that is read can be added to itself, asked, and written as what it was.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  const nlohmann::ordered_json made_from = {{"recording", "r"}};
  const auto read =
      read_state(fuzzing::folder().write("state.json", fuzzing::bytes_of(data, size)).string(), made_from);
  if (!read) {
    fuzzing::require_sentence(read.error());
    return 0;
  }
  for (const Distribution& distribution : read->distributions) {
    if (distribution.count() < 2) {
      continue;
    }
    Distribution both = distribution;
    both.add(distribution);
    (void)both.quantile(0.025);
    (void)both.shortest(0.95);
    (void)both.error_of_deviation();
  }
  const std::string text = state_text(*read, made_from);
  const auto again = read_state(fuzzing::folder().write("again.json", text).string(), made_from);
  fuzzing::require(again && state_text(*again, made_from) == text);
  return 0;
}
