#include "app/history/recall/certificate_use.h"

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {

Expected<std::vector<CertificateUse>> uses_of_certificate(Store& store, const std::string& number) {
  const auto rows = store.rows(
      "SELECT r.arm, r.measured_on, r.name, a.name, c.laboratory, f.path FROM certificates c "
      "JOIN artefacts a ON a.artefact = c.artefact JOIN used_certificates u ON u.certificate = c.certificate "
      "JOIN recordings r ON r.recording = u.recording LEFT JOIN files f ON f.recording = r.recording "
      "WHERE c.number = :v0 ORDER BY r.arm, coalesce(r.measured_on, ''), r.name, f.path",
      {number});
  if (!rows) {
    return tl::unexpected(rows.error());
  }
  if (rows->empty()) {
    return bad_input(fmt::format("no result rests on a certificate of number {}", in_quotes(number)), store.name());
  }
  const auto text = [](const StoreValue& value) {
    const auto* inner = std::get_if<std::string>(&value);
    return inner != nullptr ? *inner : std::string();
  };
  std::vector<CertificateUse> uses;
  for (const StoreRow& row : *rows) {
    uses.push_back({text(row[0]), text(row[1]), text(row[2]), text(row[3]), text(row[4]), text(row[5])});
  }
  return uses;
}

}  // namespace artcal
