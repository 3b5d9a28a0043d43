#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <Eigen/Core>

#include "fitting/cloud.h"
#include "fitting/least_squares/least_squares.h"
#include "fitting/least_squares/round_state.h"

namespace artcal::fitting {

template <typename F>
using Covariance = Eigen::Matrix<double, F::parameter_count, F::parameter_count>;

/// What a least-squares fit hands back: in the frame and the unit of its cloud.
template <typename F>
struct Estimate {
  F feature;
  int degrees_of_freedom = 0;
  std::optional<double> noise = std::nullopt;
  std::optional<Covariance<F>> covariance = std::nullopt;
  FitStatus status = FitStatus::Converged;
  int steps = 0;
};

// One least-squares fit a feature; each in the source file of its name.
Expected<Estimate<Sphere>> least_squares_sphere(const Cloud& cloud, const FitOptions& options);
Expected<Estimate<Plane>> least_squares_plane(const Cloud& cloud, const FitOptions& options);
Expected<Estimate<Line>> least_squares_line(const Cloud& cloud, const FitOptions& options);
Expected<Estimate<Circle>> least_squares_circle(const Cloud& cloud, const FitOptions& options);
Expected<Estimate<Cylinder>> least_squares_cylinder(const Cloud& cloud, const FitOptions& options);
Expected<Estimate<Cone>> least_squares_cone(const Cloud& cloud, const FitOptions& options);

/// Standard deviation of weight one: as given (mm), else from the cost; none without redundancy.
inline std::optional<double> noise_of(const Cloud& cloud, const FitOptions& options, double cost, int freedom) {
  if (options.noise) {
    return *options.noise / cloud.scale;
  }
  return freedom > 0 ? std::optional(std::sqrt(cost / freedom)) : std::nullopt;
}

/// The noise that a degeneracy is judged by: never below what rounding makes of the coordinates.
inline double noise_or_rounding(const Cloud& cloud, const std::optional<double>& noise) {
  return std::max(noise.value_or(0.0), cloud.rounding);
}

/// Why a round feature is not determined where the points lie far off the best one: that they lie on one circle or the
/// like would not be true of them. Nothing where their noise is small beside the radius.
std::optional<std::string> scatter_hides(std::string_view feature, const Cloud& cloud, double noise, double radius);

/// ", as far as their noise of 0.02 mm shows"; nothing where the noise is that of rounding.
std::string as_noise_shows(const Cloud& cloud, double noise);

/// (RᵀR)⁻¹ without forming RᵀR; none if a direction is not determined. Columns are brought to length one
/// first: they are lengths, angles and curvatures, and only their angles between each other count.
template <int Size>
std::optional<Eigen::Matrix<double, Size, Size>> unit_covariance(const Eigen::Matrix<double, Size, Size>& triangle) {
  using Square = Eigen::Matrix<double, Size, Size>;
  constexpr double parallel = 1e-12;
  const Eigen::Matrix<double, Size, 1> length = triangle.colwise().norm();
  if (!(length.minCoeff() > 1e-14 * length.maxCoeff())) {
    return std::nullopt;
  }
  const SmallSvd svd = small_svd(triangle * length.cwiseInverse().asDiagonal());
  const SmallVector& sigma = svd.values;
  if (!(sigma(Size - 1) > parallel * sigma(0))) {
    return std::nullopt;
  }
  const Square root = length.cwiseInverse().asDiagonal() * svd.right_vectors * sigma.cwiseInverse().asDiagonal();
  return root * root.transpose();
}

/// ∂parameters/∂step at a state, by central differences: the retraction and the feature are smooth and
/// known to 1e-16, so that the ten digits this leaves are more than a covariance can use.
template <typename Model, typename FeatureOf>
auto parameters_by_step(const Model& model, const RoundState& state, const FeatureOf& feature_of) {
  using F = decltype(feature_of(state));
  using Step = Eigen::Matrix<double, Model::size, 1>;
  const double width = 1e-5 * std::min(1.0, std::hypot(state.curvature, state.taper));
  Eigen::Matrix<double, F::parameter_count, Model::size> derivative;
  for (int j = 0; j < Model::size; ++j) {
    const Step step = width * Step::Unit(j);
    derivative.col(j) =
        (feature_of(model.moved(state, step)).parameters() - feature_of(model.moved(state, -step)).parameters()) /
        (2.0 * width);
  }
  return derivative;
}

/// A solution as an estimate; `unit` is what its covariance is for a noise of one.
template <typename Model, typename FeatureOf>
auto estimate_of(const Model& model, const Solution<RoundState, Model::size>& solution, int rows,
                 const FitOptions& options, const FeatureOf& feature_of) {
  using F = decltype(feature_of(solution.state));
  struct Result {
    Estimate<F> estimate;
    std::optional<Covariance<F>> unit;
  } result;
  auto& estimate = result.estimate;
  estimate.feature = feature_of(solution.state);
  estimate.degrees_of_freedom = rows - Model::size;
  estimate.noise = noise_of(model.cloud, options, solution.cost, estimate.degrees_of_freedom);
  estimate.status = solution.status;
  estimate.steps = solution.steps;
  if (const auto unit = unit_covariance<Model::size>(solution.triangle)) {
    const auto derivative = parameters_by_step(model, solution.state, feature_of);
    result.unit = derivative * *unit * derivative.transpose();
    if (estimate.noise) {
      estimate.covariance = *estimate.noise * *estimate.noise * *result.unit;
    }
  }
  return result;
}

}  // namespace artcal::fitting
