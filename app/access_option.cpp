#include "app/access_option.h"

namespace artcal {

void AccessOption::add_to(CLI::App& parser) {
  parser.add_flag("--allow-outside", anywhere,
                  "read files that this input names wherever they are, not only in its folder and beside that folder");
}

}  // namespace artcal
