#include "artefacts/certificate.h"

#include <fmt/format.h>

#include "core/in_quotes.h"

namespace artcal {

namespace {

void check_same(TomlTable& table, std::string_view key, const std::string& stated, const std::string& digital) {
  if (!digital.empty() && stated != digital) {
    table.fail(key, fmt::format("`{}` is {}, but the digital certificate says {}; is it another certificate?", key,
                                in_quotes(stated), in_quotes(digital)));
  }
}

}  // namespace

Certificate read_certificate(TomlTable table, const Certificate& digital) {
  Certificate certificate;
  certificate.number = table.name_or("number", digital.number);
  certificate.laboratory = table.name_or("laboratory", digital.laboratory);
  certificate.date = table.date_or("date", digital.date);
  check_same(table, "number", certificate.number, digital.number);
  check_same(table, "date", certificate.date, digital.date);
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
