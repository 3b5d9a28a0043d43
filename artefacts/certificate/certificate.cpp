#include "artefacts/certificate/certificate.h"

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {

namespace {

std::string number_of(const Certificate& certificate) {
  return certificate.number.empty() ? "" : " " + in_quotes(certificate.number);
}

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

std::string lapsed_text(const Artefact& artefact, const std::string& day) {
  const Certificate& certificate = artefact.certificate;
  return certificate.valid_until.empty() || certificate.valid_until >= day
             ? ""
             : fmt::format(
                   "the certificate{} of the artefact {} had lapsed: it was valid until {}, the readings are of {}",
                   number_of(certificate), in_quotes(artefact.name), certificate.valid_until, day);
}

std::string not_yet_valid_text(const Artefact& artefact, const std::string& day) {
  const Certificate& certificate = artefact.certificate;
  return certificate.date <= day
             ? ""
             : fmt::format(
                   "the certificate{} of the artefact {} was not yet valid: it was calibrated on {}, after the "
                   "readings of {}",
                   number_of(certificate), in_quotes(artefact.name), certificate.date, day);
}

}  // namespace artcal
