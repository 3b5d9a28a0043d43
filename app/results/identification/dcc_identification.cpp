#include "app/results/identification/dcc_identification.h"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "app/results/artefact_summary.h"
#include "app/results/dcc_terms.h"
#include "app/version.h"
#include "identification/identifiability/unidentifiable_text.h"

namespace artcal {
namespace {

constexpr const char* radian = "\\radian";

const char* unit_of(const IdentifiedParameter& parameter) {
  switch (parameter.parameter.kind) {
    case ParameterKind::Gain:
    case ParameterKind::Coupling: return "\\one";
    case ParameterKind::Compliance: return "\\radian\\newton\\tothe{-1}\\milli\\metre\\tothe{-1}";
    case ParameterKind::Expansion: return "\\kelvin\\tothe{-1}";
    default: return parameter.parameter.is_angle() ? radian : dcc_millimetre;
  }
}

DccEntry plain_entry(const std::string& name, double value) {
  return {name, "", dcc_millimetre, value, std::nullopt, std::nullopt, ""};
}

DccResult identified_parameters(const Identification& result) {
  DccResult section{
      "Identified parameters",
      "Denavit-Hartenberg parameters of the arm. U is expanded with the coverage factor that stands beside "
      "it: 2, or Student's for 95 % and the effective degrees of freedom. They are correlated: combine them "
      "with their covariance, which stands in the program's own files, not one by one.",
      {}};
  for (const IdentifiedParameter& p : result.parameters) {
    if (p.state == ParameterState::Identified || p.state == ParameterState::Weak) {
      section.entries.push_back({p.parameter.name, "artcal_parameterIdentified", unit_of(p), p.identified,
                                 DccUncertainty{p.coverage_factor() * p.u, p.coverage_factor(), dcc_probability},
                                 std::nullopt, ""});
    }
  }
  return section;
}

DccResult kept_parameters(const Identification& result) {
  DccResult section{"Parameters kept at their nominal value",
                    "Kept by request or because the readings cannot determine them; no uncertainty is stated.",
                    {}};
  for (const IdentifiedParameter& p : result.parameters) {
    if (p.state != ParameterState::Identified && p.state != ParameterState::Weak) {
      section.entries.push_back(
          {p.parameter.name, "artcal_parameterKept", unit_of(p), p.identified, std::nullopt, std::nullopt, ""});
    }
  }
  return section;
}

// By a nominal arm that cannot be evaluated there is no deviation.
std::vector<DccEntry> finite(std::vector<DccEntry> entries) {
  std::erase_if(entries, [](const DccEntry& entry) { return !std::isfinite(entry.value); });
  return entries;
}

DccResult deviations(const Identification& result) {
  return {
      "Deviations of the readings",
      "Of the same readings that the parameters were identified from. New readings may be further off.",
      finite({plain_entry("rms before", result.before.overall.rms), plain_entry("rms after", result.after.overall.rms),
              plain_entry("largest before", result.before.overall.maximum),
              plain_entry("largest after", result.after.overall.maximum)})};
}

DccResult lengths(const Identification& result) {
  DccResult section{"Errors of certified lengths, measured minus certified", "With the identified arm.", {}};
  for (const LengthDeviation& length : result.after.lengths) {
    section.entries.push_back(plain_entry(fmt::format("{}, placement {}: {} to {}", length.first.artefact,
                                                      length.first.placement, length.first.feature, length.second),
                                          length.error));
  }
  return section;
}

std::vector<std::string> statements_of(const Recording& recording, const Constraints& constraints,
                                       const Identification& result) {
  std::vector<std::string> statements;
  for (const InputFile& input : recording.inputs) {
    statements.push_back(fmt::format("Input with the SHA-256 {}: {}", input.sha256, input.path));
  }
  for (const Artefact& artefact : constraints.artefacts) {
    statements.push_back("Artefact: " + artefact_in_words(artefact));
  }
  for (const ParameterMotion& motion : result.coupling.unidentifiable) {
    statements.push_back("The readings cannot determine everything: " +
                         unidentifiable_in_words(result.coupling, motion));
  }
  for (const std::string& warning : result.warnings) {
    statements.push_back("Warning: " + warning);
  }
  return statements;
}

std::string unmodelled_text(const CrossValidation& found) {
  if (found.scale > 1.0) {
    return fmt::format(
        "; unmodelled error: enlarged by the factor {:.3g}, because {} placements left out showed errors of {:.3g} "
        "standard uncertainties (rms)",
        found.scale, found.placements, found.ratio);
  }
  return found.placements > 0
             ? fmt::format("; {} placements left out agree with them (errors of {:.2g} standard uncertainties, rms)",
                           found.placements, found.ratio)
             : std::string("; they take the model as true, which no placement left out could test");
}

DccMethod method_of(const Recording& recording, const Identification& result) {
  return {
      "Identification of kinematic parameters",
      fmt::format("Weighted least squares on {} readings on calibrated artefacts ({} Denavit-Hartenberg convention). "
                  "Noise of a reading {} mm a coordinate, {}; chi-squared {} with {} degrees of freedom. Standard "
                  "uncertainties by linear propagation{}.",
                  recording.readings.size(), recording.arm.convention == Convention::Standard ? "standard" : "modified",
                  result.noise, result.noise_is_given ? "as stated" : "estimated from the residuals",
                  result.chi_squared, result.degrees_of_freedom, unmodelled_text(result.cross_validation))};
}

}  // namespace

DccDocument dcc_of(const Recording& recording, const Constraints& constraints, const Identification& result,
                   const DccData& data) {
  DccDocument document{
      data, program_version, statements_of(recording, constraints, result), {method_of(recording, result)}, {}};
  for (DccResult& section :
       std::array{identified_parameters(result), kept_parameters(result), deviations(result), lengths(result)}) {
    if (!section.entries.empty()) {
      document.results.push_back(std::move(section));
    }
  }
  return document;
}

}  // namespace artcal
