#pragma once

#include <optional>

#include <Eigen/Core>

#include "identification/least_squares/kernels/normal_triangle.h"
#include "identification/least_squares/triangular_factor.h"

namespace artcal {

/// How rows become a triangle: with all digits (TriangularFactor), or for a fit that is only a start (NormalTriangle).
enum class Folding { Reflections, NormalEquations };

/// Collects rows of a matrix A. While they are few they are kept; where they become more than the columns they are
/// folded into the triangle R with RᵀR = AᵀA.
class RowStack {
 public:
  /// `expected` rows or more will come: where these are more than the columns, none is kept.
  explicit RowStack(int columns, Folding folding = Folding::Reflections, int expected = 0);

  void add(const RowsRef& rows);

  /// At most as many rows as columns.
  [[nodiscard]] Eigen::MatrixXd rows();

 private:
  void begin_folding();

  int columns_;
  Folding folding_;
  Eigen::MatrixXd kept_;
  Eigen::Index count_ = 0;
  std::optional<TriangularFactor> factor_;
  std::optional<NormalTriangle> normal_;
};

}  // namespace artcal
