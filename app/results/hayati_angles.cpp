#include "app/results/hayati_angles.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/arm/parallel_axes.h"

namespace artcal {
namespace {

const IdentifiedParameter* offset_of(const Identification& result, int joint) {
  const auto found = std::find_if(result.parameters.begin(), result.parameters.end(), [&](const auto& each) {
    return each.parameter.kind == ParameterKind::D && each.parameter.owner == joint;
  });
  return found == result.parameters.end() ? nullptr : &*found;
}

}  // namespace

std::vector<HayatiAngle> hayati_angles(const Identification& result) {
  std::vector<HayatiAngle> angles;
  for (const IdentifiedParameter& each : result.parameters) {
    const int joint = each.parameter.owner;
    const bool found = each.state == ParameterState::Identified || each.state == ParameterState::Weak;
    if (each.parameter.kind != ParameterKind::Beta || !found ||
        !joins_parallel_axes(result.arm, static_cast<std::size_t>(joint))) {
      continue;
    }
    if (const IdentifiedParameter* offset = offset_of(result, joint)) {
      angles.push_back({each.parameter.name, offset->parameter.name, joint});
    }
  }
  return angles;
}

std::string hayati_angles_text(const Recording& recording, const Identification& result) {
  std::vector<std::string> names, offsets;
  std::string moved;
  for (const HayatiAngle& each : hayati_angles(result)) {
    names.push_back(each.angle);
    offsets.push_back(each.offset);
    const double stated = recording.arm.joints[static_cast<std::size_t>(each.joint)].d;
    if (const double nominal = offset_of(result, each.joint)->nominal; nominal != stated) {
      moved += fmt::format(
          "  {} is {:.6g} mm in the arm's file, farther than the arm reaches: the same axes are described with {} = "
          "{:g}, and nominal values of neighbouring parameters change with it\n",
          each.offset, stated, each.offset, nominal);
    }
  }
  if (names.empty()) {
    return "";
  }
  return fmt::format("  Hayati's angle {} in place of {}: neighbouring axes are nearly parallel, {}\n{}\n",
                     fmt::join(names, ", "), fmt::join(offsets, ", "), parallel_axes(recording.arm), moved);
}

}  // namespace artcal
