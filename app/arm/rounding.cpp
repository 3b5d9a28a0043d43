#include "app/arm/rounding.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "acquisition/arm/parameters.h"
#include "artefacts/virtual_probing/postures.h"
#include "core/random.h"
#include "core/text/in_quotes.h"
#include "core/unit_names.h"
#include "core/units.h"

namespace artcal {
namespace {

double to_step(double value, double step) {
  return step > 0.0 ? step * std::round(value / step) + 0.0 : value;  // + 0.0: no -0
}

}  // namespace

RoundingSteps steps_of_digits(int digits) {
  const double step = std::pow(10.0, -digits);
  return {step, step * units::degree};
}

Expected<RoundingSteps> steps_of_text(const std::string& text) {
  RoundingSteps steps;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string part = text.substr(begin, end - begin);
    begin = end + 1;
    const std::size_t equal = part.find('=');
    const std::string what = part.substr(0, equal);
    const std::string size = equal == std::string::npos ? "" : part.substr(equal + 1);
    const auto step = what == "length" ? length_quantity(size) : what == "angle" ? angle_quantity(size) : std::nullopt;
    if (!step || !(*step > 0.0)) {
      return wrong_usage(
          fmt::format("--steps has {}, expected steps with their units, such as "
                      "length=0.001in,angle=19.8arcsec",
                      in_quotes(part)));
    }
    (what == "length" ? steps.length : steps.angle) = *step;
  }
  return steps;
}

Arm rounded(const RoundingSteps& steps, Arm arm) {
  for (const Parameter& parameter : parameters_of(arm)) {
    set_value(arm, parameter, to_step(value(arm, parameter), parameter.is_length() ? steps.length : steps.angle));
  }
  return arm;
}

TipChange tip_change(const Arm& from, const Arm& to, int postures) {
  RandomStream random(1, "rounding");
  TipChange change;
  Eigen::Vector3d last_from = Eigen::Vector3d::Zero(), last_to = Eigen::Vector3d::Zero();
  for (int probe = 0; probe < static_cast<int>(from.probes.size()); ++probe) {
    for (int i = 0; i < postures; ++i) {
      Eigen::VectorXd q = random_posture(from, random);
      for (Eigen::Index j = 0; j < q.size(); ++j) {
        const Joint& joint = from.joints[static_cast<std::size_t>(j)];
        if (joint.lowest && joint.highest) {
          q[j] = random.uniform(*joint.lowest, *joint.highest);
        }
      }
      const Eigen::Vector3d one = tip_at(from, probe, q);
      const Eigen::Vector3d other = tip_at(to, probe, q);
      change.rms += (other - one).squaredNorm();
      change.maximum = std::max(change.maximum, (other - one).norm());
      if (i > 0) {
        change.rms_of_lengths += std::pow((other - last_to).norm() - (one - last_from).norm(), 2);
      }
      last_from = one;
      last_to = other;
      ++change.postures;
    }
  }
  change.rms = std::sqrt(change.rms / std::max(1, change.postures));
  change.rms_of_lengths = std::sqrt(change.rms_of_lengths / std::max(1, change.postures - 1));
  return change;
}

}  // namespace artcal
