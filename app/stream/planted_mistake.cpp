#include "app/stream/planted_mistake.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "acquisition/arm/forward_kinematics.h"
#include "artefacts/virtual_probing/postures.h"
#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

using Kind = PlantedMistake::Kind;

// "2,3" or "4,30.5" as numbers; nothing where it is not `count` of them.
std::optional<std::vector<double>> numbers(std::string text, std::size_t count) {
  std::vector<double> all;
  while (!text.empty()) {
    std::size_t used = 0;
    try {
      all.push_back(std::stod(text, &used));
    } catch (const std::exception&) {
      return std::nullopt;
    }
    if (used < text.size() && text[used] != ',') {
      return std::nullopt;
    }
    text.erase(0, used + 1);
  }
  return all.size() == count ? std::optional(std::move(all)) : std::nullopt;
}

Eigen::Vector3d tip_of(const Simulation& simulation, int reading) {
  const Eigen::VectorXd q = simulation.recording.joints.col(reading);
  const std::span<const double> joints(q.data(), static_cast<std::size_t>(q.size()));
  std::vector<double> sines(2 * joints.size());
  joint_sines(joints, sines);
  const Reading& at = simulation.recording.readings[static_cast<std::size_t>(reading)];
  return ForwardKinematics(simulation.arm.arm, {}, at.probe).tip_in_base({sines, joints, at.arm_temperature});
}

// Takes these readings again with their tips moved; false, and nothing is changed, where one is not reached.
template <typename Motion>
bool retake(const std::vector<int>& readings, const Motion& motion, Simulation& simulation) {
  std::vector<Eigen::VectorXd> again;
  for (const int reading : readings) {
    const Reading& at = simulation.recording.readings[static_cast<std::size_t>(reading)];
    const auto q = reach_with_joints(simulation.arm.arm, at.probe, motion(tip_of(simulation, reading)),
                                     simulation.recording.joints.col(reading), at.arm_temperature);
    if (!q) {
      return false;
    }
    again.push_back(*q);
  }
  for (std::size_t i = 0; i < readings.size(); ++i) {
    simulation.recording.joints.col(readings[i]) = again[i];
  }
  return true;
}

std::vector<int> readings_of(const Recording& recording, int placement, std::optional<int> feature = {}) {
  std::vector<int> all;
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    const Reading& reading = recording.readings[i];
    if (reading.placement == placement && (!feature || reading.feature == *feature)) {
      all.push_back(static_cast<int>(i));
    }
  }
  return all;
}

// Placements from the middle one on, then those before it.
std::vector<int> from_the_middle(const Recording& recording) {
  std::vector<int> all;
  for (int i = 0; i < recording.placements.size(); ++i) {
    all.push_back((recording.placements.size() / 2 + i) % recording.placements.size());
  }
  return all;
}

bool move_artefact(double by, Simulation& simulation) {
  for (const int placement : from_the_middle(simulation.recording)) {
    std::vector<int> readings = readings_of(simulation.recording, placement);
    readings.erase(readings.begin(), readings.begin() + static_cast<std::ptrdiff_t>(readings.size() / 2));
    if (readings.empty()) {
      continue;
    }
    const Eigen::Vector3d about = tip_of(simulation, readings.front());
    const Eigen::AngleAxisd turned(0.01, Eigen::Vector3d(1.0, 2.0, 3.0).normalized());
    const Eigen::Vector3d shift = by * Eigen::Vector3d(2.0, -1.0, 1.0).normalized();
    const auto motion = [&](const Eigen::Vector3d& tip) {
      return Eigen::Vector3d(about + turned * (tip - about) + shift);
    };
    if (retake(readings, motion, simulation)) {
      return true;
    }
  }
  return false;
}

