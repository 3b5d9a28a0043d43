#include "identification/evaluation/outliers.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/statistics.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// Below this the fit adapts to an observation, whose residual then says nothing of it.
constexpr double least_variance = 1e-9;
constexpr double chance = 0.05;

/// How far a feature's certificates are off, in limits: of distances in one placement, of its own numbers in all.
struct Blame {
  int artefact = 0;
  int placement = -1;  ///< -1: all
  int feature = 0;
  double excess = 0.0;
};

// What the observation itself would have to be for the rest to agree with it, less what it is, in its own unit.
double deleted_deviation(double residual, double weight, double counted, const Check& check) {
  return residual / (1.0 - std::min(counted * check.leverage, 1.0 - least_variance)) / weight;
}

template <typename Item>
void worst_first(std::vector<Item>& items) {
  std::stable_sort(items.begin(), items.end(),
                   [](const Item& a, const Item& b) { return a.standardised / a.limit > b.standardised / b.limit; });
}

struct Certificates {
  std::vector<CertificateOutlier> outliers;
  std::vector<Blame> blames;

  void add(CertificateOutlier outlier, double size, double limit) {
    outlier.standardised = size;
    outlier.limit = limit;
    outliers.push_back(std::move(outlier));
  }
};

void add_distances(const Recording& recording, const Constraints& constraints, const ArmFit& fit,
                   const Redundancy& redundancy, Certificates& found) {
  std::size_t binding = 0;
  for (std::size_t d = 0; d < constraints.distances.size(); ++d) {
    const DistanceConstraint& distance = constraints.distances[d];
    if (!distance.binds) {
      continue;
    }
    const double residual = fit.residuals.distances[binding++];
    const Check& check = redundancy.distances[d];
    const double size = standardised(residual * residual, 1, check);
    const double limit = outlier_limit(observation_count(constraints), check);
    if (size <= limit) {
      continue;
    }
    const FeatureConstraint& first = constraints.features[distance.first];
    const FeatureConstraint& second = constraints.features[distance.second];
    CertificateOutlier outlier;
    outlier.name = name_of(first, constraints, recording);
    outlier.second = name_of(second, constraints, recording).feature;
    outlier.certified = distance.value;
    outlier.u = distance.u;
    outlier.deviation = deleted_deviation(residual, fit.weights.distances[d], fit.loss_weights.distances[d], check);
    outlier.weight = fit.loss_weights.distances[d];
    found.add(std::move(outlier), size, limit);
    for (const FeatureConstraint* feature : {&first, &second}) {
      found.blames.push_back({feature->artefact, feature->placement, feature->feature, size / limit});
    }
  }
}

void add_shared(const Constraints& constraints, const ArmFit& fit, const Redundancy& redundancy, Certificates& found) {
  for (std::size_t s = 0; s < constraints.shared.size(); ++s) {
    const ArtefactParameter& shared = constraints.shared[s];
    const Check& check = redundancy.shared[s];
    const double residual = fit.residuals.shared[s];
    const double size = shared.u > 0.0 ? standardised(residual * residual, 1, check) : 0.0;
    const double limit = outlier_limit(observation_count(constraints), check);
    if (size <= limit) {
      continue;
    }
    const Artefact& artefact = constraints.artefacts[shared.artefact];
    const CertifiedFeature& feature = artefact.features[shared.feature];
    const bool is_radius = shared.quantity == ArtefactParameter::Quantity::Radius;
    CertificateOutlier outlier;
    outlier.name = {artefact.name, "", feature.name};
    outlier.quantity = shared.quantity;
    outlier.certified =
        shared.certified + (is_radius ? 0.0 : (*feature.at)[static_cast<Eigen::Index>(shared.quantity)]);
    outlier.u = shared.u;
    outlier.deviation = deleted_deviation(residual, fit.weights.shared[s], fit.loss_weights.shared[s], check);
    outlier.weight = fit.loss_weights.shared[s];
    found.add(std::move(outlier), size, limit);
    found.blames.push_back({shared.artefact, -1, shared.feature, size / limit});
  }
}

