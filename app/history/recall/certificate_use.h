#pragma once

#include <string>
#include <vector>

#include "app/store/store.h"

namespace artcal {

/// A result that rests on a certificate.
struct CertificateUse {
  std::string arm, date, name, artefact, laboratory;
  std::string path;  ///< of the recording file; empty where none leads to the result any more
};

/// Every result in the store that rests on a certificate of this number, also those that no longer stand. Refused:
/// a number that no certificate has; an empty list never comes back.
Expected<std::vector<CertificateUse>> uses_of_certificate(Store& store, const std::string& number);

}  // namespace artcal
