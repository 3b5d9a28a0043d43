#include "app/report/result_file.h"

#include <optional>

#include <fmt/format.h>

#include "app/json_file.h"
#include "core/in_quotes.h"
#include "core/size_limits.h"
#include "core/text_file.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

std::optional<ResultKind> kind_named(const std::string& name) {
  if (name == "identification") {
    return ResultKind::Identification;
  }
  if (name == "verification") {
    return ResultKind::Verification;
  }
  if (name == "monte-carlo") {
    return ResultKind::MonteCarlo;
  }
  return name == "uncertainty" ? std::optional(ResultKind::Uncertainty) : std::nullopt;
}

}  // namespace

ReportedResult reported(Json json) {
  const auto kind = kind_named(json.at("kind").get<std::string>());
  return {kind.value(), std::move(json), {}};
}

Expected<ReportedResult> read_result(const std::string& path, std::vector<InputFile>& inputs) {
  const auto file = read_text_file(path, largest::result);
  if (!file) {
    return tl::unexpected(file.error());
  }
  auto parsed = parse_json(file->text, "result of artcal, as --json writes it", path);
  if (!parsed) {
    return tl::unexpected(parsed.error());
  }
  Json& json = *parsed;
  if (!json.is_object() || !json.contains("kind") || !json["kind"].is_string() || !json.contains("schema_version")) {
    return bad_input("this is no result of artcal, expected a file that --json wrote", path);
  }
  const auto kind = kind_named(json["kind"].get<std::string>());
  if (!kind) {
    return bad_input(
        fmt::format(
            "this is a result of kind {}, expected one of identify, verify or uncertainty, also with --monte-carlo",
            in_quotes(json["kind"].get<std::string>())),
        path);
  }
  if (json["schema_version"] != 1) {
    return bad_input("this result has a schema_version that this version of artcal does not read, expected 1", path);
  }
  inputs.push_back({path, file->sha256});
  return ReportedResult{*kind, std::move(json), path};
}

}  // namespace artcal
