#include "app/commands/command.h"

#include <fmt/format.h>

#include "app/output/capture.h"
#include "app/output/output.h"

namespace artcal {

void CommonOptions::add_to(CLI::App& parser) {
  parser.add_option("--json", json, "write the result as JSON to this file; - is standard output")->type_name("FILE");
  parser.add_flag("--quiet,-q", quiet, "print nothing but errors");
}

void CommonOptions::say(const std::string& text) const {
  if (Capture* const capture = current_capture()) {
    capture->text = text;
  } else if (talks()) {
    fmt::print("{}", text);
  }
}

Expected<int> CommonOptions::tell(const nlohmann::ordered_json& result, const std::string& text, int exit_code) const {
  return write_json(json, result).map([&] {
    say(text);
    return exit_code;
  });
}

}  // namespace artcal
