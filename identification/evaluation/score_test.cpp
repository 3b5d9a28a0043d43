#include "identification/evaluation/score_test.h"

#include "core/triangular_solve.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace artcal {
namespace {

constexpr double least_redundancy = 1e-8;  // below, the fit adapts to a direction wholly
constexpr Eigen::Index spare_units = 10;

}  // namespace

Eigen::VectorXd leverage_adjusted(const Eigen::VectorXd& residuals, const std::vector<ObservationRows>& observations) {
  Eigen::VectorXd adjusted = residuals;
  for (const ObservationRows& observation : observations) {
    const Eigen::Index size = observation.hat.rows();
    if (size == 1) {
      const double value = 1.0 - observation.hat(0, 0);
      adjusted[observation.first] *= value > least_redundancy ? 1.0 / std::sqrt(value) : 0.0;
      continue;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> redundancy(Eigen::MatrixXd::Identity(size, size) -
                                                                    observation.hat);
    const Eigen::VectorXd factors = redundancy.eigenvalues().unaryExpr(
        [](double value) { return value > least_redundancy ? 1.0 / std::sqrt(value) : 0.0; });
    auto own = adjusted.segment(observation.first, size);
    own = redundancy.eigenvectors() * factors.cwiseProduct(redundancy.eigenvectors().transpose() * own);
  }
  return adjusted;
}

double score_statistic(const Eigen::MatrixXd& columns, const Eigen::VectorXd& residuals,
                       const Eigen::VectorXd& adjusted, const std::vector<ObservationRows>& observations) {
  int units = 0;
  for (const ObservationRows& observation : observations) {
    units = std::max(units, observation.unit + 1);
  }
  if (units < columns.cols() + spare_units) {
    return 0.0;
  }
  Eigen::MatrixXd scores = Eigen::MatrixXd::Zero(units, columns.cols());
  for (const ObservationRows& observation : observations) {
    const Eigen::Index size = observation.hat.rows();
    if (size == 1) {
      scores.row(observation.unit) += adjusted[observation.first] * columns.row(observation.first);
      continue;
    }
    scores.row(observation.unit) +=
        adjusted.segment(observation.first, size).transpose() * columns.middleRows(observation.first, size);
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scores);
  if (qr.rank() < columns.cols()) {
    return 0.0;
  }
  Eigen::VectorXd whitened = qr.colsPermutation().transpose() * (columns.transpose() * residuals);
  solve_upper_transposed(qr.matrixQR().topRows(columns.cols()), whitened);
  return whitened.squaredNorm();
}

}  // namespace artcal
