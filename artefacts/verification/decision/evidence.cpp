#include "artefacts/verification/decision/evidence.h"

#include "core/enum_names.h"

namespace artcal {
namespace {

constexpr EnumNames<Evidence, 8> words_of_evidence{{{Evidence::CertificateAbsent, "certificate_absent"},
                                                    {Evidence::CertificateLapsed, "certificate_lapsed"},
                                                    {Evidence::CertificateNotYetValid, "certificate_not_yet_valid"},
                                                    {Evidence::DateAbsent, "date_absent"},
                                                    {Evidence::IndependentReadings, "independent_readings"},
                                                    {Evidence::DistinctPoints, "distinct_points"},
                                                    {Evidence::CentreDilution, "centre_dilution"},
                                                    {Evidence::PlausibleValues, "plausible_values"}}};

}  // namespace

const char* name_of(Evidence evidence) { return name_in(words_of_evidence, evidence); }

std::string evidence_names() { return list_of(words_of_evidence); }

std::optional<Evidence> evidence_named(const std::string& name) { return value_in(words_of_evidence, name); }

}  // namespace artcal