bool is_blamed_elsewhere(const FeatureConstraint& feature, double excess, const std::vector<Blame>& blames) {
  return std::any_of(blames.begin(), blames.end(), [&](const Blame& blame) {
    return blame.artefact == feature.artefact && blame.feature == feature.feature &&
           (blame.placement < 0 || blame.placement == feature.placement) && blame.excess >= excess;
  });
}

}  // namespace

double standardised(double squares, int dimension, const Check& check) {
  return check.variance > least_variance ? std::sqrt(squares * check.freedom / (dimension * check.variance)) : 0.0;
}

double outlier_limit(double count, const Check& check) {
  return std::sqrt(chi_squared_quantile(1.0 - chance / count, check.freedom));
}

double observation_count(const Constraints& constraints) {
  double count = constraints.binding_distance_count();
  for (const FeatureConstraint& feature : constraints.features) {
    count += feature.size();
  }
  for (const ArtefactParameter& shared : constraints.shared) {
    count += shared.u > 0.0 ? 1.0 : 0.0;
  }
  return count;
}

Outliers find_outliers(const Recording& recording, const Constraints& constraints, const ArmFit& fit,
                       const Redundancy& redundancy, const Evaluation& evaluation) {
  Certificates certificates;
  add_distances(recording, constraints, fit, redundancy, certificates);
  add_shared(constraints, fit, redundancy, certificates);
  const double count = observation_count(constraints);
  const double lowest = outlier_limit(count, {});  // one degree of freedom, which all limits are above
  Outliers outliers;
  std::size_t flat = 0;
  for (std::size_t f = 0; f < constraints.features.size(); ++f) {
    const FeatureConstraint& feature = constraints.features[f];
    const int dimension = feature.dimension();
    for (int k = 0; k < feature.size(); ++k, ++flat) {
      const Check& check = redundancy.readings[f][k];
      const double squares =
          Eigen::VectorXd::Map(fit.residuals.readings[f].data() + k * dimension, dimension).squaredNorm();
      const double size = standardised(squares, dimension, check);
      if (size <= lowest) {
        continue;
      }
      const double limit = outlier_limit(count, check);
      if (size > limit && !is_blamed_elsewhere(feature, size / limit, certificates.blames)) {
        outliers.readings.push_back({feature.readings[k], name_of(feature, constraints, recording), size, limit,
                                     evaluation.deviations[flat], has_signed_deviation(feature),
                                     fit.loss_weights.readings[f][k]});
      }
    }
  }
  outliers.certificates = std::move(certificates.outliers);
  worst_first(outliers.readings);
  worst_first(outliers.certificates);
  return outliers;
}

std::string warning_of(const std::vector<CertificateOutlier>& certificates, Loss loss) {
  if (certificates.empty()) {
    return {};
  }
  const CertificateOutlier& worst = certificates.front();
  const std::string where =
      worst.name.placement.empty() ? "" : fmt::format(", placement {}", in_quotes(worst.name.placement));
  const std::string more =
      certificates.size() == 1 ? "" : fmt::format(" (and {} more certified values)", certificates.size() - 1);
  return fmt::format(
      "the certificate of artefact {} contradicts the readings: its {} {:.6g} mm (u = {:.2g} mm) is {:+.3g} mm off "
      "what the rest determines{}, {:.1f} standard deviations{}. {}",
      in_quotes(worst.name.artefact), quantity_text(worst), worst.certified, worst.u, -worst.deviation, where,
      worst.standardised, more,
      loss == Loss::None ? "Check the certificate and which artefact was read; --loss cauchy identifies without what "
                           "contradicts the rest"
                         : fmt::format("It counts by {:.2g} here; check it", worst.weight));
}

std::string quantity_text(const CertificateOutlier& outlier) {
  using Quantity = ArtefactParameter::Quantity;
  const std::string feature = in_quotes(outlier.name.feature);
  if (!outlier.quantity) {
    return fmt::format("distance {} to {}", feature, in_quotes(outlier.second));
  }
  switch (*outlier.quantity) {
    case Quantity::ErrorX: return "x of " + feature;
    case Quantity::ErrorY: return "y of " + feature;
    case Quantity::ErrorZ: return "z of " + feature;
    case Quantity::Radius: break;
  }
  return "radius of " + feature;
}

}  // namespace artcal
