#include "identification/evaluation/stationarity.h"

#include <algorithm>
#include <cmath>

#include "identification/identifiability/svd.h"
#include "identification/least_squares/elimination.h"

namespace artcal {
namespace {

constexpr double max_relative_offset = 1e-3;
constexpr double rounding_of_a_step = 1e-12;

}  // namespace

ResidualParts residual_parts(const Linearisation& linearisation, int arm_size) {
  std::vector<EliminatedRows> eliminated;
  const Eigen::MatrixXd triangle = eliminate_nuisance(linearisation, arm_size + 1, &eliminated);
  double tangential = 0.0;
  for (const EliminatedRows& rows : eliminated) {
    tangential += rows.by_trailing.rightCols<1>().squaredNorm();
  }
  const Eigen::VectorXd residual = triangle.rightCols<1>();
  double of_arm = 0.0;
  if (arm_size > 0 && triangle.rows() > 0) {
    // The right singular vectors of the transposed matrix are the directions that the arm's parameters span.
    const Svd spanned = svd(triangle.leftCols(arm_size).transpose());
    const Eigen::Index rank = (spanned.values.array() > rounding_of_a_step * spanned.values[0]).count();
    of_arm = (spanned.right_vectors.leftCols(rank).transpose() * residual).squaredNorm();
  }
  return {std::sqrt(tangential + of_arm), std::sqrt(std::max(0.0, residual.squaredNorm() - of_arm))};
}

bool is_stationary(const ResidualParts& parts, int degrees_of_freedom, int unknowns, double negligible) {
  return parts.tangential < negligible ||
         parts.tangential / std::sqrt(std::max(1, unknowns)) <
             max_relative_offset * parts.orthogonal / std::sqrt(std::max(1, degrees_of_freedom));
}

}  // namespace artcal
