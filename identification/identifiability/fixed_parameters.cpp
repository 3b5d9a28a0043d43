#include "identification/identifiability/fixed_parameters.h"

#include <algorithm>

#include <Eigen/LU>
#include <Eigen/QR>

#include "core/contains.h"

namespace artcal {
namespace {

// Cosine between a parameter's axis and the null space from which fixing it determines a direction well.
constexpr double well_determined = 0.05;
// Below this a parameter takes no part but by rounding.
constexpr double takes_part = 1e-6;

/// The unidentifiable directions that are left while parameters are fixed one after the other.
class RemainingDirections {
 public:
  explicit RemainingDirections(const Eigen::MatrixXd& directions) {
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(directions);
    basis_ = qr.householderQ() * Eigen::MatrixXd::Identity(directions.rows(), directions.cols());
  }

  [[nodiscard]] bool none() const { return basis_.cols() == 0; }
  [[nodiscard]] int parameters() const { return static_cast<int>(basis_.rows()); }
  [[nodiscard]] const std::vector<int>& fixed() const { return fixed_; }

  // The largest part that the parameter has in any remaining direction of unit length.
  [[nodiscard]] double part_of(int parameter) const {
    return none() || contains(fixed_, parameter) ? 0.0 : basis_.row(parameter).norm();
  }

  // Keeps the directions in which the parameter takes no part.
  void fix(int parameter) {
    const Eigen::VectorXd row = basis_.row(parameter).transpose();
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(row);
    const Eigen::MatrixXd turned = basis_ * qr.householderQ();
    basis_ = turned.rightCols(turned.cols() - 1).eval();
    if (!none()) {
      basis_.row(parameter).setZero();
    }
    fixed_.push_back(parameter);
  }

 private:
  Eigen::MatrixXd basis_;
  std::vector<int> fixed_;
};

// Fixes the candidates that determine a direction well, in their order.
void fix_in_order(RemainingDirections& remaining, const std::vector<int>& candidates) {
  for (const int candidate : candidates) {
    if (remaining.part_of(candidate) > well_determined) {
      remaining.fix(candidate);
    }
  }
}

// Fixes the candidates with the largest part, one after the other, while that is more than `least`.
void fix_largest(RemainingDirections& remaining, const std::vector<int>& candidates, double least) {
  while (!remaining.none()) {
    int best = -1;
    double largest = least;
    for (const int candidate : candidates) {
      if (remaining.part_of(candidate) > largest) {
        largest = remaining.part_of(candidate);
        best = candidate;
      }
    }
    if (best < 0) {
      return;
    }
    remaining.fix(best);
  }
}

}  // namespace

FixedParameters choose_fixed(const Eigen::MatrixXd& null_space, const Eigen::VectorXd& tolerances,
                             const FixingOrder& order, const std::vector<int>& given) {
  if (null_space.cols() == 0) {
    return {{}, null_space};
  }
  RemainingDirections remaining(tolerances.cwiseInverse().asDiagonal() * null_space);
  for (const int parameter : given) {
    remaining.fix(parameter);
  }
  std::vector<int> others;
  for (int parameter = 0; parameter < remaining.parameters(); ++parameter) {
    if (!contains(order.last, parameter)) {
      others.push_back(parameter);
    }
  }
  fix_in_order(remaining, order.first);
  fix_in_order(remaining, others);
  fix_largest(remaining, others, takes_part);
  fix_largest(remaining, order.last, 0.0);
  FixedParameters result{remaining.fixed(), {}};
  const Eigen::MatrixXd at_fixed = null_space(result.indices, Eigen::all);
  result.motions = null_space * at_fixed.fullPivLu().inverse();
  for (std::size_t i = 0; i < result.indices.size(); ++i) {
    result.motions.row(result.indices[i]).setZero();
    result.motions(result.indices[i], static_cast<Eigen::Index>(i)) = 1.0;
  }
  return result;
}

}  // namespace artcal
