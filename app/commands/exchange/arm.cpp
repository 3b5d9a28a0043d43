#include <memory>

#include "app/arm/arm_exchange.h"
#include "app/arm/reported_request.h"
#include "app/arm/round_request.h"
#include "app/commands/command.h"
#include "app/output/output.h"

namespace artcal {
namespace {

struct Request {
  ArmImport import;
  ArmExport exported;
  RoundRequest round;
  ReportedRequest reported;
};

}  // namespace

Run set_up_arm(CLI::App& parser) {
  auto request = std::make_shared<Request>();
  parser.require_subcommand(1);
  const CLI::App* import = request->import.add_to(parser);
  const CLI::App* exported = request->exported.add_to(parser);
  const CLI::App* round = request->round.add_to(parser);
  request->reported.add_to(parser);
  parser.footer(
      "Examples:\n  artcal arm import robot.urdf --tip tool0 -o arm.toml\n  artcal arm export arm.toml --urdf -o "
      "arm.urdf\n  artcal arm round arm.toml --steps length=0.001in,angle=19.8arcsec -o rounded.toml\n"
      "  artcal arm from-coordinates recording.toml -o arm.toml");
  return [request, import, exported, round] {
    const auto done = import->parsed()     ? request->import.run()
                      : exported->parsed() ? request->exported.run()
                      : round->parsed()    ? request->round.run()
                                           : request->reported.run();
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
