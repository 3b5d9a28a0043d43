#include "artefacts/verification/verification.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

Evidence evidence_of(DocumentWarning::Kind kind) {
  switch (kind) {
    case DocumentWarning::Kind::CertificateLapsed: return Evidence::CertificateLapsed;
    case DocumentWarning::Kind::CertificateNotYetValid: return Evidence::CertificateNotYetValid;
    case DocumentWarning::Kind::ImplausibleValue: break;
  }
  return Evidence::PlausibleValues;
}

}  // namespace

std::string MissingEvidence::line() const { return fmt::format("{} [{}]", text, name_of(evidence)); }

void report_missing(Verification& verification, const Specification& specification, Evidence evidence,
                    const std::string& text, const Subject& about) {
  const MissingEvidence missing{evidence, text, specification.waived.contains(evidence), about};
  auto& list = missing.is_waived ? verification.waived : verification.missing;
  std::string line = missing.line();
  if (std::find(list.begin(), list.end(), line) == list.end()) {
    list.push_back(std::move(line));
    verification.evidence.push_back(missing);
  }
}

bool is_noted(const Verification& verification, const DocumentWarning& warning) {
  const auto& evidence = verification.evidence;
  return std::any_of(evidence.begin(), evidence.end(), [&](const MissingEvidence& missing) {
    return missing.evidence == evidence_of(warning.kind) && missing.about == warning.about;
  });
}

void judge(TestValue& value, const Specification& specification) {
  const auto limit = specification.limits.find(value.quantity);
  if (limit == specification.limits.end()) {
    return;
  }
  value.limit = limit->second.at(value.certified);
  value.verdict =
      decide(value.value, *value.limit, value.budget.total(), specification.rule, value.budget.degrees_of_freedom());
}

Conclusion conclude(const Verification& verification) {
  bool all_conform = verification.missing.empty() && !verification.values.empty();
  for (const TestValue& value : verification.values) {
    if (!value.set_aside && value.verdict == Verdict::NonConformityProven) {
      return Conclusion::NonConformityProven;
    }
    all_conform = all_conform && (value.set_aside || value.verdict == Verdict::ConformityProven);
  }
  return all_conform ? Conclusion::ConformityProven : Conclusion::ConformityNotShown;
}

double severity(const TestValue& value) { return std::abs(value.value) / value.limit.value_or(1.0); }

const TestValue* worst_of(const Verification& verification, Quantity quantity) {
  const TestValue* worst = nullptr;
  for (const TestValue& value : verification.values) {
    if (value.quantity == quantity && !value.set_aside && (worst == nullptr || severity(value) > severity(*worst))) {
      worst = &value;
    }
  }
  return worst;
}

const char* text_of(Conclusion conclusion) {
  switch (conclusion) {
    case Conclusion::ConformityProven: return "conformity proven";
    case Conclusion::NonConformityProven: return "non-conformity proven";
    case Conclusion::ConformityNotShown: break;
  }
  return "conformity not shown";
}

std::string label_of(const TestValue& value) {
  std::string text = name_of(value.quantity);
  text += value.second.empty() ? fmt::format(" {}", truncated(40, value.first))
                               : fmt::format(" {} - {}", truncated(40, value.first), truncated(40, value.second));
  text += value.placement.empty() ? "" : fmt::format(", placement {}", truncated(40, value.placement));
  return text + (value.repeat.empty() ? "" : fmt::format(", repeat {}", truncated(40, value.repeat)));
}

}  // namespace artcal
