#include "app/results/result_reader.h"

#include <fmt/format.h>

#include "app/output/json_file.h"
#include "app/results/schema_version.h"
#include "core/files/size_limits.h"
#include "core/files/text_file.h"

namespace artcal {

Expected<ResultJson> read_result_json(const std::string& path) {
  const auto file = read_text_file(path, largest::result);
  if (!file) {
    return tl::unexpected(file.error());
  }
  auto json = parse_json(file->text, "result of artcal, as --json writes it", path);
  if (!json) {
    return tl::unexpected(json.error());
  }
  if (!json->is_object() || !json->contains("kind") || !(*json)["kind"].is_string() ||
      !json->contains("schema_version")) {
    return bad_input("this is no result of artcal, expected a file that --json wrote", path);
  }
  if (!bring_up_to_date(*json)) {
    return bad_input(fmt::format("this result has a schema_version that this version of artcal does not read, expected "
                                 "1 or {}",
                                 schema_version),
                     path);
  }
  return ResultJson{std::move(*json), file->sha256};
}

}  // namespace artcal
