#include "artefacts/verification/evidence.h"

#include <array>
#include <utility>

namespace artcal {
namespace {

constexpr std::array<std::pair<Evidence, const char*>, 8> names{
    {{Evidence::CertificateAbsent, "certificate_absent"},
     {Evidence::CertificateLapsed, "certificate_lapsed"},
     {Evidence::CertificateNotYetValid, "certificate_not_yet_valid"},
     {Evidence::DateAbsent, "date_absent"},
     {Evidence::IndependentReadings, "independent_readings"},
     {Evidence::DistinctPoints, "distinct_points"},
     {Evidence::CentreDilution, "centre_dilution"},
     {Evidence::PlausibleValues, "plausible_values"}}};

}  // namespace

const char* name_of(Evidence evidence) {
  for (const auto& [known, name] : names) {
    if (known == evidence) {
      return name;
    }
  }
  return "";
}

std::string evidence_names() {
  std::string text;
  for (const auto& [evidence, name] : names) {
    text += (text.empty() ? "" : evidence == names.back().first ? " or " : ", ") + std::string(name);
  }
  return text;
}

std::optional<Evidence> evidence_named(const std::string& name) {
  for (const auto& [evidence, known] : names) {
    if (name == known) {
      return evidence;
    }
  }
  return std::nullopt;
}

}  // namespace artcal
