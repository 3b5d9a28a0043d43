#include <chrono>
#include <memory>

#include <fmt/format.h>

#include "acquisition/arm_file.h"
#include "acquisition/recording_file.h"
#include "app/command.h"
#include "app/dcc_identification.h"
#include "app/dcc_request.h"
#include "app/identification_report.h"
#include "app/identification_run.h"
#include "app/output.h"
#include "app/readings_json.h"
#include "app/result_json.h"
#include "app/result_text.h"
#include "app/version.h"
#include "core/unit_names.h"
#include "identification/identify.h"

namespace artcal {
namespace {

struct Request {
  CommonOptions common;
  std::string recording;
  std::string arm_out;
  DccRequest dcc;
  std::string report;
  std::vector<std::string> hold, free;
  std::string loss;
  std::string noise, encoder_noise, probing_noise;
  bool no_leave_out = false;
  bool no_residuals = false;
  int threads = 0;
};

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// The command line replaces the recording's noise as a whole: half of one and half of the other is neither.
Expected<Noise> noise_of(const Request& request, const Recording& recording) {
  if (request.noise.empty() && request.encoder_noise.empty() && request.probing_noise.empty()) {
    return recording.noise;
  }
  const auto given = [](const std::string& text, auto read) { return text.empty() ? std::nullopt : read(text); };
  const auto as_length = [](const std::string& text) { return length_quantity(text); };
  const auto as_angle = [](const std::string& text) { return angle_quantity(text); };
  const Noise noise{given(request.noise, as_length), given(request.encoder_noise, as_angle),
                    given(request.probing_noise, as_length)};
  const bool read = noise.reading.has_value() != request.noise.empty() &&
                    noise.encoder.has_value() != request.encoder_noise.empty() &&
                    noise.probing.has_value() != request.probing_noise.empty();
  if (!read || noise.reading.value_or(1.0) <= 0.0 || noise.encoder.value_or(1.0) <= 0.0 ||
      noise.probing.value_or(1.0) <= 0.0) {
    return wrong_usage(
        "a noise is a number above zero with its unit, such as --noise \"15 um\" or --encoder-noise \"2 arcsec\"");
  }
  if (noise.reading.has_value() == noise.encoder.has_value() ||
      noise.encoder.has_value() != noise.probing.has_value()) {
    return wrong_usage("state either --noise, or --encoder-noise and --probing-noise together");
  }
  return noise;
}

Expected<IdentifyOptions> options_of(const Request& request, const Recording& recording) {
  IdentifyOptions options = recorded_options(recording);
  options.hold.insert(options.hold.end(), request.hold.begin(), request.hold.end());
  options.free.insert(options.free.end(), request.free.begin(), request.free.end());
  options.loss = request.loss.empty() ? options.loss : loss_named(request.loss);
  options.leave_out = !request.no_leave_out;
  options.threads = request.threads;
  return noise_of(request, recording).map([&](const Noise& noise) {
    options.noise = noise;
    return options;
  });
}

std::string identified_arm_text(const Recording& recording, const Identification& result) {
  ArmIdentification known;
  known.program = fmt::format("artcal {}", program_version);
  known.recording = recording.inputs.front().sha256;
  for (const int index : result.free) {
    known.parameters.push_back(result.parameters[index].parameter.name);
  }
  known.covariance = result.covariance;
  known.noise = result.noise * result.enlargement;
  return arm_file_text(result.arm, known);
}

Expected<int> identify_and_tell(const Request& request) {
  const auto start = Clock::now();
  auto recording = read_recording(request.recording);
  if (!recording) {
    return tl::unexpected(recording.error());
  }
  const auto constraints = read_constraints(*recording);
  if (!constraints) {
    return tl::unexpected(constraints.error());
  }
  const auto options = options_of(request, *recording);
  if (!options) {
    return tl::unexpected(options.error());
  }
  const auto certificate = read_certificate_data(request.dcc, *recording);
  if (!certificate) {
    return tl::unexpected(certificate.error());
  }
  if (auto checked =
          check_outputs({request.arm_out, request.common.json, request.dcc.out, request.report}, recording->inputs);
      !checked) {
    return tl::unexpected(checked.error());
  }
  const double reading_seconds = seconds_since(start);
  const auto result = run_identification(*recording, *constraints, *options);
  if (!result) {
    return tl::unexpected(result.error());
  }
  const Timings timings{reading_seconds, seconds_since(start) - reading_seconds};
  if (!request.arm_out.empty()) {
    if (auto written = write_file(request.arm_out, identified_arm_text(*recording, *result)); !written) {
      return tl::unexpected(written.error());
    }
  }
  if (*certificate) {
    const DccDocument document = dcc_of(*recording, *constraints, *result, **certificate);
    if (auto written = write_file(request.dcc.out, dcc_xml(document)); !written) {
      return tl::unexpected(written.error());
    }
  }
  if (!request.common.json.empty() || !request.report.empty()) {
    auto json = to_json(*recording, *constraints, *options, *result, timings);
    json["residuals"] = residuals_json(*recording, *constraints, *result);
    if (auto written = write_identification_report(request.report, json, *recording, *options, *result); !written) {
      return tl::unexpected(written.error());
    }
    if (request.no_residuals) {
      json.erase("residuals");
    }
    if (auto written = write_json(request.common.json, json); !written) {
      return tl::unexpected(written.error());
    }
  }
  if (request.common.talks()) {
    fmt::print("{}", to_text(*recording, *constraints, *result));
    fmt::print("{}\n", request.arm_out.empty() ? "The identified arm was not written; add -o ARM.toml to keep it."
                                               : fmt::format("The identified arm is in {}.", request.arm_out));
  }
  return 0;
}

}  // namespace

Run set_up_identify(CLI::App& parser) {
  auto request = std::make_shared<Request>();
  parser.add_option("recording", request->recording, "recording.toml")->required()->type_name("RECORDING");
  parser.add_option("-o,--output", request->arm_out, "write the identified arm, with its covariance")->type_name("ARM");
  parser.add_option("--report", request->report, "write a page to look at and to print")->type_name("FILE.html");
  request->dcc.add_to(parser);
  parser.add_option("--hold", request->hold, "parameters to keep at their nominal value, such as l,a1")
      ->delimiter(',')
      ->type_name("NAMES");
  parser.add_option("--free", request->free, "parameters to identify although they are held by default, such as a6")
      ->delimiter(',')
      ->type_name("NAMES");
  parser.add_option("--loss", request->loss, "how readings far off count")
      ->check(CLI::IsMember({"none", "huber", "cauchy"}));
  parser.add_option("--noise", request->noise, "noise of a reading's coordinate, such as \"15 um\"; else estimated");
  parser.add_option("--encoder-noise", request->encoder_noise, "noise of each joint, such as \"2 arcsec\"");
  parser.add_option("--probing-noise", request->probing_noise, "noise of the tip beside the joints', such as \"3 um\"");
  parser.add_flag("--no-leave-out", request->no_leave_out, "do not identify again without each placement");
  parser.add_flag("--no-residuals", request->no_residuals, "leave the readings out of the JSON: it is much smaller");
  parser.add_option("--threads", request->threads, "threads for leaving out; 0 takes all, the result is the same")
      ->check(CLI::NonNegativeNumber);
  request->common.add_to(parser);
  parser.footer("Example:\n  artcal identify examples/two-socket-bar/recording.toml -o panda.toml --json result.json");
  return [request] {
    const auto done = identify_and_tell(*request);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
