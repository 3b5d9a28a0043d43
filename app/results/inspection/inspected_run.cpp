#include "app/results/inspection/inspected_run.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/recording/tip_centres.h"
#include "app/output/phrases.h"
#include "app/requests/identify_request.h"
#include "app/results/identification/input_warnings.h"
#include "identification/inspection/ball_touches.h"
#include "identification/inspection/explanation.h"

namespace artcal {
namespace {

constexpr double large_residuals = 0.15;    // mm a coordinate
constexpr double gross_verification = 0.3;  // mm

// Readings that were left out when the recording was bound come first.
Findings with_repeated_readings(const Recording& recording, Findings&& findings) {
  Findings all;
  if (recording.repeated_readings) {
    all.push_back({FindingKind::RepeatedReadings, "", *recording.repeated_readings, true});
  }
  all.insert(all.end(), std::make_move_iterator(findings.begin()), std::make_move_iterator(findings.end()));
  return all;
}

// What is a finding is no warning beside it.
void take_repeated_readings(Recording& recording, Findings& findings) {
  findings = with_repeated_readings(recording, std::move(findings));
  if (recording.repeated_readings) {
    std::erase(recording.warnings, *recording.repeated_readings);
    recording.repeated_readings.reset();
  }
}

AsWritten as_written_of(const Recording& recording, const Identification& result) {
  const double ratio =
      result.noise_is_given ? std::sqrt(result.chi_squared / std::max(1, result.degrees_of_freedom)) : 1.0;
  const bool misfit = !result.misfits.empty();
  return {result.noise * ratio, misfit, result.arm, misfit && is_another_arm(recording.arm, result.arm),
          misfit ? result.misfits.front() : ""};
}

std::string without_full_stop(std::string text) {
  while (text.ends_with(' ') || text.ends_with('.')) {
    text.pop_back();
  }
  return text;
}

// What the readings as written are refused for, without advice in general.
std::string reasons_of(const Error& error) {
  return without_full_stop(error.found.empty() ? error.message : error.found);
}

// Where the mistake is named, the first of them is enough. The warnings of the input stand behind advice where there is
// any; otherwise they are a part of the reasons.
std::string first_reason_of(const Error& error, const std::vector<std::string>& warnings) {
  if (error.reason.empty()) {
    return reasons_of(error);
  }
  return error.found.empty() ? without_full_stop(with_warnings({error.code, error.reason, {}}, warnings).message)
                             : error.reason;
}

constexpr std::string_view accept = "; --accept-misfit writes the arm all the same";

// `reason` is why the readings as written are refused; empty where they are not.
Error explained_error(const Findings& mistakes, const std::string& reason) {
  std::string text;
  for (const Finding& finding : mistakes) {
    text += (text.empty() ? "" : ". Then: ") + finding.sentence();
  }
  return {ErrorCode::NoSolution,
          fmt::format("no arm fits these readings as they are written: {}{}{}", text,
                      reason.empty() ? "" : ". As written: " + reason, accept),
          {},
          ErrorKind::Misfit};
}

Error unexplained_error(const Error& as_written, const std::vector<std::string>& excluded) {
  return {ErrorCode::NoSolution,
          fmt::format("{}. No single mistake explains it; looked for in vain: {}. --model auto searches for unmodelled "
                      "errors{}",
                      reasons_of(as_written), fmt::join(excluded, "; "), accept),
          {},
          ErrorKind::Misfit};
}

}  // namespace

Inspection inspected(Recording& recording, const Constraints& constraints, const IdentifyOptions* options) {
  Inspection inspection =
      options != nullptr ? inspect(recording, constraints, *options) : inspect_recording(recording, constraints);
  take_repeated_readings(recording, inspection.findings);
  return inspection;
}

InspectedIdentification inspect_result(Expected<Identification> result, const Recording& recording,
                                       const Constraints& constraints, const IdentifyOptions& options) {
  InspectedIdentification run{with_input_warnings(std::move(result), recording, constraints),
                              with_repeated_readings(recording, find_mistakes_without_fit(recording, constraints))};
  Findings& findings = run.findings;
  const bool failed = !run.result;
  if (failed && !is_misfit(run.result.error())) {
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
        const std::string reason = failed ? first_reason_of(run.result.error(), recording.warnings) : "";
        run.result = tl::unexpected(explained_error(explanation.findings, reason));
      }
    } else if (failed) {
      run.result = tl::unexpected(unexplained_error(run.result.error(), explanation.excluded));
    }
  }
  if (run.result) {
    if (run.result->misfits.empty()) {
      const Findings more = find_undetermined_centres(recording, constraints, run.result->after);
      findings.insert(findings.end(), more.begin(), more.end());
    }
    for (const Finding& finding : findings) {
      if (!finding.is_input_warning) {
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
  Findings findings = find_mistakes_without_fit(recording, constraints);
  take_repeated_readings(recording, findings);
  return findings;
}

Findings findings_of_verification(const std::vector<MissingEvidence>& evidence) {
  Findings findings;
  for (const MissingEvidence& missing : evidence) {
    if (missing.evidence == Evidence::PlausibleValues && !missing.is_waived) {
      findings.push_back({FindingKind::ImplausibleValue, "", missing.text});
    }
  }
  return findings;
}

}  // namespace artcal
