#include "app/arm/reported_request.h"

#include "acquisition/arm/arm_file.h"
#include "app/arm/reported_text.h"
#include "app/output/output.h"
#include "app/results/identification/identified_arm.h"
#include "identification/reported_coordinates/reported_model.h"

namespace artcal {
namespace {

// A rounded arm is no longer the one that the covariance belongs to.
std::string text_of_arm(const ReportedModel& model, const IdentifyOptions& options, const RoundedArm& written,
                        bool is_rounded) {
  return arm_file_text(
      written.arm,
      is_rounded ? std::nullopt : std::optional(arm_identification(model.recording, options, model.identification)));
}

}  // namespace

Expected<int> ReportedRequest::run() const {
  const auto read = recording.read();
  if (!read) {
    return tl::unexpected(read.error());
  }
  const auto identify_options = choices.options(*read);
  if (!identify_options) {
    return tl::unexpected(identify_options.error());
  }
  if (auto checked = recording.check_outputs({output, common.json}, *read); !checked) {
    return tl::unexpected(checked.error());
  }
  const auto model = identify_reported_model(*read, {frame == "base", *identify_options});
  if (!model) {
    return tl::unexpected(model.error());
  }
  const auto written = rounding.rounded_arm(model->identification.arm);
  if (!written) {
    return tl::unexpected(written.error());
  }
  if (!output.empty()) {
    const std::string text = text_of_arm(*model, *identify_options, *written, rounding.are_given());
    if (auto done = write_file(output, text); !done) {
      return tl::unexpected(done.error());
    }
  }
  return common.tell(reported_json(*model), reported_text(*model, output) + written->said);
}

CLI::App* ReportedRequest::add_to(CLI::App& parser) {
  CLI::App* command = parser.add_subcommand(
      "from-coordinates", "the maker's own model, from joint angles and the coordinates that his software reported");
  command->add_option("recording", recording.path, "recording.toml: readings with q1 … qn and x, y, z")
      ->required()
      ->type_name("RECORDING");
  command->add_option("-o,--output", output, "arm.toml to write")->type_name("ARM");
  command->add_option("--frame", frame, "of the coordinates: base, the arm's base frame, or unknown")
      ->check(CLI::IsMember({"base", "unknown"}));
  rounding.add_to(*command);
  choices.add_to(*command, "Options");
  recording.options.add_to(*command);
  common.add_to(*command);
  command->footer("Example:\n  artcal arm from-coordinates recording.toml -o arm.toml");
  return command;
}

}  // namespace artcal
