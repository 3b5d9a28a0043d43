#include "identification/uncertainty/working_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "artefacts/simulation/pattern.h"
#include "artefacts/virtual_probing/postures.h"
#include "core/random.h"

namespace artcal {
namespace {

std::optional<UncertainTip> tip_at(const UncertainArm& arm, const Eigen::Vector3d& place_in_base,
                                   RandomStream& random) {
  const auto q = inverse_kinematics(arm.arm(), arm.probe(), place_in_base, random);
  return q ? std::optional(arm.tip(*q)) : std::nullopt;
}

SpreadOfU spread_of(std::vector<double> values) {
  SpreadOfU spread;
  spread.count = static_cast<int>(values.size());
  if (values.empty()) {
    return spread;
  }
  std::sort(values.begin(), values.end());
  double squares = 0.0;
  for (const double value : values) {
    squares += value * value;
  }
  const auto at = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(values.size())));
  spread.rms = std::sqrt(squares / static_cast<double>(values.size()));
  spread.quantile_95 = values[at - 1];
  spread.maximum = values.back();
  return spread;
}

LengthUncertainty of_lengths(const UncertainArm& arm, double length, int count, std::uint64_t index,
                             std::uint64_t seed) {
  RandomStream random(seed, "lengths", index);
  const UncertainArm quiet = arm.without_noise();
  std::vector<double> values;
  std::vector<double> of_arm;
  for (int i = 0; i < count; ++i) {
    const UncertainTip first = arm.tip(random_posture(arm.arm(), random));
    if (const auto second = tip_at(arm, first.in_base + length * random.direction(), random)) {
      values.push_back(arm.of_length(first, *second));
      of_arm.push_back(quiet.of_length(first, *second));
    }
  }
  return {length, spread_of(std::move(values)), spread_of(std::move(of_arm))};
}

SpreadOfU of_diameters(const UncertainArm& arm, const VolumeSampling& sampling) {
  RandomStream random(sampling.seed, "spheres");
  const auto pattern = iso_directions();
  const double radius = 0.5 * sampling.diameter + arm.arm().probes[arm.probe()].radius;
  std::vector<double> values;
  for (int i = 0; i < sampling.spheres; ++i) {
    const Eigen::Vector3d centre = arm.tip(random_posture(arm.arm(), random)).in_base;
    const Eigen::Matrix3d turn = random.rotation();
    std::vector<UncertainTip> tips;
    for (const auto& direction : pattern) {
      if (auto tip = tip_at(arm, centre + radius * (turn * direction), random)) {
        tips.push_back(std::move(*tip));
      }
    }
    if (tips.size() == pattern.size()) {
      values.push_back(arm.of_diameter(tips, centre));
    }
  }
  return spread_of(std::move(values));
}

SpreadOfU of_place(const UncertainArm& arm, double from_axis, double height, const VolumeSampling& sampling,
                   std::uint64_t index) {
  RandomStream random(sampling.seed, "map", index);
  std::vector<double> values;
  for (int i = 0; i < sampling.postures; ++i) {
    const double round = random.uniform(-std::numbers::pi, std::numbers::pi);
    const auto tip = tip_at(arm, {from_axis * std::cos(round), from_axis * std::sin(round), height}, random);
    if (!tip) {
      return {};  // out of reach, or on its very edge
    }
    values.push_back(std::sqrt(arm.of_point(*tip).trace()));
  }
  return spread_of(std::move(values));
}

std::vector<MapCell> map_of(const UncertainArm& arm, const VolumeSampling& sampling) {
  const double reach_of_arm = reach(arm.arm());
  const double shoulder = arm.arm().joints.front().d;
  const double step = reach_of_arm / sampling.rings;
  std::vector<MapCell> map;
  for (int ring = 0; ring < sampling.rings; ++ring) {
    for (int level = -sampling.rings; level < sampling.rings; ++level) {
      MapCell cell{step * (ring + 0.5), shoulder + step * (level + 0.5), {}};
      cell.u = of_place(arm, cell.from_axis, cell.height, sampling, map.size());
      map.push_back(cell);
    }
  }
  return map;
}

}  // namespace

WorkingVolume survey(const UncertainArm& arm, const VolumeSampling& sampling) {
  WorkingVolume volume;
  const double reach_of_arm = reach(arm.arm());
  for (const double share : surveyed_lengths) {
    volume.lengths.push_back(
        of_lengths(arm, share * reach_of_arm, sampling.lengths, volume.lengths.size(), sampling.seed));
  }
  volume.sphere_diameter = of_diameters(arm, sampling);
  volume.map = map_of(arm, sampling);
  return volume;
}

}  // namespace artcal
