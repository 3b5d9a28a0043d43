#pragma once

#include <cstddef>

namespace artcal::fitting {

/// One pass over many points for a sphere fit, on plain arrays: the source file is compiled for several
/// instruction sets and no Eigen type may cross that border. Sums run in eight lanes whatever the set,
/// so that every machine gets the same digits.

/// The points as stored, x y z in turn, and the sphere: its centre is origin + centre. Two subtractions a
/// coordinate, or the sphere of a frame far away would be known to its last place only.
struct SphereView {
  const double* xyz;
  std::size_t count;
  double origin[3];
  double centre[3];
  double radius;
};

/// With ρ = |p − c|, û = (p − c)/ρ, d = ρ − R.
struct SphereGradient {
  double du[3], d, dd;  ///< Σ d·û, Σ d, Σ d²
};
struct SphereSums {
  SphereGradient gradient;
  double u[3];    ///< Σ û
  double uuf[6];  ///< Σ û·ûᵀ/ρ: xx xy xz yy yz zz
  double f;       ///< Σ 1/ρ
};
struct SphereResiduals {
  double low, high, dd;
};

SphereSums sphere_sums(const SphereView& view);
SphereGradient sphere_gradient(const SphereView& view);
/// Writes d of every point.
SphereResiduals sphere_residuals(const SphereView& view, double* d);

}  // namespace artcal::fitting
