#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "acquisition/arm/arm_file.h"
#include "acquisition/recording/reading_fingerprint.h"
#include "acquisition/recording/tip_centres.h"
#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/requests/recording_request.h"
#include "app/results/evaluation/evaluation_json.h"
#include "app/results/evaluation/evaluation_text.h"
#include "app/results/identification/result_json.h"
#include "artefacts/constraints/document_warnings.h"
#include "core/text/in_quotes.h"
#include "identification/evaluation/evaluation.h"

namespace artcal {
namespace {

struct EvaluateArguments {
  CommonOptions common;
  RecordingRequest recording;
  std::string arm;
};

// Readings that the arm was identified from say little of others: it was made to agree with them.
void warn_of_same_readings(Recording& recording, const ArmIdentification& identification) {
  const int known = count_known(recording, identification.readings);
  if (known > 0) {
    recording.warnings.push_back(
        fmt::format("the arm {} was identified from {} of these {} readings; they deviate less than new ones will",
                    in_quotes(recording.arm.name), known, recording.readings.size()));
  }
}

// Refused: an arm that the readings cannot be evaluated with, such as one that expands where no temperature was read.
Expected<void> check_fits(const Recording& recording, const Arm& arm, const std::optional<ArmIdentification>& known) {
  return tip_centres(recording, arm, known ? &*known : nullptr).map([](const TipCentres&) {});
}

// The arm of the file, where one is named, in place of the recording's, with the same probes by name.
Expected<Recording> with_arm(const std::string& path, Recording recording) {
  if (path.empty()) {
    if (auto fits = check_fits(recording, recording.arm, recording.arm_identification); !fits) {
      return tl::unexpected(with_warnings(fits.error(), recording.warnings));
    }
    return recording;
  }
  auto file = read_arm_file(path);
  if (!file) {
    return tl::unexpected(with_warnings(file.error(), recording.warnings));
  }
  if (auto fits = check_fits(recording, file->arm, file->identification); !fits) {
    return tl::unexpected(with_warnings(fits.error(), recording.warnings));
  }
  for (Reading& reading : recording.readings) {
    reading.probe = probe_index(file->arm, recording.arm.probes[static_cast<std::size_t>(reading.probe)].name);
  }
  recording.inputs.push_back(file->input);
  recording.arm = std::move(file->arm);
  recording.arm_identification = std::move(file->identification);
  return recording;
}

Expected<int> evaluate_and_tell(const EvaluateArguments& arguments) {
  auto bound = arguments.recording.read()
                   .and_then([&](Recording&& recording) { return with_arm(arguments.arm, std::move(recording)); })
                   .and_then([&](Recording&& recording) { return arguments.recording.bind(std::move(recording)); });
  if (!bound) {
    return tl::unexpected(bound.error());
  }
  auto& [recording, constraints] = *bound;
  if (auto checked = arguments.recording.check_outputs({arguments.common.json}, recording); !checked) {
    return tl::unexpected(checked.error());
  }
  const auto of_documents = texts_of(document_warnings(recording, constraints.artefacts));
  recording.warnings.insert(recording.warnings.end(), constraints.warnings.begin(), constraints.warnings.end());
  recording.warnings.insert(recording.warnings.end(), of_documents.begin(), of_documents.end());
  if (recording.arm_identification) {
    warn_of_same_readings(recording, *recording.arm_identification);
  }
  const auto evaluation = evaluate(recording, constraints, recording.arm);
  if (!evaluation) {
    return tl::unexpected(with_warnings(evaluation.error(), recording.warnings));
  }
  return arguments.common.tell(to_json(recording, constraints, *evaluation),
                               to_text(recording, constraints, *evaluation, recording.warnings));
}

}  // namespace

Run set_up_evaluate(CLI::App& parser) {
  auto arguments = std::make_shared<EvaluateArguments>();
  arguments->recording.add_path_to(parser);
  parser.add_option("--arm", arguments->arm, "the arm to evaluate, such as an identified one; else the recording's")
      ->type_name("ARM");
  arguments->recording.options.add_to(parser);
  arguments->common.add_to(parser);
  parser.footer(
      "The arm is not changed. Where it was not identified from these readings, new ones are expected to deviate as "
      "much.\n"
      "Example:\n  artcal evaluate examples/ball-bar/recording.toml --arm examples/ball-bar/arm.toml");
  return [arguments] {
    const auto done = evaluate_and_tell(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
