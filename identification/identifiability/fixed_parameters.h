#pragma once

#include <vector>

#include <Eigen/Core>

namespace artcal {

/// Which parameters are to be fixed where there is a choice, by index.
struct FixingOrder {
  std::vector<int> first;  ///< preferred, in this order
  std::vector<int> last;   ///< only where nothing else takes part
};

/// One fixed parameter for each unidentifiable direction: with these known, the others are identifiable.
struct FixedParameters {
  std::vector<int> indices;
  /// Parameters × dimensions: a basis of the null space. Column i has 1 at indices[i] and 0 at the other fixed
  /// parameters.
  Eigen::MatrixXd motions;
};

/// Chooses as many parameters as `null_space` has dimensions. A preferred parameter is taken only where it determines
/// the direction well: with it fixed, no other parameter has to change by more than twenty times as much (in units of
/// `tolerances`) to take its part. Otherwise a choice that is exact in rank would leave nearly unidentifiable
/// parameters free, as a6 does beside an alpha6 of nearly zero.
/// The choice is a QR factorisation of the transposed null space with column pivoting (Golub and Van Loan 2013, 5.4.2),
/// the pivots being taken in the order of preference while they are large enough.
///
/// `null_space`: orthonormal columns. `tolerances`: of each row, by how much such a parameter is usually off, in the
/// units of the rows. `given`: fixed before all others, whatever the order.
FixedParameters choose_fixed(const Eigen::MatrixXd& null_space, const Eigen::VectorXd& tolerances,
                             const FixingOrder& order, const std::vector<int>& given = {});

}  // namespace artcal
