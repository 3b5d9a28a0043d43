#include "app/results/fit/segment_result.h"
#include "app/results/result_head.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

Json vector_json(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json rows_json(const SegmentResult& result, const std::vector<int>& points) {
  Json rows = Json::array();
  for (const int point : points) {
    rows.push_back(result.rows[static_cast<std::size_t>(point)]);
  }
  return rows;
}

Json segment_options_json(const SegmentResult& result) {
  return {{"unit", result.unit},
          {"temperature_C", result.temperature},
          {"radius_is_fixed", result.options.fixed_radius},
          {"radius_tolerance", result.options.radius_tolerance},
          {"distance_tolerance_mm", result.segmentation.tolerance}};
}

Json sphere_json(const SegmentResult& result, std::size_t index, const FoundSphere& sphere) {
  Json json;
  json["name"] = sphere_name(result, index);
  json["centre_mm"] = vector_json(sphere.fitted.feature.centre);
  Json u = Json::array();
  for (int axis = 0; axis < 3; ++axis) {
    u.push_back(sphere.fitted.covariance ? std::sqrt((*sphere.fitted.covariance)(axis, axis)) : 0.0);
  }
  json["u_centre_mm"] = u;
  json["radius_mm"] = sphere.fitted.feature.radius;
  json["radius_seen_mm"] = sphere.seen_radius;
  json["u_radius_seen_mm"] = sphere.u_seen_radius;
  json["coverage"] = sphere.coverage;
  json["noise_mm"] = sphere.fitted.rms;
  json["form_mm"] = sphere.fitted.form;
  json["points_left_out_beside"] = sphere.left_out;
  json["rows"] = rows_json(result, sphere.points);
  return json;
}

Json plane_json(const SegmentResult& result, std::size_t index, const FoundPlane& plane) {
  return {{"name", plane_name(result, index)},
          {"point_mm", vector_json(plane.fitted.feature.point)},
          {"normal", vector_json(plane.fitted.feature.normal)},
          {"noise_mm", plane.fitted.rms},
          {"form_mm", plane.fitted.form},
          {"rows", rows_json(result, plane.points)}};
}

const char* reason_name(RejectionReason reason) {
  switch (reason) {
    case RejectionReason::TooFewPoints: return "too_few_points";
    case RejectionReason::TooLittleSeen: return "too_little_seen";
    case RejectionReason::WrongRadius: return "wrong_radius";
    case RejectionReason::NotASphere: return "not_a_sphere";
    case RejectionReason::Overlaps: return "overlaps";
    case RejectionReason::Stray: break;
  }
  return "stray";
}

Json rejected_json(const RejectedSphere& rejected) {
  return {{"centre_mm", vector_json(rejected.sphere.centre)},
          {"radius_mm", rejected.sphere.radius},
          {"points", rejected.points},
          {"reason", reason_name(rejected.reason)},
          {"text", rejected.why}};
}

}  // namespace

nlohmann::ordered_json to_json(const SegmentResult& result) {
  Json json = result_head("segmentation");
  json["artefact"] = result.artefact.name;
  json["inputs"] = inputs_json(result.inputs);
  json["seed"] = nullptr;
  json["options"] = segment_options_json(result);
  json["columns"] = result.columns;
  json["points"] = result.points;
  json["spheres"] = Json::array();
  for (std::size_t i = 0; i < result.segmentation.spheres.size(); ++i) {
    if (const auto& sphere = result.segmentation.spheres[i]) {
      json["spheres"].push_back(sphere_json(result, i, *sphere));
    }
  }
  json["planes"] = Json::array();
  for (std::size_t i = 0; i < result.segmentation.planes.size(); ++i) {
    json["planes"].push_back(plane_json(result, i, result.segmentation.planes[i]));
  }
  json["distances"] = Json::array();
  for (const SeenDistance& d : seen_distances(result)) {
    json["distances"].push_back({{"between",
                                  {sphere_name(result, static_cast<std::size_t>(d.first)),
                                   sphere_name(result, static_cast<std::size_t>(d.second))}},
                                 {"certified_mm", d.certified.value},
                                 {"certified_at_C", d.certified.temperature},
                                 {"at_temperature_mm", d.at_temperature},
                                 {"measured_mm", d.measured},
                                 {"error_mm", d.measured - d.at_temperature}});
  }
  json["missing"] = missing_names(result);
  json["rejected"] = Json::array();
  for (const RejectedSphere& rejected : result.segmentation.rejected) {
    json["rejected"].push_back(rejected_json(rejected));
  }
  json["warnings"] = result.warnings;
  return json;
}

}  // namespace artcal
