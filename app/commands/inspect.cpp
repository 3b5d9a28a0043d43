#include <memory>
#include <optional>
#include <set>

#include "acquisition/recording/recording_file.h"
#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/output/phrases.h"
#include "app/requests/access_option.h"
#include "app/requests/referenced_files.h"
#include "app/results/identification/identification_run.h"
#include "app/results/inspection/inspected_run.h"
#include "app/results/inspection/inspection_json.h"
#include "app/results/inspection/inspection_text.h"
#include "app/results/verification/verification_run.h"
#include "artefacts/constraints/read_constraints.h"

namespace artcal {
namespace {

constexpr int mistakes_found = 1;

struct Request {
  CommonOptions common;
  RecordingOptions access;
  std::string recording;
  bool no_fit = false;
};

bool asks_for_verification(const Recording& recording) {
  return !recording.verify.standard.empty() && !recording.specification_path.empty();
}

// What a verification would say of limits and specification; nothing where it cannot be.
Findings findings_by_standard(const Request& request, Recording&& as_read) {
  const VerificationSources sources{"", "", request.access.of(request.recording), request.access.limits};
  const auto result =
      read_verification_material(std::move(as_read), sources).and_then([](VerificationMaterial&& material) {
        return run_verification(material, "", "");
      });
  return result ? findings_of_verification(result->verification.missing) : Findings{};
}

void add_new(Findings& findings, Findings&& more) {
  std::set<std::string> known;
  for (const Finding& finding : findings) {
    known.insert(finding.text);
  }
  for (Finding& finding : more) {
    if (known.insert(finding.text).second) {
      findings.push_back(std::move(finding));
    }
  }
}

Expected<int> inspect_and_tell(const Request& request) {
  auto recording = read_recording(request.recording, request.access.of(request.recording));
  if (!recording) {
    return tl::unexpected(recording.error());
  }
  auto to_verify = asks_for_verification(*recording) ? std::optional(*recording) : std::nullopt;
  const auto constraints = read_constraints(*recording, request.access.of(request.recording), request.access.scans());
  if (!constraints) {
    return tl::unexpected(with_warnings(constraints.error(), recording->warnings));
  }
  if (auto checked =
          check_outputs({request.common.json}, referenced_files(*recording, request.access.of(request.recording)));
      !checked) {
    return tl::unexpected(checked.error());
  }
  const IdentifyOptions options = recorded_options(*recording);
  Inspection inspection = inspected(*recording, *constraints, request.no_fit ? nullptr : &options);
  if (to_verify) {
    add_new(inspection.findings, findings_by_standard(request, std::move(*to_verify)));
  }
  return request.common.tell(to_json(*recording, *constraints, inspection),
                             to_text(*recording, *constraints, inspection),
                             inspection.findings.empty() ? 0 : mistakes_found);
}

}  // namespace

Run set_up_inspect(CLI::App& parser) {
  auto request = std::make_shared<Request>();
  parser.add_option("recording", request->recording, "recording.toml")->required()->type_name("RECORDING");
  parser.add_flag("--no-fit", request->no_fit, "leave out what needs a quick fit: orders, signs, units, labels, radii");
  request->access.add_to(parser);
  request->common.add_to(parser);
  parser.footer(
      "The exit code is 0 where no mistake is found and 1 where one is; remarks do not count.\n"
      "Example:\n  artcal inspect examples/two-socket-bar/recording.toml");
  return [request] {
    const auto done = inspect_and_tell(*request);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
