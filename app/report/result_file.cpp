#include "app/report/result_file.h"

#include <optional>

#include <fmt/format.h>

#include "app/results/result_reader.h"
#include "core/text/in_quotes.h"

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
  auto result = read_result_json(path);
  if (!result) {
    return tl::unexpected(result.error());
  }
  Json& json = result->json;
  const auto kind = kind_named(json["kind"].get<std::string>());
  if (!kind) {
    return bad_input(
        fmt::format(
            "this is a result of kind {}, expected one of identify, verify or uncertainty, also with --monte-carlo",
            in_quotes(json["kind"].get<std::string>())),
        path);
  }
  inputs.push_back({path, result->sha256});
  return ReportedResult{*kind, std::move(json), path};
}

}  // namespace artcal
