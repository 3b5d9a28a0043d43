#include "artefacts/verification/decision/traceability.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "acquisition/recording/reading_fingerprint.h"
#include "artefacts/certificate/certificate.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// A seat has nothing certified; of a ball there is always its form.
bool rests_on_certificate(const TestValue& value) {
  return value.certified > 0.0 ||
         (value.quantity != Quantity::Articulation && value.quantity != Quantity::ArticulationSpread);
}

/// Notes what is wrong with one artefact's certificate on a day, which may be unknown (empty).
class CertificateCheck {
 public:
  CertificateCheck(const Session& session, Verification& verification)
      : day_(session.recording.date),
        artefacts_(session.constraints.artefacts),
        specification_(session.specification),
        verification_(verification) {}

  void add(std::size_t index) {
    const Artefact& artefact = artefacts_[index];
    const Certificate& certificate = artefact.certificate;
    about_ = {Subject::Kind::Artefact, index};
    const std::string name = in_quotes(artefact.name);
    if (certificate.number.empty() && certificate.date.empty()) {
      note(Evidence::CertificateAbsent,
           fmt::format("the artefact {} has no certificate: its values are not traceable", name));
      return;
    }
    const std::string number = certificate.number.empty() ? "" : " " + in_quotes(certificate.number);
    if (certificate.number.empty() || certificate.date.empty()) {
      note(Evidence::CertificateAbsent, fmt::format("the certificate{} of the artefact {} states no {}", number, name,
                                                    certificate.number.empty() ? "number" : "date"));
    }
    if (day_.empty()) {
      return;
    }
    if (const std::string text = lapsed_text(artefact, day_); !text.empty()) {
      note(Evidence::CertificateLapsed, text);
    }
    if (const std::string text = not_yet_valid_text(artefact, day_); !text.empty()) {
      note(Evidence::CertificateNotYetValid, text);
    }
  }

 private:
  void note(Evidence evidence, const std::string& text) {
    report_missing(verification_, specification_, evidence, text, about_);
  }

  const std::string& day_;
  const std::vector<Artefact>& artefacts_;
  const Specification& specification_;
  Verification& verification_;
  Subject about_;
};

void check_independence(const Session& session, Verification& verification) {
  if (session.identification == nullptr) {
    return;
  }
  const Recording& recording = session.recording;
  const int known = count_known(recording, session.identification->readings);
  const auto& recordings = recording.inputs;
  const bool same_file = !recordings.empty() && recordings.front().sha256 == session.identification->recording;
  if (known == 0 && !same_file) {
    return;
  }
  report_missing(
      verification, session.specification, Evidence::IndependentReadings,
      fmt::format("the arm {} was identified from {}; judge it by readings of its own", in_quotes(session.arm.name),
                  known > 0
                      ? fmt::format("{} of the {} readings that it is judged by", known, recording.readings.size())
                      : "this recording"));
}

}  // namespace

void check_traceability(const Session& session, Verification& verification) {
  std::set<std::string> used;
  for (const TestValue& value : verification.values) {
    if (rests_on_certificate(value)) {
      used.insert(value.artefact);
    }
  }
  CertificateCheck certificates(session, verification);
  const std::vector<Artefact>& artefacts = session.constraints.artefacts;
  for (std::size_t i = 0; i < artefacts.size(); ++i) {
    if (used.contains(artefacts[i].name)) {
      certificates.add(i);
    }
  }
  if (!used.empty() && session.recording.date.empty()) {
    report_missing(verification, session.specification, Evidence::DateAbsent,
                   "the recording states no date: whether the certificates were valid cannot be determined");
  }
  check_independence(session, verification);
}

}  // namespace artcal
