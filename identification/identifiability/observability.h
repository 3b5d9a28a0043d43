#pragma once

#include <Eigen/Core>

namespace artcal {

/// Observability of m parameters by n readings, from the singular values of the scaled Jacobian (Sun, Hollerbach 2008;
/// Gao 2013 §4): O1 = (∏σ)^(1/m)/√n, O2 = σm/σ1, O3 = σm, O4 = σm²/σ1, O5 = 1/Σ(1/σ). Larger is better.
struct Observability {
  double o1 = 0.0, o2 = 0.0, o3 = 0.0, o4 = 0.0, o5 = 0.0;
};

/// REQUIRES: singular values in falling order, none negative, at least one.
Observability observability_of(const Eigen::VectorXd& singular_values, int readings);

}  // namespace artcal
