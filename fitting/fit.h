#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/error.h"
#include "fitting/feature.h"

namespace artcal {

/// Points to fit, a column each, mm, in one frame.
using Points = Eigen::Ref<const Eigen::Matrix3Xd>;

/// What "fits best" means.
enum class Criterion {
  LeastSquares,          ///< smallest sum of squared orthogonal distances; every feature
  MinimumZone,           ///< smallest range of distances: Plane (exact), Sphere, Circle
  MinimumCircumscribed,  ///< smallest that holds every point: Sphere, Circle
  MaximumInscribed,      ///< largest with no point inside, next to the least-squares one: Sphere, Circle
};

/// How a circle is fitted to points in space.
enum class CircleConvention {
  Projected,  ///< metrology's: least-squares plane, points projected onto it, circle fitted there
  Spatial,    ///< smallest sum of squared distances to the curve in space
};

/// The probing side of a tip of known radius.
enum class Side {
  Outside,  ///< the tip touches from outside: its centres lie one tip radius out of the material
  Inside,   ///< a bore, a hollow sphere: its centres lie one tip radius nearer to the centre or axis
};

struct FitOptions {
  Criterion criterion = Criterion::LeastSquares;
  /// One number ≥ 0 a point, or none: the cost is Σ w·d², so give 1/u² of the point in some common unit.
  /// Zero leaves the point out. Least squares only.
  Eigen::VectorXd weights;
  /// Sphere, least squares: the surface's radius is known (its tip radius, if any, comes on top), mm.
  std::optional<double> fixed_radius;
  /// Standard deviation of a distance of weight one, mm. Without it the residuals tell.
  std::optional<double> noise;
  CircleConvention circle = CircleConvention::Projected;
  /// Circle, projected: the normal of its plane is known (a drawing, a metrology file), of any length but zero. The
  /// plane goes through the points' centroid.
  std::optional<Eigen::Vector3d> circle_normal;
  /// The points are centres of a tip of this radius, mm: the feature is the surface it touched.
  double tip_radius = 0.0;
  Side side = Side::Outside;
  /// Normals and directions are turned to point this way. A plane with a tip radius needs it, from the
  /// material towards the probe, and so does a sphere of known radius whose points lie in one plane. Without it the
  /// largest component of the vector is made positive.
  std::optional<Eigen::Vector3d> towards;
};

enum class FitStatus {
  Converged,  ///< the next step would not change the feature
  StepLimit,  ///< still moving when the steps ran out; the feature is the best one met
};

template <typename F>
struct Fitted {
  F feature;
  /// Signed distance of every point (the left-out ones too) to the feature through the points as given,
  /// before the tip radius is taken off, mm. See signed_distance; a Projected circle has the radial part.
  Eigen::VectorXd residuals;
  double form = 0.0;  ///< range of the residuals; a line: diameter of the smallest cylinder around it; mm
  double rms = 0.0;   ///< √(Σ w·d² / Σ w), mm
  int degrees_of_freedom = 0;
  /// Standard deviation of a distance of weight one, mm: as given, else √(Σ w·d² / degrees of freedom).
  /// None without redundancy, and none for the criteria other than least squares.
  std::optional<double> noise;
  /// Of F::parameters(); mm and rad. There where `noise` is.
  std::optional<Eigen::Matrix<double, F::parameter_count, F::parameter_count>> covariance;
  FitStatus status = FitStatus::Converged;
  int steps = 0;
};

/// Fits one feature. F is Sphere, Plane, Line, Circle, Cylinder or Cone.
///
/// Least squares minimises orthogonal distances, in double on coordinates that are centred and scaled:
/// an offset of the frame costs no digit. Answers agree with the published reference pairs to 1e-9 mm,
/// 1e-10 rad and 1e-9° (docs/fitting.md has the table). The order of the points does not matter beyond
/// rounding.
///
/// Errors: BadInput for what is wrong with the points (NaN, too few, all the same, weights of another
/// length or sign); NoSolution where they are sound but do not determine the feature (on one plane, on one
/// line, a patch too small to determine the radius); Usage for options that the feature does not have.
template <typename F>
Expected<Fitted<F>> fit(const Points& points, const FitOptions& options = {});

extern template Expected<Fitted<Sphere>> fit(const Points&, const FitOptions&);
extern template Expected<Fitted<Plane>> fit(const Points&, const FitOptions&);
extern template Expected<Fitted<Line>> fit(const Points&, const FitOptions&);
extern template Expected<Fitted<Circle>> fit(const Points&, const FitOptions&);
extern template Expected<Fitted<Cylinder>> fit(const Points&, const FitOptions&);
extern template Expected<Fitted<Cone>> fit(const Points&, const FitOptions&);

}  // namespace artcal
