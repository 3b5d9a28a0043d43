#pragma once

#include <string>

#include <Eigen/Geometry>

#include "artefacts/simulation/plan/plan.h"
#include "core/units.h"
#include "tests/support/arms.h"

namespace artcal::testing {

inline CertifiedFeature certified(const std::string& name, FeatureKind kind) {
  CertifiedFeature feature;
  feature.name = name;
  feature.kind = kind;
  if (kind == FeatureKind::Sphere) feature.radius = 12.7;
  return feature;
}

/// Three features of one kind on a line, 250 and 600 mm from the first, without certified coordinates.
inline PlannedArtefact bar_of(FeatureKind kind) {
  PlannedArtefact bar;
  bar.certified.name = "bar";
  for (const char* name : {"A", "B", "C"}) bar.certified.features.push_back(certified(name, kind));
  bar.certified.distances = {{0, 1, 250.0, 4e-4}, {1, 2, 350.0, 4e-4}, {0, 2, 600.0, 4e-4}};
  bar.certified.expansion = 11.5e-6;
  bar.certified.expansion_is_known = true;
  bar.stated.resize(3);
  return bar;
}

/// The arm of Table 1 with a ball of 3 mm off its axis, on one bar at a stated place; without any noise or error.
inline SimulationPlan plan_for(PlannedArtefact artefact, int points = 25) {
  SimulationPlan plan;
  plan.name = "plan";
  plan.nominal = test::gao_arm();
  plan.nominal.probes[0].on_axis = false;
  plan.nominal.probes[0].tip_in_last = {3.0, -2.0, 183.5};
  plan.nominal.probes[0].radius = 3.0;
  plan.arm.arm = plan.nominal;
  plan.arm.joints.resize(6);
  PlannedPlacement placement;
  placement.name = "left";
  placement.base_from_artefact =
      Rigid{Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix(), {500.0, 300.0, 200.0}};
  plan.placements = {placement};
  PlannedProbing probing;
  for (std::size_t i = 0; i < artefact.certified.features.size(); ++i) probing.features.push_back(static_cast<int>(i));
  probing.placements = {0};
  probing.points = points;
  plan.probings = {probing};
  plan.artefacts = {std::move(artefact)};
  return plan;
}

/// Everything that makes an arm differ from a rigid chain, large enough to be noticed.
inline void spoil(VirtualArm& arm) {
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    VirtualJoint& joint = arm.joints[i];
    const double k = static_cast<double>(i + 1);
    joint.eccentricity = {{{(10.0 + k) * units::arcsecond, 0.3 * k}, {4.0 * units::arcsecond, -0.5 * k}}};
    joint.compliance = 2.0 * units::arcsecond / 1e3;
    joint.mass = 1.5 / k;
  }
}

}  // namespace artcal::testing
