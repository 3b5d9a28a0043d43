#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/report/report.h"
#include "app/requests/dcc_request.h"
#include "app/requests/recording_request.h"
#include "app/results/inspection/inspected_run.h"
#include "app/results/inspection/inspection_json.h"
#include "app/results/inspection/inspection_text.h"
#include "app/results/verification/dcc_verification.h"
#include "app/results/verification/verification_json.h"
#include "app/results/verification/verification_material.h"
#include "app/results/verification/verification_run.h"
#include "app/results/verification/verification_text.h"
#include "app/version.h"
#include "artefacts/artefact/artefact_text.h"
#include "artefacts/dcc/writing/dcc_write.h"
#include "artefacts/verification/verify.h"

namespace artcal {
namespace {

constexpr int conformity_not_shown = 1;

struct VerifyArguments {
  CommonOptions common;
  RecordingRequest recording;
  std::string arm, specification;
  std::string standard, against, report;
  DccRequest dcc;
  std::string artefact_out;
  bool all = false;
};

// The plate that was calibrated by swinging it round, as an artefact file; nothing where none is asked for.
Expected<std::string> calibrated_plate_text(const VerifyArguments& arguments, const VerificationMaterial& material,
                                            const VerificationResult& result) {
  if (arguments.artefact_out.empty()) {
    return std::string();
  }
  if (result.calibrations.size() != 1) {
    return no_solution(fmt::format(
        "--artefact-out writes the one plate that was read completely in four or more placements, and there are {}",
        result.calibrations.size()));
  }
  const PlateCalibration& calibration = result.calibrations.front();
  const auto& artefacts = material.constraints.artefacts;
  const auto certified = std::find_if(artefacts.begin(), artefacts.end(),
                                      [&](const Artefact& artefact) { return artefact.name == calibration.artefact; });
  return artefact_file_text(calibrated_artefact(*certified, calibration),
                            {fmt::format("Written by artcal {} from the recording with the SHA-256 {}; no certificate.",
                                         program_version, material.recording.inputs.front().sha256)});
}

Expected<int> verify_and_tell(const VerifyArguments& arguments) {
  auto material = arguments.recording.read().and_then([&](Recording&& recording) {
    return read_verification_material(
        std::move(recording),
        {arguments.arm, arguments.specification, arguments.recording.access(), arguments.recording.options.limits});
  });
  if (!material) {
    return tl::unexpected(material.error());
  }
  const auto result = run_verification(*material, arguments.standard, arguments.against);
  if (!result) {
    return tl::unexpected(result.error());
  }
  const auto certificate = read_certificate_data(arguments.dcc, material->recording);
  if (!certificate) {
    return tl::unexpected(certificate.error());
  }
  if (auto checked = arguments.recording.check_outputs(
          {arguments.common.json, arguments.dcc.out, arguments.artefact_out, arguments.report}, material->recording);
      !checked) {
    return tl::unexpected(checked.error());
  }
  const auto plate = calibrated_plate_text(arguments, *material, *result);
  if (!plate) {
    return tl::unexpected(plate.error());
  }
  if (!plate->empty()) {
    if (auto written = write_file(arguments.artefact_out, *plate); !written) {
      return tl::unexpected(written.error());
    }
  }
  const Session session = material->session();
  if (*certificate) {
    if (auto written = write_file(arguments.dcc.out, dcc_xml(dcc_of(session, *result, **certificate))); !written) {
      return tl::unexpected(written.error());
    }
  }
  const Findings findings = findings_for_verification(material->recording, material->constraints, session.arm);
  auto json = to_json(session, *result);
  json["findings"] = findings_json(findings);
  if (!arguments.report.empty()) {
    const auto written = report_html({reported(json)}).and_then([&](const std::string& page) {
      return write_file(arguments.report, page);
    });
    if (!written) {
      return tl::unexpected(written.error());
    }
  }
  return arguments.common.tell(json, to_text(session, *result, arguments.all) + further_findings_text(findings),
                               is_shown(*result) ? 0 : conformity_not_shown);
}

}  // namespace

Run set_up_verify(CLI::App& parser) {
  auto arguments = std::make_shared<VerifyArguments>();
  arguments->recording.add_path_to(parser);
  parser.add_option("--standard", arguments->standard, "what to judge by; else the recording's")
      ->check(CLI::IsMember({"iso10360-12", "b89.4.22", "sphere-plate"}));
  parser.add_option("--arm", arguments->arm, "the arm to judge, such as an identified one; else the recording's")
      ->type_name("ARM");
  parser.add_option("--specification", arguments->specification, "limits and plan; else the recording's")
      ->type_name("FILE");
  parser
      .add_option("--against", arguments->against,
                  "interim check: a JSON result of an earlier verification to hold a few values against")
      ->type_name("FILE");
  parser.add_option("--report", arguments->report, "write a report (HTML, prints on A4)")->type_name("FILE.html");
  parser
      .add_option("--artefact-out", arguments->artefact_out,
                  "sphere-plate: write the plate as four or more placements determine it, an artefact file")
      ->type_name("FILE");
  arguments->dcc.add_to(parser);
  parser.add_flag("--all", arguments->all, "print every value, however many there are");
  arguments->recording.options.add_to(parser);
  arguments->common.add_to(parser);
  parser.footer(
      "The exit code is 0 where conformity is proven (with --against: where no drift is) and 1 where it is not.\n"
      "Example:\n  artcal verify examples/iso10360-12/recording.toml --standard iso10360-12");
  return [arguments] {
    const auto done = verify_and_tell(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
