#include "artefacts/certificate.h"

#include <fmt/format.h>

#include "core/in_quotes.h"

namespace artcal {

Certificate read_certificate(TomlTable table) {
  Certificate certificate;
  certificate.number = table.name_or("number", "");
  certificate.laboratory = table.name_or("laboratory", "");
  certificate.date = table.date_or("date", "");
  certificate.valid_until = table.date_or("valid_until", "");
  if (!certificate.date.empty() && !certificate.valid_until.empty() && certificate.valid_until < certificate.date) {
    table.fail("valid_until", fmt::format("the certificate is valid until {}, which is before its calibration on {}",
                                          certificate.valid_until, certificate.date));
  }
  return certificate;
}

std::vector<std::string> certificate_warnings(const std::vector<Artefact>& artefacts, const std::string& day) {
  std::vector<std::string> warnings;
  if (day.empty()) {
    return warnings;
  }
  for (const Artefact& artefact : artefacts) {
    const Certificate& certificate = artefact.certificate;
    const std::string number = certificate.number.empty() ? "" : " " + in_quotes(certificate.number);
    if (!certificate.valid_until.empty() && certificate.valid_until < day) {
      warnings.push_back(
          fmt::format("the certificate{} of the artefact {} had lapsed: it was valid until {}, the readings "
                      "are of {}",
                      number, in_quotes(artefact.name), certificate.valid_until, day));
    }
    if (!certificate.date.empty() && certificate.date > day) {
      warnings.push_back(fmt::format("the artefact {} was calibrated on {} (certificate{}), after the readings of {}",
                                     in_quotes(artefact.name), certificate.date, number, day));
    }
  }
  return warnings;
}

}  // namespace artcal
