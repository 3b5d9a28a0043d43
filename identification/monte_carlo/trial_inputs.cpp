#include "identification/monte_carlo/trial_inputs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/normal_vector.h"
#include "core/random.h"
#include "core/statistics.h"
#include "identification/monte_carlo/turned_joints.h"
#include "identification/problem/certified_distances.h"

namespace artcal {
namespace {

using Place = std::pair<int, int>;  // artefact, placement

Place place_of(const FeatureConstraint& feature) { return {feature.artefact, feature.placement}; }

}  // namespace

TrialInputs::TrialInputs(const System& system, const Recording& recording, const InputSpread& spread)
    : base_(system),
      spread_(spread),
      above_reference_(above_reference(*system.constraints, recording)),
      certificates_(certified_distances(*system.constraints)),
      constraints_(*system.constraints),
      drawn_(system) {
  drawn_.constraints = &constraints_;
  drawn_.shifts.assign(system.probes.size(), Eigen::Vector3d::Zero());
}

void TrialInputs::draw(std::uint64_t seed, std::uint64_t trial) {
  draw_readings(seed, trial);
  draw_certificates(seed, trial);
  if (spread_.arm_temperature > 0.0) {
    draw_arm_temperatures(seed, trial);
  }
}

void TrialInputs::draw_readings(std::uint64_t seed, std::uint64_t trial) {
  RandomStream random(seed, "trial: readings", trial);
  double factor = spread_.scale_factor;
  if (spread_.degrees_of_freedom) {
    // Away from the very ends, where a quantile is not finite.
    const double p = std::clamp(random.uniform(), 1e-12, 1.0 - 1e-12);
    factor *= std::sqrt(*spread_.degrees_of_freedom / chi_squared_quantile(p, *spread_.degrees_of_freedom));
  }
  const double probing = factor * spread_.probing;
  for (Eigen::Vector3d& shift : drawn_.shifts) {
    for (double& coordinate : shift) {
      coordinate = probing * random.normal();
    }
  }
  if (spread_.encoder > 0.0) {
    drawn_.joints = base_.joints;
    drawn_.sines = base_.sines;
    turn_joints(drawn_.joints, drawn_.sines, factor * spread_.encoder, random);
  }
  for (std::size_t f = 0; f < constraints_.features.size(); ++f) {
    FeatureConstraint& feature = constraints_.features[f];
    if (feature.u > 0.0) {
      const FeatureConstraint& read = base_.constraints->features[f];
      const double u = spread_.scale_factor * feature.u;
      if (auto* lengths = feature.as<AtDistance>()) {
        for (std::size_t k = 0; k < lengths->distances.size(); ++k) {
          lengths->distances[k] = read.as<AtDistance>()->distances[k] + u * random.normal();
        }
        continue;
      }
      for (std::size_t k = 0; k < feature.known.size(); ++k) {
        feature.known[k] = read.known[k] + u * normal_vector(random);
      }
    }
  }
}

void TrialInputs::draw_certificates(std::uint64_t seed, std::uint64_t trial) {
  const Constraints& stated = *base_.constraints;
  RandomStream random(seed, "trial: certificates", trial);
  const double scale_factor = spread_.scale_factor;
  for (std::size_t s = 0; s < stated.shared.size(); ++s) {
    constraints_.shared[s].certified = stated.shared[s].certified + scale_factor * stated.shared[s].u * random.normal();
  }
  std::vector<double> expansion;
  for (const Artefact& artefact : stated.artefacts) {
    expansion.push_back(artefact.expansion + scale_factor * artefact.u_expansion * random.normal());
  }
  std::vector<double> errors;  // of certified distances at the reference temperature, mm
  for (const Artefact& artefact : stated.artefacts) {
    for (const CertifiedDistance& distance : artefact.distances) {
      errors.push_back(scale_factor * distance.u * random.normal());
    }
  }
  std::map<Place, double> temperature_errors;
  std::vector<double> expansion_factor(
      stated.features.size());  // drawn length / stated length, of each feature's placement
  for (std::size_t f = 0; f < stated.features.size(); ++f) {
    const FeatureConstraint& before = stated.features[f];
    const auto [entry, is_new] = temperature_errors.try_emplace(place_of(before), 0.0);
    if (is_new) {
      entry->second = scale_factor * spread_.temperature * random.normal();
    }
    const double factor = 1.0 + expansion[before.artefact] * (above_reference_[f] + entry->second);
    expansion_factor[f] = factor / before.expansion;
    FeatureConstraint& feature = constraints_.features[f];
    feature.expansion = factor;
    if (auto* ball = feature.as<OnBall>(); ball != nullptr && ball->radius) {
      ball->radius = expansion_factor[f] * *before.as<OnBall>()->radius;
    }
    if (auto* plane = feature.as<OnPlane>(); plane != nullptr && plane->face) {
      plane->face->height = expansion_factor[f] * before.face()->height;
    }
    const bool by_another_instrument =
        stated.artefacts[before.artefact].features[before.feature].kind == FeatureKind::Coordinates;
    for (std::size_t k = 0; !by_another_instrument && k < before.known.size(); ++k) {
      feature.known[k] = expansion_factor[f] * before.known[k];
    }
  }
  for (std::size_t d = 0; d < stated.distances.size(); ++d) {
    const DistanceConstraint& before = stated.distances[d];
    const double factor = constraints_.features[before.first].expansion;
    constraints_.distances[d].value = expansion_factor[before.first] * before.value +
                                      (certificates_[d] < 0 ? 0.0 : factor * errors[certificates_[d]]);
  }
}

void TrialInputs::draw_arm_temperatures(std::uint64_t seed, std::uint64_t trial) {
  RandomStream random(seed, "trial: arm temperatures", trial);
  std::map<int, double> errors;  // of each placement
  for (const FeatureConstraint& feature : constraints_.features) {
    const auto [entry, is_new] = errors.try_emplace(feature.placement, 0.0);
    if (is_new) {
      entry->second = spread_.scale_factor * spread_.arm_temperature * random.normal();
    }
    for (const int reading : feature.readings) {
      const auto k = static_cast<std::size_t>(reading);
      drawn_.temperatures[k] = base_.temperatures[k] + entry->second;
    }
  }
}

}  // namespace artcal
