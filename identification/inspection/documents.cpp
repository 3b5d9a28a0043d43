#include "identification/inspection/documents.h"

#include <fmt/format.h>

#include "artefacts/artefact/plausibility.h"
#include "artefacts/certificate/certificate.h"
#include "core/text/in_quotes.h"

namespace artcal {
Findings find_wrong_documents(const Recording& recording, const std::vector<Artefact>& artefacts) {
  Findings findings;
  for (std::size_t i = 0; i < artefacts.size(); ++i) {
    for (const std::string& text : implausible_values(artefacts[i])) {
      findings.push_back({FindingKind::ImplausibleValue, artefact_path(recording, i), text});
    }
    for (const std::string& text : certificate_warnings({artefacts[i]}, recording.date)) {
      findings.push_back({FindingKind::Certificate, artefact_path(recording, i), text});
    }
  }
  for (const std::string& text : implausible_values(recording)) {
    findings.push_back({FindingKind::ImplausibleValue, "", text});
  }
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
