#include "identification/inspection/inspection.h"

#include <cmath>

#include <fmt/format.h>

#include "acquisition/recording/tip_centres.h"
#include "core/units.h"
#include "identification/inspection/ball_touches.h"
#include "identification/inspection/documents.h"
#include "identification/inspection/explanation.h"
#include "identification/inspection/repeated_postures.h"

namespace artcal {
namespace {

constexpr double max_offset = 10.0 * units::degree;

void append(Findings& findings, Findings&& more) {
  findings.insert(findings.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

Finding no_arm_fits(const AsWritten& as_written) {
  return {FindingKind::NoArmFits, "",
          fmt::format("no arm fits these readings ({}); see the mistakes that were looked for in vain, and look at the "
                      "names of features, the certified values and the arm's file",
                      std::isfinite(as_written.size) ? as_written.reason : "no fit converges to an arm")};
}

}  // namespace

Findings find_offsets(const Recording& recording, const Arm& identified) {
  Findings findings;
  for (std::size_t j = 0; j < identified.joints.size(); ++j) {
    const double moved = identified.joints[j].theta - recording.arm.joints[j].theta;
    if (std::abs(moved) > max_offset) {
      findings.push_back({FindingKind::JointOffset, "",
                          fmt::format("the zero of joint {} is {:+.1f} degrees from the arm's file. Correct theta of "
                                      "joint {} there, or the encoder's reference",
                                      j + 1, moved / units::degree, j + 1)});
    }
  }
  return findings;
}

Findings find_undetermined_centres(const Recording& recording, const Constraints& constraints, const Arm& arm) {
  const auto evaluation = evaluate(recording, constraints, arm);
  return evaluation ? find_undetermined_centres(recording, constraints, *evaluation) : Findings{};
}

Findings find_mistakes_without_fit(const Recording& recording, const Constraints& constraints) {
  Findings findings = find_repeated_postures(recording);
  append(findings, find_wrong_documents(recording, constraints.artefacts));
  return findings;
}

Inspection inspect_recording(const Recording& recording, const Constraints& constraints) {
  Inspection inspection;
  inspection.findings = find_mistakes_without_fit(recording, constraints);
  append(inspection.remarks, find_missing_documents(recording, constraints.artefacts));
  if (require_joints(recording)) {
    inspection.usage = usage_of(recording);
    append(inspection.remarks, find_one_sided_placements(recording, inspection.usage));
  }
  return inspection;
}

Inspection inspect(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options) {
  Inspection inspection = inspect_recording(recording, constraints);
  if (!require_joints(recording)) {
    return inspection;
  }
  const AsWritten as_written = fit_as_written(recording, constraints, options);
  Explanation explanation = is_unexplained(as_written, recording, options)
                                ? explain(recording, constraints, options, as_written)
                                : Explanation{};
  inspection.is_gross_misfit = as_written.is_misfit || !explanation.findings.empty();
  if (!explanation.findings.empty()) {
    add_explanation(inspection.findings, std::move(explanation.findings));
  } else if (as_written.is_misfit) {
    inspection.findings.push_back(no_arm_fits(as_written));
    inspection.excluded = std::move(explanation.excluded);
  } else {
    // A wrong arm sees touches where they were not.
    const Arm& arm = as_written.arm ? *as_written.arm : recording.arm;
    append(inspection.findings, find_offsets(recording, arm));
    append(inspection.findings, find_undetermined_centres(recording, constraints, arm));
  }
  return inspection;
}

}  // namespace artcal
