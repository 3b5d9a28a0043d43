#include "app/arm/round_request.h"

#include "acquisition/arm/arm_file.h"
#include "app/arm/written_arm.h"
#include "app/output/output.h"

namespace artcal {

Expected<int> RoundRequest::run() const {
  if (!rounding.are_given()) {
    return wrong_usage("say how to round: --digits N or --steps length=0.001in,angle=19.8arcsec");
  }
  const auto file = read_arm_file(input);
  if (!file) {
    return tl::unexpected(file.error());
  }
  if (auto checked = check_outputs({output}, {file->input}); !checked) {
    return tl::unexpected(checked.error());
  }
  const auto made = rounding.rounded_arm(file->arm);
  if (!made) {
    return tl::unexpected(made.error());
  }
  // The covariance is that of the parameters before: the rounded arm has none.
  const std::string without = file->identification ? "the rounded arm is written without its covariance\n" : "";
  return give_arm(output, quiet, arm_file_text(made->arm, std::nullopt), made->said + without);
}

CLI::App* RoundRequest::add_to(CLI::App& parser) {
  CLI::App* command = parser.add_subcommand("round", "an arm with rounded numbers, and by how much its tip moves");
  command->add_option("arm", input, "arm.toml")->required()->type_name("ARM");
  rounding.add_to(*command);
  command->add_option("-o,--output", output, "arm.toml to write; printed where it is not given")->type_name("ARM");
  command->add_flag("--quiet,-q", quiet, "print nothing but errors");
  command->footer("Example:\n  artcal arm round arm.toml --steps length=0.001in,angle=19.8arcsec -o rounded.toml");
  return command;
}

}  // namespace artcal
