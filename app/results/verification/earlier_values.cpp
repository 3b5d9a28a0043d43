#include "app/results/verification/earlier_values.h"

#include <fmt/format.h>

#include "app/output/json_file.h"
#include "app/results/schema_version.h"
#include "app/results/verification/recorded_value.h"
#include "artefacts/verification/decision/specification.h"
#include "core/files/size_limits.h"
#include "core/files/text_file.h"

namespace artcal {
namespace {

// REQUIRES: it has a budget.
TestValue test_value(const RecordedValue& recorded) {
  TestValue value;
  value.quantity = quantity_named(recorded.quantity).value();
  value.artefact = recorded.artefact;
  value.placement = recorded.placement;
  value.first = recorded.first;
  value.second = recorded.second;
  value.repeat = recorded.repeat;
  value.certified = recorded.certified.value_or(0.0);
  value.value = recorded.value;
  value.set_aside = recorded.set_aside;
  value.budget = recorded.budget.value();
  return value;
}

}  // namespace

Expected<std::vector<TestValue>> read_earlier_values(const std::string& path, const std::string& standard,
                                                     std::vector<InputFile>& inputs) {
  const auto file = read_text_file(path, largest::result);
  if (!file) {
    return tl::unexpected(file.error());
  }
  inputs.push_back({path, file->sha256});
  auto parsed = parse_json(file->text, "result of artcal verify (--json)", path);
  if (!parsed) {
    return tl::unexpected(parsed.error());
  }
  try {
    const bool is_known = bring_up_to_date(*parsed);
    const RecordedObject result(*parsed);
    if (result.text("kind") != "verification" || !is_known || result.text("standard") != standard) {
      return bad_input("this is no result of artcal verify by " + standard + " that this version reads", path);
    }
    std::vector<TestValue> values;
    for (const RecordedValue& recorded : recorded_values(result)) {
      if (!recorded.budget) {
        result.refuse("values", "a list with a value without its budget, which an interim check needs");
      }
      values.push_back(test_value(recorded));
    }
    return values;
  } catch (const NotAsInSchema& reason) {
    return bad_input(fmt::format("this is no result of artcal verify (--json): {}", reason.what()), path);
  }
}

}  // namespace artcal
