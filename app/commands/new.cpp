#include <memory>

#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/templates/new_request.h"

namespace artcal {

Run set_up_new(CLI::App& parser) {
  auto request = std::make_shared<NewRequest>();
  request->add_to(parser);
  return [request] {
    const auto done = request->run();
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
