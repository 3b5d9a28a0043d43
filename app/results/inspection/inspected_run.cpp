#include "app/results/inspection/inspected_run.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/recording/tip_centres.h"
#include "app/output/phrases.h"
#include "app/results/identification/identification_run.h"
#include "artefacts/constraints/coincident_readings.h"
#include "identification/evaluation/judgement.h"
#include "identification/inspection/explanation.h"

namespace artcal {
namespace {

constexpr double large_residuals = 0.15;    // mm a coordinate
constexpr double gross_verification = 0.3;  // mm
constexpr std::string_view implausible = " [plausible_values]";

// Rows that the reading of the file left out come first.
Findings with_repeated_rows(const std::vector<std::string>& warnings, Findings&& findings) {
  Findings all;
  for (const std::string& warning : warnings) {
    if (is_coincidence_warning(warning)) {
      all.push_back({FindingKind::RepeatedReadings, "", warning});
    }
  }
  all.insert(all.end(), std::make_move_iterator(findings.begin()), std::make_move_iterator(findings.end()));
  return all;
}

std::vector<std::string> take_coincidence_warnings(Recording& recording) {
  const auto others =
      std::stable_partition(recording.warnings.begin(), recording.warnings.end(),
                            [](const std::string& warning) { return !is_coincidence_warning(warning); });
  std::vector<std::string> taken(std::make_move_iterator(others), std::make_move_iterator(recording.warnings.end()));
  recording.warnings.erase(others, recording.warnings.end());
  return taken;
}

AsWritten as_written_of(const Recording& recording, const Identification& result) {
  const double ratio =
      result.noise_is_given ? std::sqrt(result.chi_squared / std::max(1, result.degrees_of_freedom)) : 1.0;
  const bool misfit = !result.misfits.empty();
  return {result.noise * ratio, misfit, result.arm, misfit && is_another_arm(recording.arm, result.arm),
          misfit ? result.misfits.front() : ""};
}

// What the readings as written are refused for, without advice in general.
std::string reasons_of(const Error& error) {
  std::string reasons = error.message.substr(0, error.message.find("; --accept-misfit"));
  if (const auto advice = reasons.find(general_advice); advice != std::string::npos) {
    reasons.resize(advice);
  }
  while (reasons.ends_with(' ') || reasons.ends_with('.')) {
    reasons.pop_back();
  }
  return reasons;
}

// Where the mistake is named, the first of them is enough, with what looks wrong in the input.
std::string first_reason_of(const Error& error) {
  constexpr std::string_view opening = "no arm fits these readings: ";
  const std::string reasons = reasons_of(error);
  const std::size_t begin = reasons.starts_with(opening) ? opening.size() : 0;
  const std::size_t end = std::min(reasons.find("; ", begin), reasons.size());
  const std::size_t warnings = std::min(reasons.find("; warning: ", end), reasons.size());
  return reasons.substr(begin, end - begin) + reasons.substr(warnings);
}

constexpr std::string_view accept = "; --accept-misfit writes the arm all the same";

Error explained_error(const Findings& mistakes, const std::optional<Error>& as_written) {
  std::string text;
  for (const Finding& finding : mistakes) {
    text += (text.empty() ? "" : ". Then: ") + finding.sentence();
  }
  return {ErrorCode::NoSolution,
          fmt::format("no arm fits these readings as they are written: {}{}{}", text,
                      as_written ? ". As written: " + first_reason_of(*as_written) : "", accept),
          {}};
}

Error unexplained_error(const Error& as_written, const std::vector<std::string>& excluded) {
  return {ErrorCode::NoSolution,
          fmt::format("{}. No single mistake explains it; looked for in vain: {}. --model auto searches for unmodelled "
                      "errors{}",
                      reasons_of(as_written), fmt::join(excluded, "; "), accept),
          {}};
}

bool is_told(const std::vector<std::string>& warnings, const Finding& finding) {
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const std::string& warning) { return warning == finding.text; });
}

}  // namespace

Inspection inspected(Recording& recording, const Constraints& constraints, const IdentifyOptions* options) {
  Inspection inspection =
      options != nullptr ? inspect(recording, constraints, *options) : inspect_recording(recording, constraints);
  inspection.findings = with_repeated_rows(take_coincidence_warnings(recording), std::move(inspection.findings));
  return inspection;
}

InspectedIdentification run_inspected(const Recording& recording, const Constraints& constraints,
                                      const IdentifyOptions& options) {
  InspectedIdentification run{
      run_identification(recording, constraints, options),
      with_repeated_rows(recording.warnings, find_mistakes_without_fit(recording, constraints))};
  Findings& findings = run.findings;
  const bool failed = !run.result;
  if (failed && (run.result.error().code != ErrorCode::NoSolution || !is_misfit(run.result.error()))) {
    return run;
  }
  const AsWritten as_written =
      failed ? fit_as_written(recording, constraints, options) : as_written_of(recording, *run.result);
  // Real arms without a stated noise leave a tenth of a millimetre: all but radii is left to inspect then.
  const bool is_large = options.noise.is_given() || as_written.size > large_residuals;
  if (failed || is_unexplained(as_written, recording, options)) {
    Explanation explanation = failed || is_large ? explain(recording, constraints, options, as_written)
                                                 : explain_by_radii(recording, constraints, options, as_written);
    if (!explanation.findings.empty()) {
      add_explanation(findings, explanation.findings);
      if (!options.accept_misfit || failed) {
        const auto error = failed ? std::optional(run.result.error()) : std::nullopt;
        run.result = tl::unexpected(explained_error(explanation.findings, error));
      }
    } else if (failed) {
      run.result = tl::unexpected(unexplained_error(run.result.error(), explanation.excluded));
    }
  }
  if (run.result) {
    if (run.result->misfits.empty()) {
      const Findings more = find_undetermined_centres(recording, constraints, run.result->arm);
      findings.insert(findings.end(), more.begin(), more.end());
    }
    for (const Finding& finding : findings) {
      if (!is_told(run.result->warnings, finding)) {
        run.result->warnings.push_back(finding.sentence());
      }
    }
  }
  return run;
}

Findings findings_for_verification(Recording& recording, const Constraints& constraints, const Arm& arm) {
  const bool by_joints = !arm.joints.empty() && require_joints(recording);
  const auto evaluation = by_joints ? evaluate(recording, constraints, arm) : tl::unexpected(Error{});
  if (evaluation && evaluation->overall.rms > gross_verification) {
    const IdentifyOptions options = recorded_options(recording);
    return inspected(recording, constraints, &options).findings;
  }
  return with_repeated_rows(take_coincidence_warnings(recording), find_mistakes_without_fit(recording, constraints));
}

Findings findings_of_verification(const std::vector<std::string>& missing) {
  Findings findings;
  for (const std::string& text : missing) {
    if (text.ends_with(implausible)) {
      findings.push_back({FindingKind::ImplausibleValue, "", text.substr(0, text.size() - implausible.size())});
    }
  }
  return findings;
}

}  // namespace artcal
