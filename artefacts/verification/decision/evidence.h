#pragma once

#include <optional>
#include <string>

namespace artcal {

/// What may be missing for a proof of conformity although every value conforms. A specification may waive each by name.
enum class Evidence {
  CertificateAbsent,       ///< certified values without the number and the date of a certificate
  CertificateLapsed,       ///< the certificate's validity had ended on the day of the readings
  CertificateNotYetValid,  ///< the artefact was calibrated after the readings
  DateAbsent,              ///< the recording has no date to hold the certificates against
  IndependentReadings,     ///< the arm was identified from readings that it is judged by
  DistinctPoints,          ///< fewer touches at different places than the plan asks
  CentreDilution,          ///< the places of the touches determine a centre or diameter poorly
  PlausibleValues,         ///< a limit, an uncertainty or a temperature is beyond what it can be
};

/// "certificate_lapsed": the name in specification files and messages.
const char* name_of(Evidence evidence);
std::optional<Evidence> evidence_named(const std::string& name);
/// All of these names, for a message.
std::string evidence_names();

}  // namespace artcal
