#include "identification/initial/ball_sides.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/statistics.h"
#include "identification/initial/ball_start.h"

namespace artcal {
namespace {

// Variances of a reading by which the sums of squares of two centres must differ for readings to decide between them.
constexpr double decisive = 30.0;
constexpr int unknowns_of_a_centre = 3;

double squares(const Tips& tips, const Eigen::VectorXd& rho, const Eigen::Vector3d& centre) {
  return ((tips.centres.colwise() - centre).colwise().norm().transpose() - rho).squaredNorm();
}

double usual_variance(const std::vector<Tips>& tips, const Eigen::VectorXd& shared,
                      const std::vector<Eigen::Vector3d>& centres) {
  std::vector<double> variances;
  for (std::size_t i = 0; i < tips.size(); ++i) {
    if (const int spare = tips[i].feature->size() - unknowns_of_a_centre; tips[i].feature->has_centre() && spare > 0) {
      variances.push_back(squares(tips[i], distances_from_centre(tips[i], shared), centres[i]) / spare);
    }
  }
  return variances.empty() ? 0.0 : median(variances);
}

// By how much the distances of a feature from others miss their certified values, mm.
double missed_distances(const Constraints& constraints, int feature, const Eigen::Vector3d& centre,
                        const std::vector<Eigen::Vector3d>& centres) {
  double sum = 0.0;
  for (const DistanceConstraint& distance : constraints.distances) {
    if (distance.first == feature || distance.second == feature) {
      const int other = distance.first == feature ? distance.second : distance.first;
      sum += std::abs((centre - centres[other]).norm() - distance.value);
    }
  }
  return sum;
}

}  // namespace

void choose_sides(const Constraints& constraints, const std::vector<Tips>& tips, const Unknowns& unknowns,
                  const std::vector<Eigen::Vector3d>& certified, std::vector<Eigen::Vector3d>& centres) {
  const double slack = decisive * usual_variance(tips, unknowns.shared, centres);
  for (std::size_t i = 0; i < tips.size(); ++i) {
    if (!tips[i].feature->has_centre()) {
      continue;
    }
    const Eigen::VectorXd rho = distances_from_centre(tips[i], unknowns.shared);
    const auto other = point_on_the_other_side(tips[i].centres, rho, centres[i]);
    if (!other || squares(tips[i], rho, *other) > squares(tips[i], rho, centres[i]) + slack) {
      continue;
    }
    const int feature = static_cast<int>(i);
    const bool is_nearer = tips[i].feature->location == Location::Unknown
                               ? missed_distances(constraints, feature, *other, centres) <
                                     missed_distances(constraints, feature, centres[i], centres)
                               : (*other - certified[i]).norm() < (centres[i] - certified[i]).norm();
    if (is_nearer) {
      centres[i] = *other;
    }
  }
}

}  // namespace artcal
