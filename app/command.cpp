#include "app/command.h"

namespace artcal {

void CommonOptions::add_to(CLI::App& parser) {
  parser.add_option("--json", json, "write the result as JSON to this file; - is standard output")->type_name("FILE");
  parser.add_flag("--quiet,-q", quiet, "print nothing but errors");
}

}  // namespace artcal
