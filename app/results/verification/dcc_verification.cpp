#include "app/results/verification/dcc_verification.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "app/results/artefact_summary.h"
#include "app/results/dcc_terms.h"
#include "app/version.h"
#include "core/statistics.h"

namespace artcal {
namespace {

constexpr const char* one = "\\one";

// Of values whose degrees of freedom are many; of others it is stated_coverage_factor().
constexpr double k = 2.0;

// A certificate states no uncertainty of zero: it means that none is known.
std::optional<DccUncertainty> expanded(double u, double factor = k) {
  return u > 0.0 ? std::optional(DccUncertainty{factor * u, factor, dcc_probability}) : std::nullopt;
}

DccEntry length_entry(const std::string& name, double value, double u = 0.0, double factor = k) {
  return {name, "", dcc_millimetre, value, expanded(u, factor), std::nullopt, ""};
}

std::optional<DccConformity> conformity_of(const TestValue& value) {
  switch (value.verdict) {
    case Verdict::ConformityProven: return DccConformity::Pass;
    case Verdict::NonConformityProven: return DccConformity::Fail;
    case Verdict::NeitherProven: return DccConformity::NotShown;
    case Verdict::NotJudged: break;
  }
  return std::nullopt;
}

DccEntry value_entry(const TestValue& value, DecisionRule rule) {
  DccEntry entry = length_entry(label_of(value), value.value, value.budget.total(),
                                stated_coverage_factor(value.budget.degrees_of_freedom()));
  entry.ref_type = "artcal_testValue";
  if (value.set_aside) {
    entry.name += " (set aside: measured again under the outlier rule)";
  } else if (value.limit) {
    entry.conformity = conformity_of(value);
    entry.limit = fmt::format("limit {} mm; {}: {}", *value.limit, text_of(rule), text_of(value.verdict));
  }
  return entry;
}

std::vector<DccResult> test_values(const Verification& verification) {
  std::map<Quantity, DccResult> sections;
  for (const TestValue& value : verification.values) {
    DccResult& section = sections[value.quantity];
    section.name = name_of(value.quantity);
    section.description =
        "U is that of the test value, expanded with the k that is stated with it; of the arm's scatter it has what "
        "the touches leave open about centres and diameters.";
    section.entries.push_back(value_entry(value, verification.rule));
  }
  std::vector<DccResult> all;
  for (auto& [quantity, section] : sections) {
    all.push_back(std::move(section));
  }
  return all;
}

DccResult plate_section(const PlatePlacement& plate) {
  DccResult section{fmt::format("Plate {}, placement {}{}", plate.artefact, plate.placement,
                                plate.repeat.empty() ? "" : ", repeat " + plate.repeat),
                    "Measured less certified, in the plate's axes after a rigid motion; scale: measured over "
                    "certified, less one.",
                    {{"scale", "", one, plate.scale, expanded(plate.u_scale, plate.k_scale), std::nullopt, ""},
                     length_entry("rms of the residuals", plate.rms)}};
  for (const BallResidual& ball : plate.balls) {
    for (int axis = 0; axis < 3; ++axis) {
      section.entries.push_back(
          length_entry(fmt::format("{}, residual {}", ball.feature, "xyz"[axis]), ball.residual_in_plate[axis]));
    }
  }
  return section;
}

DccResult calibration_section(const PlateCalibration& calibration) {
  DccResult section{
      fmt::format("The plate {} itself", calibration.artefact),
      fmt::format("Coordinates from {} placements, U by their scatter ({:.3g} degrees of freedom); the scale "
                  "is the arm's.",
                  calibration.placements, calibration.degrees_of_freedom),
      {}};
  for (Eigen::Index i = 0; i < calibration.centres.cols(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      section.entries.push_back(length_entry(
          fmt::format("{}, {}", calibration.features[static_cast<std::size_t>(i)], "xyz"[axis]),
          calibration.centres(axis, i), calibration.u(i), stated_coverage_factor(calibration.degrees_of_freedom)));
    }
  }
  return section;
}

DccResult drift_section(const InterimCheck& check) {
  DccResult section{"Drift since an earlier verification", "Now less then.", {}};
  for (const Drift& drift : check.drifts) {
    section.entries.push_back(
        length_entry(fmt::format("{} {}{}, placement {}{}", name_of(drift.quantity), drift.first,
                                 drift.second.empty() ? "" : " - " + drift.second, drift.placement,
                                 drift.significant ? " (significant)" : ""),
                     drift.drift, drift.degrees_of_freedom > 0 ? drift.u : 0.0,
                     drift.degrees_of_freedom > 0 ? stated_coverage_factor(drift.effective_degrees_of_freedom) : k));
  }
  return section;
}

std::vector<std::string> statements_of(const Session& session, const VerificationResult& result) {
  const Verification& verification = result.verification;
  std::vector<std::string> statements{fmt::format(
      "{} by {}. The quantities are those that the standard names; no conformity to its clauses is claimed.",
      text_of(verification.conclusion), verification.standard)};
  for (const std::string& missing : verification.missing) {
    statements.push_back("Missing for a proof of conformity: " + missing);
  }
  for (const std::string& waived : verification.waived) {
    statements.push_back("Waived by the specification: " + waived);
  }
  for (const InputFile& input : session.recording.inputs) {
    statements.push_back(fmt::format("Input with the SHA-256 {}: {}", input.sha256, input.path));
  }
  for (const Artefact& artefact : session.constraints.artefacts) {
    statements.push_back("Artefact: " + artefact_in_words(artefact));
  }
  for (const std::string& warning : verification.warnings) {
    statements.push_back("Warning: " + warning);
  }
  return statements;
}

DccMethod method_of(const Session& session, const Verification& verification) {
  const auto& [recording, constraints, arm, tips, specification, identification] = session;
  return {"Verification of an articulated arm",
          fmt::format("{}: {} readings on calibrated artefacts, {}. Arm: {}. Specification: {}. Decision rule: {}.",
                      verification.standard, recording.readings.size(),
                      tips.source == TipSource::Reported ? "coordinates as the arm's own software reported them"
                                                         : "coordinates from joint angles",
                      arm.name.empty() ? "not named" : arm.name,
                      specification.name.empty() ? "none" : specification.name, text_of(verification.rule))};
}

}  // namespace

DccDocument dcc_of(const Session& session, const VerificationResult& result, const DccData& data) {
  DccDocument document{data,
                       program_version,
                       statements_of(session, result),
                       {method_of(session, result.verification)},
                       test_values(result.verification)};
  for (const PlatePlacement& plate : result.plates) {
    document.results.push_back(plate_section(plate));
  }
  for (const PlateCalibration& calibration : result.calibrations) {
    document.results.push_back(calibration_section(calibration));
  }
  if (result.interim && !result.interim->drifts.empty()) {
    document.results.push_back(drift_section(*result.interim));
  }
  return document;
}

}  // namespace artcal
