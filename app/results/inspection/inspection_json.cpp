#include "app/results/inspection/inspection_json.h"

#include <set>

#include "app/output/json_list.h"
#include "app/results/artefact_summary.h"
#include "app/results/identification/result_json.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

Json usage_json(const Usage& usage) {
  if (usage.joints.empty()) {
    return nullptr;
  }
  return {
      {"joints",
       json_list(usage.joints,
                 [](const Usage::JointRange& joint) -> Json {
                   return {{"lowest_rad", joint.lowest}, {"highest_rad", joint.highest}, {"covered", joint.covered}};
                 })},
      {"volume_share", usage.volume_share},
      {"nearest_share_of_reach", usage.nearest},
      {"farthest_share_of_reach", usage.farthest},
      {"orientation_share", usage.orientation_share},
      {"placements_elbow_left", usage.placements_left},
      {"placements_elbow_right", usage.placements_right},
      {"placements_elbow_both", usage.placements_both}};
}

}  // namespace

Json findings_json(const Findings& findings) {
  return json_list(findings, [](const Finding& finding) -> Json {
    return {{"kind", name_of(finding.kind)},
            {"where", finding.where.empty() ? Json(nullptr) : Json(finding.where)},
            {"text", finding.text}};
  });
}

Json to_json(const Recording& recording, const Constraints& constraints, const Inspection& inspection) {
  std::set<int> placements;
  for (const Reading& reading : recording.readings) {
    placements.insert(reading.placement);
  }
  Json json = result_header(recording, "inspection", std::nullopt);
  json["date"] = recording.date.empty() ? Json(nullptr) : Json(recording.date);
  json["counts"] = {{"readings", recording.readings.size()},
                    {"features", constraints.features.size()},
                    {"placements", placements.size()},
                    {"artefacts", constraints.artefacts.size()}};
  json["artefacts"] = artefacts_json(constraints.artefacts);
  json["findings"] = findings_json(inspection.findings);
  json["remarks"] = findings_json(inspection.remarks);
  json["excluded"] = inspection.excluded;
  json["usage"] = usage_json(inspection.usage);
  json["warnings"] = recording.warnings;
  return json;
}

}  // namespace artcal
