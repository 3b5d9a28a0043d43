#pragma once

#include <limits>

namespace artcal {

/// Standard uncertainty of a test value, after ISO/TS 23165, by its parts (mm): what the test itself adds,
/// not what the machine does.
///     u²(E) = u²(cal) + u²(α) + u²(t) + u²(align) + u²(fixture) + u²(points)
struct Budget {
  double calibration = 0.0;  ///< u(cal) = U/k of the certificate
  double expansion = 0.0;    ///< u(α) = L·|T − T_ref|·u(α)
  double temperature = 0.0;  ///< u(t) = L·α·u(T)
  double alignment = 0.0;
  double fixture = 0.0;
  double form = 0.0;    ///< of the ball: √((F/2)² + u²(F))
  double points = 0.0;  ///< how well the touches determine centres and diameters (point_scatter.h)
  double points_freedom = std::numeric_limits<double>::infinity();  ///< degrees of freedom of u(points)

  [[nodiscard]] double total() const;
  /// Effective degrees of freedom of the total (Welch, Satterthwaite); all parts but u(points) are known exactly.
  [[nodiscard]] double degrees_of_freedom() const;
};

/// What is known of the artefact and the day.
struct ThermalState {
  double expansion = 0.0;      ///< α, 1/K
  double u_expansion = 0.0;    ///< 1/K
  double difference = 0.0;     ///< T − T_ref, K
  double u_temperature = 0.0;  ///< of T, K
};

/// Adds u(α) and u(t) of a length (mm) to what is there.
Budget with_thermal(Budget budget, double length, const ThermalState& state);

/// √((F/2)² + u²(F)) of a ball whose form deviation is certified as F.
double form_uncertainty(double form, double u_form);

}  // namespace artcal
