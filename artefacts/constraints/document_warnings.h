#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "acquisition/recording/recording.h"
#include "artefacts/artefact/artefact.h"

namespace artcal {

/// What a warning, or evidence that is missing, is about.
struct Subject {
  enum class Kind { Test, Recording, Artefact };
  Kind kind = Kind::Test;
  std::size_t artefact = 0;  ///< into Constraints::artefacts; 0 of other kinds

  bool operator==(const Subject&) const = default;
};

/// What looks wrong in the recording or in an artefact's file but may be right.
struct DocumentWarning {
  enum class Kind {
    ImplausibleValue,        ///< a number that is none of its kind, perhaps of another unit
    CertificateLapsed,       ///< its validity had ended on the day of the readings
    CertificateNotYetValid,  ///< the artefact was calibrated after the readings
  };
  Kind kind = Kind::ImplausibleValue;
  Subject about;
  std::string text;  ///< one sentence
};

/// The documents' warnings: implausible values of all artefacts, then of the recording, then certificates that are not
/// valid on its day. Of a recording without a date the clock of this computer is not asked.
std::vector<DocumentWarning> document_warnings(const Recording& recording, const std::vector<Artefact>& artefacts);

std::vector<std::string> texts_of(const std::vector<DocumentWarning>& warnings);

}  // namespace artcal
