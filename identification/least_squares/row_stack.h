#pragma once

#include <optional>

#include <Eigen/Core>

#include "identification/least_squares/triangular_factor.h"

namespace artcal {

/// Collects rows of a matrix A. While they are few they are kept; where they become more than the columns they are
/// folded into the triangle R with RᵀR = AᵀA.
class RowStack {
 public:
  explicit RowStack(int columns) : columns_(columns), kept_(0, columns) {}

  void add(const RowsRef& rows);

  /// At most as many rows as columns.
  [[nodiscard]] Eigen::MatrixXd rows();

 private:
  int columns_;
  Eigen::MatrixXd kept_;
  Eigen::Index count_ = 0;
  std::optional<TriangularFactor> factor_;
};

}  // namespace artcal
