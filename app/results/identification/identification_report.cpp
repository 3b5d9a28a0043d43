#include "app/results/identification/identification_report.h"

#include "app/output/output.h"
#include "app/report/report.h"
#include "app/results/identification/identified_arm.h"
#include "app/results/uncertainty/uncertainty_result.h"

namespace artcal {
namespace {

nlohmann::ordered_json expected_uncertainty(const Recording& recording, const IdentifyOptions& options,
                                            const Identification& result) {
  const UncertaintySources sources = uncertainty_sources(result.arm, arm_identification(recording, options, result));
  const VolumeSampling sampling;
  const UncertainArm arm(result.arm, sources);
  ArmIdentification known;
  known.unmodelled = result.cross_validation.scale;
  return to_json(
      SurveyResult{{result.arm, known, recording.inputs.front()}, sources, 0, sampling, survey(arm, sampling)});
}

}  // namespace

Expected<void> write_identification_report(const std::string& path, const nlohmann::ordered_json& json,
                                           const Recording& recording, const IdentifyOptions& options,
                                           const Identification& result) {
  if (path.empty()) {
    return {};
  }
  std::vector<ReportedResult> results{reported(json)};
  if (!result.free.empty()) {
    results.push_back(reported(expected_uncertainty(recording, options, result)));
  }
  return report_html(results).and_then([&](const std::string& page) { return write_file(path, page); });
}

}  // namespace artcal
