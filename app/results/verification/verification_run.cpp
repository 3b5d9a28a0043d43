#include "app/results/verification/verification_run.h"

#include <vector>

#include "app/results/verification/earlier_values.h"

namespace artcal {
namespace {

Standard standard_named(const std::string& name) {
  return name == "b89.4.22"       ? Standard::B89_4_22
         : name == "sphere-plate" ? Standard::SpherePlate
                                  : Standard::Iso10360_12;
}

}  // namespace

Expected<VerificationResult> run_verification(VerificationMaterial& material, const std::string& named,
                                              const std::string& against) {
  const std::string standard = named.empty() ? material.recording.verify.standard : named;
  if (standard.empty()) {
    return wrong_usage(
        "what is the arm to be judged by? Give --standard iso10360-12, b89.4.22 or sphere-plate, or write it into the "
        "recording: [verify] with standard = \"iso10360-12\"");
  }
  std::vector<TestValue> earlier;
  if (!against.empty()) {
    auto read = read_earlier_values(against, standard, material.recording.inputs);
    if (!read) {
      return tl::unexpected(read.error());
    }
    earlier = std::move(*read);
    material.specification.plan = TestPlan{};  // a few lengths are enough
  }
  auto result = verify(material.session(), standard_named(standard));
  if (!result) {
    return tl::unexpected(with_warnings(result.error(), material.recording.warnings));
  }
  if (!against.empty()) {
    result->interim = compare(result->verification.values, earlier);
  }
  auto& warnings = result->verification.warnings;
  auto of_documents = document_warnings(material.recording, material.constraints.artefacts);
  std::erase_if(of_documents, [&](const DocumentWarning& warning) { return is_noted(result->verification, warning); });
  const auto texts = texts_of(of_documents);
  warnings.insert(warnings.begin(), texts.begin(), texts.end());
  warnings.insert(warnings.begin(), material.constraints.warnings.begin(), material.constraints.warnings.end());
  warnings.insert(warnings.begin(), material.recording.warnings.begin(), material.recording.warnings.end());
  return result;
}

bool is_shown(const VerificationResult& result) {
  if (const auto& interim = result.interim) {
    return interim->any_judged() && !interim->any_significant() &&
           result.verification.conclusion != Conclusion::NonConformityProven;
  }
  return result.verification.conclusion == Conclusion::ConformityProven;
}

}  // namespace artcal
