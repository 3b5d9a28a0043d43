#include "app/commands/identify.h"

#include <unistd.h>

#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "acquisition/arm/arm_file.h"
#include "app/arm/rounding_options.h"
#include "app/output/output.h"
#include "app/output/stopwatch.h"
#include "app/requests/dcc_request.h"
#include "app/requests/identify_request.h"
#include "app/requests/recording_request.h"
#include "app/results/identification/dcc_identification.h"
#include "app/results/identification/identification_report.h"
#include "app/results/identification/identified_arm.h"
#include "app/results/identification/identify_progress.h"
#include "app/results/identification/readings_json.h"
#include "app/results/identification/result_json.h"
#include "app/results/identification/result_text.h"
#include "app/results/inspection/inspected_run.h"
#include "app/results/inspection/inspection_json.h"
#include "artefacts/dcc/writing/dcc_write.h"
#include "identification/identify.h"

namespace artcal {
namespace {

struct IdentifyArguments {
  CommonOptions common;
  RecordingRequest recording;
  std::string arm_out;
  RoundingOptions rounding;
  DccRequest dcc;
  std::string report;
  IdentifyChoices choices;
  bool no_leave_out = false;
  bool no_residuals = false;
  int threads = 0;
};

Expected<IdentifyOptions> identify_options_of(const IdentifyArguments& arguments, const Recording& recording) {
  return arguments.choices.options(recording).map([&](IdentifyOptions options) {
    options.leave_out = !arguments.no_leave_out;
    options.threads = arguments.threads;
    return options;
  });
}

InspectedIdentification identify_with_progress(const Recording& recording, const Constraints& constraints,
                                               IdentifyOptions options, bool quiet) {
  IdentifyProgress progress(stderr, !quiet && ::isatty(STDERR_FILENO) == 1);
  options.progress = [&](const std::string& what, std::size_t done, std::size_t total) {
    progress.set(what, done, total);
  };
  return inspect_result(identify(recording, constraints, options), recording, constraints, options);
}

// Writes the arm where it is asked for, rounded where that is; what a person is told of it. The covariance is that of
// the parameters before: a rounded arm has none.
Expected<std::string> write_arm(const IdentifyArguments& arguments, const Recording& recording,
                                const IdentifyOptions& options, const Identification& result) {
  if (arguments.arm_out.empty()) {
    return "The identified arm was not written; add -o ARM.toml to keep it.";
  }
  const auto made = arguments.rounding.rounded_arm(result.arm);
  if (!made) {
    return tl::unexpected(made.error());
  }
  const bool is_rounded = arguments.rounding.are_given();
  const std::string text = arm_file_text(
      made->arm, is_rounded ? std::nullopt : std::optional(arm_identification(recording, options, result)));
  return write_file(arguments.arm_out, text).map([&] {
    return fmt::format("{}The {} arm is in {}{}.", made->said, is_rounded ? "rounded" : "identified", arguments.arm_out,
                       is_rounded ? ", without its covariance" : "");
  });
}

// Before the arm is identified, which may take long.
Expected<void> check_rounding(const IdentifyArguments& arguments) {
  if (arguments.rounding.are_given() && arguments.arm_out.empty()) {
    return wrong_usage("--digits and --steps round the arm that is written; add -o ARM.toml");
  }
  return arguments.rounding.check();
}

Expected<int> identify_and_tell(const IdentifyArguments& arguments) {
  if (auto checked = check_rounding(arguments); !checked) {
    return tl::unexpected(checked.error());
  }
  const Stopwatch watch;
  auto bound = arguments.recording.read_bound();
  if (!bound) {
    return tl::unexpected(bound.error());
  }
  auto& [recording, constraints] = *bound;
  auto options = identify_options_of(arguments, recording);
  if (!options) {
    return tl::unexpected(options.error());
  }
  const auto certificate = read_certificate_data(arguments.dcc, recording);
  if (!certificate) {
    return tl::unexpected(certificate.error());
  }
  if (auto checked = arguments.recording.check_outputs(
          {arguments.arm_out, arguments.common.json, arguments.dcc.out, arguments.report}, recording);
      !checked) {
    return tl::unexpected(checked.error());
  }
  const double reading_seconds = watch.seconds();
  const auto run = identify_with_progress(recording, constraints, *options, arguments.common.quiet);
  const auto& result = run.result;
  if (!result) {
    return tl::unexpected(result.error());
  }
  const Timings timings{reading_seconds, watch.seconds() - reading_seconds};
  const auto said_of_arm = write_arm(arguments, recording, *options, *result);
  if (!said_of_arm) {
    return tl::unexpected(said_of_arm.error());
  }
  if (*certificate) {
    const DccDocument document = dcc_of(recording, constraints, *result, **certificate);
    if (auto written = write_file(arguments.dcc.out, dcc_xml(document)); !written) {
      return tl::unexpected(written.error());
    }
  }
  if (!arguments.common.json.empty() || !arguments.report.empty()) {
    auto json = to_json(recording, constraints, *options, *result, timings);
    json["findings"] = findings_json(run.findings);
    json["residuals"] = residuals_json(recording, constraints, *result);
    if (auto written = write_identification_report(arguments.report, json, recording, *options, *result); !written) {
      return tl::unexpected(written.error());
    }
    if (arguments.no_residuals) {
      json.erase("residuals");
    }
    if (auto written = write_json(arguments.common.json, json); !written) {
      return tl::unexpected(written.error());
    }
  }
  arguments.common.say(fmt::format("{}{}\n", to_text(recording, constraints, *result), *said_of_arm));
  return 0;
}

}  // namespace

Expected<int> identify_recording(const std::string& recording, const std::string& arm, const std::string& json,
                                 bool quiet) {
  IdentifyArguments arguments;
  arguments.recording.path = recording;
  arguments.arm_out = arm;
  arguments.common.json = json;
  arguments.common.quiet = quiet;
  return identify_and_tell(arguments);
}

Run set_up_identify(CLI::App& parser) {
  auto arguments = std::make_shared<IdentifyArguments>();
  arguments->recording.add_path_to(parser);
  parser.add_option("-o,--output", arguments->arm_out, "write the identified arm, with its covariance")
      ->type_name("ARM");
  arguments->rounding.add_to(parser);
  parser.add_option("--report", arguments->report, "write a report (HTML, prints on A4)")->type_name("FILE.html");
  arguments->dcc.add_to(parser);
  arguments->choices.add_to(parser, "Options");
  arguments->choices.add_noise_of_parts_to(parser);
  parser.add_flag("--no-leave-out", arguments->no_leave_out, "do not identify again without each placement");
  parser.add_flag("--no-residuals", arguments->no_residuals, "leave the readings out of the JSON: it is much smaller");
  parser.add_option("--threads", arguments->threads, "threads for leaving out; 0 takes all, the result is the same")
      ->check(CLI::NonNegativeNumber);
  arguments->recording.options.add_to(parser);
  arguments->common.add_to(parser);
  parser.footer("Example:\n  artcal identify examples/two-socket-bar/recording.toml -o panda.toml --json result.json");
  return [arguments] {
    const auto done = identify_and_tell(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
