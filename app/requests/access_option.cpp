#include "app/requests/access_option.h"

#include "app/requests/memory_option.h"

namespace artcal {

void AccessOption::add_to(CLI::App& parser) {
  parser.add_flag("--allow-outside", anywhere,
                  "read files that this input names wherever they are, not only in its folder and beside that folder");
}

void RecordingOptions::add_to(CLI::App& parser) {
  AccessOption::add_to(parser);
  add_max_memory(parser, limits);
}

}  // namespace artcal
