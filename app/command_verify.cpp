#include <memory>
#include <optional>

#include <fmt/format.h>

#include "acquisition/arm_file.h"
#include "acquisition/recording_file.h"
#include "acquisition/tip_centres.h"
#include "app/command.h"
#include "app/dcc_request.h"
#include "app/dcc_verification.h"
#include "app/output.h"
#include "app/report/report.h"
#include "app/verification_json.h"
#include "app/verification_text.h"
#include "artefacts/verification/specification_file.h"
#include "artefacts/verification/verify.h"

namespace artcal {
namespace {

constexpr int conformity_not_shown = 1;

struct Request {
  CommonOptions common;
  std::string recording, standard, arm, specification, against, report;
  DccRequest dcc;
  bool all = false;
};

/// What a session refers to.
struct Material {
  Recording recording;
  Constraints constraints;
  std::optional<Arm> other_arm;
  TipCentres tips;
  Specification specification;

  [[nodiscard]] const Arm& arm() const { return other_arm ? *other_arm : recording.arm; }
};

Expected<void> read_arm_and_tips(const Request& request, Material& material) {
  if (!request.arm.empty()) {
    auto file = read_arm_file(request.arm);
    if (!file) {
      return tl::unexpected(file.error());
    }
    material.recording.inputs.push_back(file->input);
    material.other_arm = std::move(file->arm);
  }
  auto tips =
      material.other_arm ? tip_centres(material.recording, *material.other_arm) : tip_centres(material.recording);
  if (!tips) {
    return tl::unexpected(tips.error());
  }
  material.tips = std::move(*tips);
  return {};
}

Expected<Material> read_material(const Request& request) {
  auto recording = read_recording(request.recording);
  if (!recording) {
    return tl::unexpected(recording.error());
  }
  if (!recording->scans.empty()) {
    return bad_input(
        "a test judges every reading, but of a scan only points near its spheres become readings; expected readings "
        "without [[scan]]",
        recording->scans.front().where);
  }
  auto constraints = read_constraints(*recording);
  if (!constraints) {
    return tl::unexpected(constraints.error());
  }
  Material material{std::move(*recording), std::move(*constraints), {}, {}, {}};
  if (auto read = read_arm_and_tips(request, material); !read) {
    return tl::unexpected(read.error());
  }
  const std::string path =
      request.specification.empty() ? material.recording.specification_path : request.specification;
  if (!path.empty()) {
    auto file = read_specification_file(path);
    if (!file) {
      return tl::unexpected(file.error());
    }
    material.recording.inputs.push_back(file->input);
    material.specification = std::move(file->specification);
  }
  return material;
}

Standard standard_of(const std::string& name) {
  return name == "b89.4.22"       ? Standard::B89_4_22
         : name == "sphere-plate" ? Standard::SpherePlate
                                  : Standard::Iso10360_12;
}

bool is_shown(const VerificationResult& result) {
  if (const auto& interim = result.interim) {
    return interim->any_told() && !interim->any_significant() &&
           result.verification.conclusion != Conclusion::NonConformityShown;
  }
  return result.verification.conclusion == Conclusion::ConformityShown;
}

Expected<VerificationResult> verified(const Request& request, Material& material) {
  std::vector<TestValue> earlier;
  if (!request.against.empty()) {
    auto read = read_earlier_values(request.against, request.standard, material.recording.inputs);
    if (!read) {
      return tl::unexpected(read.error());
    }
    earlier = std::move(*read);
    material.specification.plan = TestPlan{};  // a few lengths are enough
  }
  const Session session{material.recording, material.constraints, material.arm(), material.tips,
                        material.specification};
  auto result = verify(session, standard_of(request.standard));
  if (result && !request.against.empty()) {
    result->interim = compare(result->verification.values, earlier);
  }
  return result;
}

Expected<int> verify_and_tell(const Request& request) {
  auto material = read_material(request);
  if (!material) {
    return tl::unexpected(material.error());
  }
  auto result = verified(request, *material);
  if (!result) {
    return tl::unexpected(result.error());
  }
  const auto certificate = read_certificate_data(request.dcc, material->recording);
  if (!certificate) {
    return tl::unexpected(certificate.error());
  }
  if (auto checked = check_outputs({request.common.json, request.dcc.out, request.report}, material->recording.inputs);
      !checked) {
    return tl::unexpected(checked.error());
  }
  const Session session{material->recording, material->constraints, material->arm(), material->tips,
                        material->specification};
  auto& warnings = result->verification.warnings;
  warnings.insert(warnings.begin(), material->constraints.warnings.begin(), material->constraints.warnings.end());
  warnings.insert(warnings.begin(), material->recording.warnings.begin(), material->recording.warnings.end());
  if (*certificate) {
    if (auto written = write_file(request.dcc.out, dcc_xml(dcc_of(session, *result, **certificate))); !written) {
      return tl::unexpected(written.error());
    }
  }
  const auto json = to_json(session, *result);
  if (!request.report.empty()) {
    const auto written = report_html({reported(json)}).and_then([&](const std::string& page) {
      return write_file(request.report, page);
    });
    if (!written) {
      return tl::unexpected(written.error());
    }
  }
  if (auto written = write_json(request.common.json, json); !written) {
    return tl::unexpected(written.error());
  }
  if (request.common.talks()) {
    fmt::print("{}", to_text(session, *result, request.all));
  }
  return is_shown(*result) ? 0 : conformity_not_shown;
}

}  // namespace

Run set_up_verify(CLI::App& parser) {
  auto request = std::make_shared<Request>();
  parser.add_option("recording", request->recording, "recording.toml")->required()->type_name("RECORDING");
  parser.add_option("--standard", request->standard, "what to judge by")
      ->required()
      ->check(CLI::IsMember({"iso10360-12", "b89.4.22", "sphere-plate"}));
  parser.add_option("--arm", request->arm, "the arm to judge, such as an identified one; else the recording's")
      ->type_name("ARM");
  parser.add_option("--specification", request->specification, "limits and plan; else the recording's")
      ->type_name("FILE");
  parser
      .add_option("--against", request->against,
                  "interim check: a JSON result of an earlier verification to hold a few values against")
      ->type_name("FILE");
  parser.add_option("--report", request->report, "write a page to look at and to print")->type_name("FILE.html");
  request->dcc.add_to(parser);
  parser.add_flag("--all", request->all, "print every value, however many there are");
  request->common.add_to(parser);
  parser.footer(
      "The exit code is 0 where conformity is shown (with --against: where no drift is) and 1 where it is not.\n"
      "Example:\n  artcal verify examples/iso10360-12/recording.toml --standard iso10360-12");
  return [request] {
    const auto done = verify_and_tell(*request);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
