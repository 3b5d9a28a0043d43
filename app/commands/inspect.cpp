#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/requests/identify_request.h"
#include "app/requests/recording_request.h"
#include "app/results/inspection/inspected_run.h"
#include "app/results/inspection/inspection_json.h"
#include "app/results/inspection/inspection_text.h"
#include "app/results/verification/verification_run.h"

namespace artcal {
namespace {

struct InspectArguments {
  CommonOptions common;
  RecordingRequest recording;
  bool no_fit = false;
};

bool asks_for_verification(const Recording& recording) {
  return !recording.verify.standard.empty() && !recording.specification_path.empty();
}

// What a verification would say of limits and specification; nothing where it cannot be.
Findings findings_by_standard(const InspectArguments& arguments, Recording&& as_read) {
  const VerificationSources sources{"", "", arguments.recording.access(), arguments.recording.options.limits};
  const auto result =
      read_verification_material(std::move(as_read), sources).and_then([](VerificationMaterial&& material) {
        return run_verification(material, "", "");
      });
  return result ? findings_of_verification(result->verification.evidence) : Findings{};
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

Expected<int> inspect_and_tell(const InspectArguments& arguments) {
  auto as_read = arguments.recording.read();
  if (!as_read) {
    return tl::unexpected(as_read.error());
  }
  auto to_verify = asks_for_verification(*as_read) ? std::optional(*as_read) : std::nullopt;
  auto bound = arguments.recording.bind(std::move(*as_read));
  if (!bound) {
    return tl::unexpected(bound.error());
  }
  auto& [recording, constraints] = *bound;
  if (auto checked = arguments.recording.check_outputs({arguments.common.json}, recording); !checked) {
    return tl::unexpected(checked.error());
  }
  const IdentifyOptions options = recorded_options(recording);
  Inspection inspection = inspected(recording, constraints, arguments.no_fit ? nullptr : &options);
  if (to_verify) {
    add_new(inspection.findings, findings_by_standard(arguments, std::move(*to_verify)));
  }
  return arguments.common.tell(to_json(recording, constraints, inspection), to_text(recording, constraints, inspection),
                               inspection.findings.empty() ? 0 : mistakes_found);
}

}  // namespace

Run set_up_inspect(CLI::App& parser) {
  auto arguments = std::make_shared<InspectArguments>();
  arguments->recording.add_path_to(parser);
  parser.add_flag("--no-fit", arguments->no_fit,
                  "leave out what needs a quick fit: orders, signs, units, labels, radii");
  arguments->recording.options.add_to(parser);
  arguments->common.add_to(parser);
  parser.footer(
      "The exit code is 0 where no mistake is found and 1 where one is; remarks do not count.\n"
      "Example:\n  artcal inspect examples/two-socket-bar/recording.toml");
  return [arguments] {
    const auto done = inspect_and_tell(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
