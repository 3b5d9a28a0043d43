#include "app/results/planning/simulation_json.h"

#include "acquisition/arm/parameters.h"
#include "app/results/result_head.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

Json numbers(const Eigen::VectorXd& values) { return std::vector<double>(values.begin(), values.end()); }

Json rows(const Eigen::Matrix3d& matrix) {
  return {numbers(matrix.row(0)), numbers(matrix.row(1)), numbers(matrix.row(2))};
}

Json parameters_json(const Arm& nominal, const Arm& real) {
  Json json = Json::array();
  for (const Parameter& parameter : all_parameters(nominal)) {
    if (parameter.is_joint_error() && value(nominal, parameter) == 0.0 && value(real, parameter) == 0.0) {
      continue;
    }
    json.push_back({{"name", parameter.name},
                    {"unit", parameter.unit()},
                    {"nominal", value(nominal, parameter)},
                    {"true", value(real, parameter)}});
  }
  return json;
}

Json joint_json(const VirtualJoint& joint) {
  return {{"encoder_noise_rad", joint.encoder_noise},
          {"first_harmonic_rad", joint.eccentricity[0].amplitude},
          {"first_phase_rad", joint.eccentricity[0].phase},
          {"second_harmonic_rad", joint.eccentricity[1].amplitude},
          {"second_phase_rad", joint.eccentricity[1].phase},
          {"compliance_rad_per_Nmm", joint.compliance},
          {"mass_kg", joint.mass},
          {"stops_rad", {joint.low, joint.high}}};
}

Json feature_json(const CertifiedFeature& certified, const RealFeature& real) {
  Json json{{"name", certified.name}};
  if (certified.kind != FeatureKind::Coordinates) {
    json["at_mm"] = numbers(real.at);
  }
  if (certified.kind == FeatureKind::Plane) {
    json["normal"] = numbers(real.normal);
  }
  if (certified.kind == FeatureKind::Sphere) {
    json["radius_mm"] = real.radius;
  }
  return json;
}

Json artefact_json(const Artefact& certified, const RealArtefact& real) {
  Json features = Json::array();
  for (std::size_t i = 0; i < real.features.size(); ++i) {
    features.push_back(feature_json(certified.features[i], real.features[i]));
  }
  return {{"name", certified.name}, {"expansion_per_K", real.expansion}, {"features", features}};
}

Json placement_json(const RealPlacement& placement, const SimulationPlan& plan) {
  return {{"name", placement.name},
          {"artefact", plan.artefacts[placement.artefact].certified.name},
          {"rotation", rows(placement.base_from_artefact.rotation)},
          {"translation_mm", numbers(placement.base_from_artefact.translation)},
          {"temperature_C", placement.temperature},
          {"temperature_end_C", placement.temperature_end},
          {"readings", placement.readings}};
}

// Which rows of a scan, from 1, are on which feature.
Json scan_json(const SimulatedScan& scan, const Recording& recording) {
  Json features = Json::array();
  for (std::size_t i = 0; i < scan.readings.size(); ++i) {
    const Reading& reading = recording.readings[static_cast<std::size_t>(scan.readings[i])];
    const std::string& name = recording.features.name(reading.feature);
    if (features.empty() || features.back()["name"] != name) {
      features.push_back({{"name", name}, {"first_row", i + 1}, {"rows", 0}});
    }
    features.back()["rows"] = features.back()["rows"].get<int>() + 1;
  }
  return {{"file", scan.file},
          {"placement", recording.placements.name(scan.placement)},
          {"orientation", recording.orientations.name(scan.orientation)},
          {"repeat", recording.repeats.name(scan.repeat)},
          {"features", features}};
}

Json noise_json(const PlannedNoise& noise) {
  return {{"probing_mm", noise.probing},
          {"temperature_K", noise.temperature},
          {"instrument_mm", noise.instrument ? Json(*noise.instrument) : Json(nullptr)}};
}

}  // namespace

Json to_json(const PlanFile& file, const Simulation& simulation) {
  const SimulationPlan& plan = file.plan;
  Json json = result_head("simulation");
  json["recording"] = plan.name;
  json["arm"] = plan.nominal.name;
  json["inputs"] = inputs_json(file.inputs);
  json["seed"] = plan.seed;
  json["readings"] = simulation.recording.readings.size();
  json["noise"] = noise_json(plan.noise);
  json["gravity_m_s2"] = numbers(simulation.arm.arm.gravity_in_base);
  json["parameters"] = parameters_json(plan.nominal, simulation.arm.arm);
  json["joints"] = Json::array();
  for (const VirtualJoint& joint : simulation.arm.joints) {
    json["joints"].push_back(joint_json(joint));
  }
  json["artefacts"] = Json::array();
  for (std::size_t i = 0; i < simulation.artefacts.size(); ++i) {
    json["artefacts"].push_back(artefact_json(plan.artefacts[i].certified, simulation.artefacts[i]));
  }
  json["placements"] = Json::array();
  for (const RealPlacement& placement : simulation.placements) {
    json["placements"].push_back(placement_json(placement, plan));
  }
  json["scans"] = Json::array();
  for (const SimulatedScan& scan : simulation.scans) {
    json["scans"].push_back(scan_json(scan, simulation.recording));
  }
  return json;
}

}  // namespace artcal
