#include <memory>

#include "app/commands/command.h"
#include "app/import/import_request.h"
#include "app/output/output.h"

namespace artcal {

Run set_up_import(CLI::App& parser) {
  auto request = std::make_shared<ImportRequest>();
  request->add_to(parser);
  return [request] {
    const auto done = request->run();
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
