#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>

namespace artcal {

/// Touches whose scatter is pooled: those of a kind scatter alike.
enum class PointKind { TouchedBall, ScannedBall, Seat, Face };
inline constexpr std::size_t point_kinds = 4;

/// Residuals of touches about the features fitted to them, pooled over features.
struct PointScatter {
  double squares = 0.0;  ///< mm²
  int degrees_of_freedom = 0;

  void add(double more_squares, int more_freedom);
  /// Standard deviation of one touch (of its distance from a ball or a face, of its coordinate in a seat), mm; nothing
  /// without redundancy.
  [[nodiscard]] std::optional<double> deviation() const;
};

using PointScatters = std::array<PointScatter, point_kinds>;

/// How the places of the touches determine one test value. A dilution is the standard deviation of a quantity over that
/// of one touch, √(gᵀ·(JᵀJ)⁻¹·g): J has the touches' derivatives by the feature's parameters, g those of the quantity.
struct Dilution {
  std::array<double, point_kinds> of_value{};  ///< by kind of touch; 0: the value does not depend on such
  double worst = 0.0;         ///< largest of a single centre, in the direction that matters to the value, or a radius
  std::string worst_feature;  ///< of which

  /// Adds, in squares, what one feature contributes. `largest` is of the feature by itself.
  void add(PointKind kind, double contribution, double largest, const std::string& feature);
};

/// u of a value by the scatter of its touches.
struct PointUncertainty {
  double u = 0.0;                                                       ///< mm
  double degrees_of_freedom = std::numeric_limits<double>::infinity();  ///< effective (Welch, Satterthwaite)
  bool is_known = true;                                                 ///< false: of some touches no scatter is known
};

/// `otherwise`: the scatter of one touch where a kind has no redundancy, such as the noise by which the arm was
/// identified; mm.
PointUncertainty point_uncertainty(const Dilution& dilution, const PointScatters& scatters,
                                   const std::optional<double>& otherwise);

}  // namespace artcal
