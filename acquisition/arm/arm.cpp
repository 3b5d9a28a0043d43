#include "acquisition/arm/arm.h"

#include <algorithm>
#include <cmath>

#include "acquisition/arm/stretched_length.h"

namespace artcal {

namespace {

constexpr double nearly_parallel = 0.087;  // sine: 5 degrees

/// The d of joints one after the other whose axes are nearly parallel: in Denavit and Hartenberg's parameters of such
/// an arm they may be hundreds of metres that cancel.
struct OffsetsAlongOneDirection {
  double sum = 0.0;         // signed
  double sizes = 0.0;       // of all
  double deviations = 0.0;  // by how much the sum may be off because the axes are not quite parallel
  double tilt = 0.0;        // from the first axis at most, rad
  double sign = 1.0;        // -1 where the axis points the other way

  void add(double d) {
    sum += sign * d;
    sizes += std::abs(d);
    deviations += std::abs(d) * (std::sin(tilt) + 1.0 - std::cos(tilt));
  }
  // How far they can lead. The tilts add up to a right angle at most before the bound means nothing.
  [[nodiscard]] double reach() const { return tilt < 1.0 ? std::min(sizes, std::abs(sum) + deviations) : sizes; }
};

// How far a prismatic joint travels from where its length is d, as far as its ends are stated.
double travel(const Joint& joint) {
  return joint.is_prismatic() ? std::max(std::abs(joint.lowest.value_or(0.0)), std::abs(joint.highest.value_or(0.0)))
                              : 0.0;
}

// Behind the first joint. Twice as long as the arm can reach it is no length of the arm, but cancels with others.
double largest_offset(const Arm& arm) {
  double largest = 0.0;
  for (std::size_t i = 1; i < arm.joints.size(); ++i) {
    largest = std::max(largest, std::abs(arm.joints[i].d));
  }
  return largest;
}

double sum_of_lengths(const Arm& arm) {
  double length = 0.0;
  OffsetsAlongOneDirection offsets;
  const bool modified = arm.convention == Convention::Modified;
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    const Joint& joint = arm.joints[i];
    // The base column (d of the first joint; in modified DH also its a) carries the arm but does not swing.
    length += i == 0 && modified ? 0.0 : std::abs(joint.a);
    if (i == 0) {
      continue;
    }
    const Joint& between = arm.joints[modified ? i : i - 1];  // has the link between this axis and the one before
    if (i > 1 && std::abs(std::sin(between.alpha)) < nearly_parallel && std::abs(between.beta) < nearly_parallel) {
      offsets.tilt += std::abs(std::asin(std::sin(between.alpha))) + std::abs(between.beta);
      offsets.sign *= std::cos(between.alpha) < 0.0 ? -1.0 : 1.0;
    } else {
      length += offsets.reach();
      offsets = {};
    }
    offsets.add(joint.d);
  }
  length += offsets.reach();
  double tip = 0.0;
  for (const Probe& probe : arm.probes) {
    tip = std::max(tip, probe.tip_in_last.norm());
  }
  return length + tip;
}

}  // namespace

double reach(const Arm& arm) {
  double length = sum_of_lengths(arm);
  // The shortest chain costs a hundred times as much as the bound, which settles it for nearly all arms.
  if (const double offset = largest_offset(arm); offset > 2.0 * least_stretched_length(arm)) {
    const double stretched = stretched_length(arm);
    length = offset > 2.0 * stretched ? std::min(length, stretched) : length;
  }
  for (std::size_t i = 1; i < arm.joints.size(); ++i) {
    length += travel(arm.joints[i]);
  }
  return length;
}

bool has_masses(const Arm& arm) {
  return std::all_of(arm.joints.begin(), arm.joints.end(), [](const Joint& joint) { return joint.mass.has_value(); });
}

bool has_prismatic_joints(const Arm& arm) {
  return std::any_of(arm.joints.begin(), arm.joints.end(), [](const Joint& joint) { return joint.is_prismatic(); });
}

bool expands(const Arm& arm) {
  return std::any_of(arm.joints.begin(), arm.joints.end(),
                     [](const Joint& joint) { return joint.errors.expansion != 0.0; });
}

int probe_index(const Arm& arm, const std::string& name) {
  const auto found =
      std::find_if(arm.probes.begin(), arm.probes.end(), [&](const Probe& probe) { return probe.name == name; });
  return found == arm.probes.end() ? -1 : static_cast<int>(found - arm.probes.begin());
}

}  // namespace artcal
