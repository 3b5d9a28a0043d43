#include <memory>

#include "app/arm/arm_exchange.h"
#include "app/arm/reported_request.h"
#include "app/arm/round_request.h"
#include "app/commands/command.h"
#include "app/output/output.h"

namespace artcal {
namespace {

struct ArmArguments {
  ArmImport import;
  ArmExport exported;
  RoundRequest round;
  ReportedRequest reported;
};

}  // namespace

Run set_up_arm(CLI::App& parser) {
  auto arguments = std::make_shared<ArmArguments>();
  parser.require_subcommand(1);
  const CLI::App* import = arguments->import.add_to(parser);
  const CLI::App* exported = arguments->exported.add_to(parser);
  const CLI::App* round = arguments->round.add_to(parser);
  arguments->reported.add_to(parser);
  parser.footer(
      "Examples:\n  artcal arm import robot.urdf --tip tool0 -o arm.toml\n  artcal arm export arm.toml --urdf -o "
      "arm.urdf\n  artcal arm round arm.toml --steps length=0.001in,angle=19.8arcsec -o rounded.toml\n"
      "  artcal arm from-coordinates recording.toml -o arm.toml");
  return [arguments, import, exported, round] {
    const auto done = import->parsed()     ? arguments->import.run()
                      : exported->parsed() ? arguments->exported.run()
                      : round->parsed()    ? arguments->round.run()
                                           : arguments->reported.run();
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
