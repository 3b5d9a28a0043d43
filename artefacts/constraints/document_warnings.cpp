#include "artefacts/constraints/document_warnings.h"

#include "artefacts/artefact/plausibility.h"
#include "artefacts/certificate/certificate.h"

namespace artcal {

std::vector<DocumentWarning> document_warnings(const Recording& recording, const std::vector<Artefact>& artefacts) {
  using Kind = DocumentWarning::Kind;
  std::vector<DocumentWarning> warnings;
  const auto about = [](std::size_t artefact) { return Subject{Subject::Kind::Artefact, artefact}; };
  const auto add = [&](Kind kind, const Subject& subject, const std::string& text) {
    if (!text.empty()) {
      warnings.push_back({kind, subject, text});
    }
  };
  for (std::size_t i = 0; i < artefacts.size(); ++i) {
    for (const std::string& text : implausible_values(artefacts[i])) {
      add(Kind::ImplausibleValue, about(i), text);
    }
  }
  for (const std::string& text : implausible_values(recording)) {
    add(Kind::ImplausibleValue, {Subject::Kind::Recording}, text);
  }
  for (std::size_t i = 0; i < artefacts.size() && !recording.date.empty(); ++i) {
    add(Kind::CertificateLapsed, about(i), lapsed_text(artefacts[i], recording.date));
    add(Kind::CertificateNotYetValid, about(i), not_yet_valid_text(artefacts[i], recording.date));
  }
  return warnings;
}

std::vector<std::string> texts_of(const std::vector<DocumentWarning>& warnings) {
  std::vector<std::string> texts;
  for (const DocumentWarning& warning : warnings) {
    texts.push_back(warning.text);
  }
  return texts;
}

}  // namespace artcal
