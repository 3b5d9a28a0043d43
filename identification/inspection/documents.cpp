#include "identification/inspection/documents.h"

#include <fmt/format.h>

#include "artefacts/constraints/document_warnings.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

Finding document_finding(const DocumentWarning& warning, const std::string& where) {
  const bool is_value = warning.kind == DocumentWarning::Kind::ImplausibleValue;
  return {is_value ? FindingKind::ImplausibleValue : FindingKind::Certificate, where, warning.text, true};
}

}  // namespace

Findings find_wrong_documents(const Recording& recording, const std::vector<Artefact>& artefacts) {
  const auto warnings = document_warnings(recording, artefacts);
  Findings findings;
  const auto add = [&](const Subject& about, const std::string& where) {
    for (const DocumentWarning& warning : warnings) {
      if (warning.about == about) {
        findings.push_back(document_finding(warning, where));
      }
    }
  };
  for (std::size_t i = 0; i < artefacts.size(); ++i) {
    add({Subject::Kind::Artefact, i}, artefact_path(recording, i));
  }
  add({Subject::Kind::Recording}, "");
  return findings;
}

Findings find_missing_documents(const Recording& recording, const std::vector<Artefact>& artefacts) {
  Findings remarks;
  if (recording.date.empty()) {
    remarks.push_back({FindingKind::NoDate, recording.inputs.empty() ? "" : recording.inputs.front().path,
                       "the recording does not say when it was made, so that no certificate can be held against its "
                       "date; write date = 2026-03-10, say, at the top"});
  }
  for (std::size_t i = 0; i < artefacts.size(); ++i) {
    if (artefacts[i].certificate.number.empty()) {
      remarks.push_back({FindingKind::NoCertificateNumber, artefact_path(recording, i),
                         fmt::format("the certificate of artefact {} has no number, so that no result rests on it "
                                     "traceably; write number = \"…\" under [certificate]",
                                     in_quotes(artefacts[i].name))});
    }
  }
  return remarks;
}

}  // namespace artcal
