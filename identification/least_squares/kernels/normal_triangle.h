#pragma once

#include <memory>
#include <vector>

#include <Eigen/Core>

#include "identification/least_squares/triangular_factor.h"

namespace artcal {

/// TriangularFactor by way of AᵀA and its Cholesky factor: in a fraction of the time, with half of the digits. A column
/// that is to working precision a combination of those before it has a row of zeros. For steps of a fit that is itself
/// only a start of another.
class NormalTriangle {
 public:
  explicit NormalTriangle(int columns);

  void add(const RowsRef& rows);

  /// columns × columns, upper triangular.
  [[nodiscard]] Eigen::MatrixXd triangle();

 private:
  struct alignas(64) Line {
    double numbers[8];
  };
  void fold();

  Eigen::Index columns_;
  Eigen::Index padded_;              // to a multiple of eight, with zeros
  std::unique_ptr<Line[]> waiting_;  // rows
  std::vector<Line> gram_;
  Eigen::Index filled_ = 0;
};

}  // namespace artcal
