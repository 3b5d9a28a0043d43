#include "acquisition/recording/tip_centres.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "acquisition/arm/forward_kinematics.h"
#include "acquisition/arm/parameters.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

bool is_identified(const Arm& arm, int probe, const ArmIdentification* identification) {
  if (identification == nullptr) {
    return false;
  }
  const auto parameters = all_parameters(arm);
  return std::any_of(identification->parameters.begin(), identification->parameters.end(), [&](const auto& name) {
    const int found = find_parameter(parameters, name);
    return found >= 0 && parameters[static_cast<std::size_t>(found)].kind == ParameterKind::Radius &&
           parameters[static_cast<std::size_t>(found)].owner == probe;
  });
}

// Where the recording's probes are among those of `arm`.
Expected<std::vector<int>> probes_in(const Recording& recording, const Arm& arm,
                                     const ArmIdentification* identification) {
  std::vector<int> found;
  for (const Probe& probe : recording.arm.probes) {
    const int index = probe_index(arm, probe.name);
    if (index < 0) {
      return bad_input(fmt::format("the arm {} has no probe {}, which the recording was made with", in_quotes(arm.name),
                                   in_quotes(probe.name)));
    }
    if (arm.probes[index].radius != probe.radius && !is_identified(arm, index, identification)) {
      return bad_input(
          fmt::format("the probe {} has a tip of radius {} mm in the recording's arm and of {} mm in the "
                      "arm {}, where it was not identified; one of them is wrong",
                      in_quotes(probe.name), probe.radius, arm.probes[index].radius, in_quotes(arm.name)));
    }
    found.push_back(index);
  }
  return found;
}

}  // namespace

Expected<void> require_joints(const Recording& recording) {
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    if (recording.joints.rows() == 0 || !recording.joints.col(static_cast<Eigen::Index>(i)).allFinite()) {
      return bad_input(
          "the reading has coordinates but no joint angles; without q1, q2, … no arm can be identified or used",
          recording.where(static_cast<int>(i)));
    }
  }
  return {};
}

Expected<void> require_arm_temperatures(const Recording& recording) {
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    if (!std::isfinite(recording.readings[i].arm_temperature)) {
      return bad_input(
          "the arm's lengths depend on its temperature, and the reading does not say it; expected the column "
          "arm_temperature in degC (that of the artefact is not taken for it)",
          recording.where(static_cast<int>(i)));
    }
  }
  return {};
}

double tip_radius(const Recording& recording, int reading, const Arm& arm) {
  const Probe& probe =
      recording.arm.probes[static_cast<std::size_t>(recording.readings[static_cast<std::size_t>(reading)].probe)];
  const int index = probe_index(arm, probe.name);
  return index < 0 ? probe.radius : arm.probes[static_cast<std::size_t>(index)].radius;
}

Expected<TipCentres> tip_centres(const Recording& recording, const Arm& arm, const ArmIdentification* identification) {
  if (auto there = require_joints(recording); !there) {
    return tl::unexpected(there.error());
  }
  if (arm.joints.size() != recording.arm.joints.size()) {
    return bad_input(fmt::format("the arm {} has {} joints and the recording's has {}; is it the right arm?",
                                 in_quotes(arm.name), arm.joints.size(), recording.arm.joints.size()));
  }
  if (expands(arm)) {
    if (auto there = require_arm_temperatures(recording); !there) {
      return tl::unexpected(there.error());
    }
  }
  const auto probes = probes_in(recording, arm, identification);
  if (!probes) {
    return tl::unexpected(probes.error());
  }
  std::vector<ForwardKinematics> kinematics_by_probe;
  for (const int probe : *probes) {
    kinematics_by_probe.emplace_back(arm, std::vector<Parameter>{}, probe);
  }
  TipCentres tips;
  tips.in_base.resize(3, recording.joints.cols());
  const auto joints = static_cast<std::size_t>(recording.joints.rows());
  std::vector<double> sines(2 * joints);
  for (Eigen::Index i = 0; i < recording.joints.cols(); ++i) {
    const std::span<const double> q(recording.joints.col(i).data(), joints);
    joint_sines(q, sines);
    const Reading& reading = recording.readings[static_cast<std::size_t>(i)];
    tips.in_base.col(i) = kinematics_by_probe[reading.probe].tip_in_base({sines, q, reading.arm_temperature});
  }
  return tips;
}

Expected<TipCentres> tip_centres(const Recording& recording) {
  const auto& readings = recording.readings;
  const bool reported =
      std::all_of(readings.begin(), readings.end(), [](const Reading& reading) { return reading.tip.allFinite(); });
  if (!reported) {
    return tip_centres(recording, recording.arm);
  }
  TipCentres tips{Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(readings.size())), TipSource::Reported};
  for (std::size_t i = 0; i < readings.size(); ++i) {
    tips.in_base.col(static_cast<Eigen::Index>(i)) = readings[i].tip;
  }
  return tips;
}

}  // namespace artcal
