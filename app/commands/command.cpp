#include "app/commands/command.h"

#include <fmt/format.h>

#include "app/output/output.h"

namespace artcal {

void CommonOptions::add_to(CLI::App& parser) {
  parser.add_option("--json", json, "write the result as JSON to this file; - is standard output")->type_name("FILE");
  parser.add_flag("--quiet,-q", quiet, "print nothing but errors");
}

Expected<int> CommonOptions::tell(const nlohmann::ordered_json& result, const std::string& text, int exit_code) const {
  return write_json(json, result).map([&] {
    if (talks()) {
      fmt::print("{}", text);
    }
    return exit_code;
  });
}

}  // namespace artcal
