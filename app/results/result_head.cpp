#include "app/results/result_head.h"

#include "app/results/schema_version.h"
#include "app/version.h"

namespace artcal {

nlohmann::ordered_json result_head(const char* kind) {
  nlohmann::ordered_json json;
  json["schema_version"] = schema_version;
  json["kind"] = kind;
  json["program"] = {{"name", "artcal"}, {"version", program_version}};
  return json;
}

nlohmann::ordered_json inputs_json(const std::vector<InputFile>& inputs) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const InputFile& input : inputs) {
    json.push_back({{"path", input.path}, {"sha256", input.sha256}});
  }
  return json;
}

}  // namespace artcal
