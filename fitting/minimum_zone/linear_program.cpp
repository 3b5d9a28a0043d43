#include "fitting/minimum_zone/linear_program.h"

#include <CGAL/Gmpzf.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

namespace artcal::fitting {

std::optional<Eigen::VectorXd> minimise_linear(const Eigen::VectorXd& cost, const Eigen::MatrixXd& a,
                                               const Eigen::VectorXd& b) {
  CGAL::Quadratic_program<double> program(CGAL::SMALLER, false, 0.0, false, 0.0);
  for (int row = 0; row < a.rows(); ++row) {
    for (int column = 0; column < a.cols(); ++column) {
      program.set_a(column, row, a(row, column));
    }
    program.set_b(row, b(row));
  }
  for (int column = 0; column < cost.size(); ++column) {
    program.set_c(column, cost(column));
  }
  // Bland's rule: the default pricing may go round in circles on a degenerate corner.
  CGAL::Quadratic_program_options options;
  options.set_pricing_strategy(CGAL::QP_BLAND);
  const auto solution = CGAL::solve_linear_program(program, CGAL::Gmpzf(), options);
  if (!solution.is_optimal()) {
    return std::nullopt;
  }
  Eigen::VectorXd x(cost.size());
  Eigen::Index k = 0;
  for (auto it = solution.variable_values_begin(); it != solution.variable_values_end(); ++it) {
    x(k++) = CGAL::to_double(*it);
  }
  return x;
}

}  // namespace artcal::fitting