// Each ball's touches are tried on each other ball of the artefact.
bool take_wrong_feature(const std::vector<PlannedArtefact>& artefacts, Simulation& simulation) {
  const Recording& recording = simulation.recording;
  for (const int placement : from_the_middle(recording)) {
    const auto real = std::find_if(simulation.placements.begin(), simulation.placements.end(), [&](const auto& known) {
      return known.name == recording.placements.name(placement);
    });
    const auto& balls = simulation.artefacts[static_cast<std::size_t>(real->artefact)].features;
    for (std::size_t ball = 0; ball < balls.size(); ++ball) {
      const std::string& name = artefacts[static_cast<std::size_t>(real->artefact)].certified.features[ball].name;
      const std::vector<int> readings = readings_of(recording, placement, recording.features.find(name));
      for (std::size_t other = 0; other < balls.size() && !readings.empty(); ++other) {
        const Eigen::Vector3d step = real->base_from_artefact.rotation * (balls[other].at - balls[ball].at);
        const auto motion = [&](const Eigen::Vector3d& tip) { return Eigen::Vector3d(tip + step); };
        if (other != ball && retake(readings, motion, simulation)) {
          return true;
        }
      }
    }
  }
  return false;
}

}  // namespace

Expected<PlantedMistake> parse_mistake(const std::string& text, int joints) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string kind = text.substr(0, colon);
  const std::string rest = colon < text.size() ? text.substr(colon + 1) : "";
  const auto joint = [&](double number) {
    return number >= 1.0 && number <= joints && number == std::floor(number) ? static_cast<int>(number) - 1 : -1;
  };
  if (const auto read = numbers(rest, 2);
      kind == "joints" && read && joint((*read)[0]) >= 0 && joint((*read)[1]) >= 0) {
    return PlantedMistake{Kind::JointsExchanged, joint((*read)[0]), joint((*read)[1]), 0.0};
  }
  if (const auto read = numbers(rest, 1); kind == "sign" && read && joint((*read)[0]) >= 0) {
    return PlantedMistake{Kind::JointSign, joint((*read)[0]), 0, 0.0};
  }
  if (const auto read = numbers(rest, 2);
      kind == "slip" && read && joint((*read)[0]) >= 0 && std::isfinite((*read)[1])) {
    return PlantedMistake{Kind::EncoderSlipped, joint((*read)[0]), 0, (*read)[1] * units::degree};
  }
  if (const auto read = numbers(rest, 1); kind == "moved" && read && std::isfinite((*read)[0])) {
    return PlantedMistake{Kind::ArtefactMoved, 0, 0, (*read)[0]};
  }
  if (text == "wrong-feature") {
    return PlantedMistake{Kind::WrongFeature, 0, 0, 0.0};
  }
  return wrong_usage(
      fmt::format("--mistake is {}, expected joints:2,3 or sign:3 or slip:4,30 (deg) or moved:12 (mm) or "
                  "wrong-feature, joints from 1 to {}",
                  in_quotes(text), joints));
}

Expected<void> plant(const PlantedMistake& mistake, const SimulationPlan& plan, Simulation& simulation) {
  bool is_planted = true;
  Eigen::MatrixXd& joints = simulation.recording.joints;
  switch (mistake.kind) {
    case Kind::EncoderSlipped: joints.row(mistake.first).tail(joints.cols() / 2).array() += mistake.size; break;
    case Kind::ArtefactMoved: is_planted = move_artefact(mistake.size, simulation); break;
    case Kind::WrongFeature: is_planted = take_wrong_feature(plan.artefacts, simulation); break;
    case Kind::JointsExchanged:
    case Kind::JointSign: break;
  }
  return is_planted
             ? Expected<void>()
             : wrong_usage("the mistake cannot be planted: no placement has readings that the arm reaches with it");
}

Eigen::VectorXd handed_on(const std::vector<PlantedMistake>& mistakes, Eigen::VectorXd joints) {
  for (const PlantedMistake& mistake : mistakes) {
    if (mistake.kind == Kind::JointsExchanged) {
      std::swap(joints[mistake.first], joints[mistake.second]);
    } else if (mistake.kind == Kind::JointSign) {
      joints[mistake.first] *= -1.0;
    }
  }
  return joints;
}

}  // namespace artcal
