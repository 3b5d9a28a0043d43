#include "app/results/verification/earlier_values.h"

#include <exception>

#include "app/output/json_file.h"
#include "app/results/schema_version.h"
#include "artefacts/verification/decision/specification.h"
#include "core/files/size_limits.h"
#include "core/files/text_file.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

// Throws what the library throws where a field is absent or of another type, and what value() throws of a quantity that
// no verification has.
TestValue value_from(const Json& json) {
  TestValue value;
  value.quantity = quantity_named(json.at("quantity").get<std::string>()).value();
  value.artefact = json.at("artefact").get<std::string>();
  value.placement = json.at("placement").get<std::string>();
  value.first = json.at("first").get<std::string>();
  value.second = json.at("second").is_null() ? "" : json.at("second").get<std::string>();
  value.repeat = json.at("repeat").get<std::string>();
  value.certified = json.at("certified_mm").is_null() ? 0.0 : json.at("certified_mm").get<double>();
  value.value = json.at("value_mm").get<double>();
  value.set_aside = json.at("set_aside").get<bool>();
  const Json& budget = json.at("budget");
  value.budget = {budget.at("calibration_mm"), budget.at("expansion_mm"), budget.at("temperature_mm"),
                  budget.at("alignment_mm"),   budget.at("fixture_mm"),   budget.at("form_mm")};
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
    Json& json = *parsed;
    if (json.at("kind") != "verification" || !bring_up_to_date(json) || json.at("standard") != standard) {
      return bad_input("this is no result of artcal verify by " + standard + " that this version reads", path);
    }
    std::vector<TestValue> values;
    for (const Json& value : json.at("values")) {
      values.push_back(value_from(value));
    }
    return values;
  } catch (const std::exception&) {
    return bad_input("this is no result of artcal verify (--json): it cannot be read as one", path);
  }
}

}  // namespace artcal
