#include "app/results/fit/feature_values.h"

#include <cmath>
#include <type_traits>

namespace artcal {
namespace {

template <typename F>
inline constexpr bool has_centre = std::is_same_v<F, Sphere> || std::is_same_v<F, Circle>;
template <typename F>
inline constexpr bool has_normal = std::is_same_v<F, Plane> || std::is_same_v<F, Circle>;
template <typename F>
inline constexpr bool is_round = !std::is_same_v<F, Plane> && !std::is_same_v<F, Line>;

/// A value linear in the parameters: its uncertainty is that of `row` times them.
template <typename F>
using Row = Eigen::Matrix<double, 1, F::parameter_count>;

template <typename F>
FeatureValue value_of(const Fitted<F>& fitted, std::string name, std::string unit, double value, const Row<F>& row) {
  FeatureValue result{std::move(name), std::move(unit), value, {}};
  if (fitted.covariance) {
    const double variance = row * *fitted.covariance * row.transpose();
    result.u = std::sqrt(std::max(variance, 0.0));
  }
  return result;
}

// The apex p - d·r/tan φ: how it moves with (p, d, r, φ).
std::vector<FeatureValue> apex_values(const Fitted<Cone>& fitted) {
  const Cone& cone = fitted.feature;
  const Eigen::Vector3d apex = cone.apex();
  const double sine = std::sin(cone.half_angle);
  const double height = cone.radius / std::tan(cone.half_angle);
  std::vector<FeatureValue> values;
  for (int axis = 0; axis < 3; ++axis) {
    Row<Cone> row = Row<Cone>::Zero();
    row[axis] = 1.0;
    row[3 + axis] = -height;
    row[6] = -cone.direction[axis] / std::tan(cone.half_angle);
    row[7] = cone.direction[axis] * cone.radius / (sine * sine);
    values.push_back(value_of(fitted, std::string("apex ") + "xyz"[axis], "mm", apex[axis], row));
  }
  return values;
}

}  // namespace

template <typename F>
std::vector<std::string> parameter_names() {
  std::vector<std::string> names;
  for (const char axis : {'x', 'y', 'z'}) {
    names.push_back(std::string(has_centre<F> ? "centre " : "point ") + axis);
  }
  if constexpr (!std::is_same_v<F, Sphere>) {
    for (const char axis : {'x', 'y', 'z'}) {
      names.push_back(std::string(has_normal<F> ? "normal " : "direction ") + axis);
    }
  }
  if constexpr (is_round<F>) {
    names.emplace_back("radius");
  }
  if constexpr (std::is_same_v<F, Cone>) {
    names.emplace_back("half angle");
  }
  return names;
}

template <typename F>
std::vector<FeatureValue> feature_values(const Fitted<F>& fitted) {
  const auto parameters = fitted.feature.parameters();
  const auto names = parameter_names<F>();
  std::vector<FeatureValue> values;
  for (int i = 0; i < F::parameter_count; ++i) {
    Row<F> row = Row<F>::Zero();
    const bool doubled = names[i] == "radius" || names[i] == "half angle";
    row[i] = doubled ? 2.0 : 1.0;
    const std::string name = names[i] == "radius" ? "diameter" : names[i] == "half angle" ? "apex angle" : names[i];
    const std::string unit = name == "apex angle" ? "rad" : i < 3 || doubled ? "mm" : "1";
    values.push_back(value_of(fitted, name, unit, row[i] * parameters[i], row));
  }
  if constexpr (std::is_same_v<F, Cone>) {
    for (FeatureValue& value : apex_values(fitted)) {
      values.push_back(std::move(value));
    }
  }
  return values;
}

template std::vector<std::string> parameter_names<Sphere>();
template std::vector<std::string> parameter_names<Plane>();
template std::vector<std::string> parameter_names<Line>();
template std::vector<std::string> parameter_names<Circle>();
template std::vector<std::string> parameter_names<Cylinder>();
template std::vector<std::string> parameter_names<Cone>();
template std::vector<FeatureValue> feature_values(const Fitted<Sphere>&);
template std::vector<FeatureValue> feature_values(const Fitted<Plane>&);
template std::vector<FeatureValue> feature_values(const Fitted<Line>&);
template std::vector<FeatureValue> feature_values(const Fitted<Circle>&);
template std::vector<FeatureValue> feature_values(const Fitted<Cylinder>&);
template std::vector<FeatureValue> feature_values(const Fitted<Cone>&);

}  // namespace artcal
