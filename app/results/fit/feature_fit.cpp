#include "app/results/fit/feature_fit.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/results/unit_check.h"
#include "fitting/robust/robust.h"

namespace artcal {
namespace {

constexpr double telling = 0.1;  // a diameter with a larger share of doubt says nothing about the unit

template <typename F>
Expected<RobustFitted<F>> fit_either(const PointCloud& cloud, const FitRequest& request) {
  if (request.robust) {
    return fit_robust<F>(cloud.points, request.options);
  }
  return fit<F>(cloud.points, request.options).map([](Fitted<F>&& fitted) {
    return RobustFitted<F>{std::move(fitted), {}};
  });
}

// The diameter that the points themselves have; nothing where they do not tell it.
std::optional<FeatureValue> free_diameter_of(const PointCloud& cloud, const FitRequest& request) {
  FitRequest free = request;
  free.options.fixed_radius.reset();
  const auto fitted = fit_either<Sphere>(cloud, free);
  if (!fitted) {
    return std::nullopt;
  }
  FeatureValue diameter = feature_values(fitted->fitted)[3];
  return diameter.u && *diameter.u < telling * diameter.value ? std::optional(diameter) : std::nullopt;
}

// A diameter that is wrong by more than a fifth is another object or another unit.
Expected<void> check_diameter(const FeatureValue& free, const FitRequest& request, const std::string& path) {
  const double stated = 2.0 * *request.options.fixed_radius;
  if (std::abs(free.value / stated - 1.0) <= 0.2) {
    return {};
  }
  const std::string found =
      fmt::format("the points lie on a sphere of diameter {:.6g} mm when read in {}, but {:.6g} mm are stated",
                  free.value, request.unit, stated);
  const auto unit = likelier_unit(free.value, stated, request.unit_factor);
  return bad_input(unit ? fmt::format("{}: the coordinates look like {}; check --unit", found, *unit)
                        : found + "; check --diameter, --tip-diameter and whether these are the right points",
                   path);
}

void compare_diameters(const FeatureValue& free, const FitRequest& request, FeatureFit& result) {
  const double difference = free.value - 2.0 * *request.options.fixed_radius;
  if (std::abs(difference) > 5.0 * *free.u) {
    result.warnings.push_back(fmt::format(
        "left free, the diameter comes out as {:.5f} mm, {:+.5f} mm from the stated one and more than five times its "
        "standard uncertainty of {:.2g} mm",
        free.value, difference, *free.u));
  }
}

template <typename F>
FeatureFit describe(const RobustFitted<F>& robust, const PointCloud& cloud) {
  const Fitted<F>& fitted = robust.fitted;
  FeatureFit result;
  result.values = feature_values(fitted);
  result.parameters = parameter_names<F>();
  if (fitted.covariance) {
    result.covariance = *fitted.covariance;
  }
  result.form = fitted.form;
  result.rms = fitted.rms;
  result.noise = fitted.noise;
  result.degrees_of_freedom = fitted.degrees_of_freedom;
  result.steps = fitted.steps;
  const auto deviation = [&](Eigen::Index i) {
    return RowDeviation{cloud.rows[static_cast<std::size_t>(i)], fitted.residuals[i]};
  };
  auto next = robust.outliers.begin();
  for (Eigen::Index i = 0; i < fitted.residuals.size(); ++i) {
    if (next != robust.outliers.end() && *next == i) {
      result.outliers.push_back(deviation(i));
      ++next;
      continue;
    }
    const RowDeviation here = deviation(i);
    result.lowest = result.points == 0 || here.mm < result.lowest.mm ? here : result.lowest;
    result.highest = result.points == 0 || here.mm > result.highest.mm ? here : result.highest;
    ++result.points;
  }
  return result;
}

template <typename F>
Expected<FeatureFit> fit_as(const PointCloud& cloud, const FitRequest& request) {
  const bool stated = std::is_same_v<F, Sphere> && request.options.fixed_radius.has_value();
  const auto robust = fit_either<F>(cloud, request);
  if (!robust && robust.error().code == ErrorCode::Usage) {
    return tl::unexpected(robust.error());  // options that cannot be, before the points are blamed
  }
  const auto free = stated ? free_diameter_of(cloud, request) : std::nullopt;
  if (free) {
    if (auto checked = check_diameter(*free, request, cloud.input.path); !checked) {
      return tl::unexpected(checked.error());
    }
  }
  if (!robust) {
    Error error = robust.error();
    error.where = error.code == ErrorCode::Usage ? "" : cloud.input.path;
    return tl::unexpected(error);
  }
  if (robust->fitted.status != FitStatus::Converged) {
    return no_solution(fmt::format("the fit was still moving after {} steps; the points do not settle on one {}",
                                   robust->fitted.steps, name_of(request.shape)));
  }
  FeatureFit result = describe(*robust, cloud);
  if (stated) {
    result.values[3].u.reset();
  }
  if (free) {
    result.free_diameter = free;
    compare_diameters(*free, request, result);
  }
  return result;
}

}  // namespace

Expected<FeatureFit> fit_feature(const PointCloud& cloud, const FitRequest& request) {
  switch (request.shape) {
    case Shape::Sphere: return fit_as<Sphere>(cloud, request);
    case Shape::Plane: return fit_as<Plane>(cloud, request);
    case Shape::Line: return fit_as<Line>(cloud, request);
    case Shape::Circle: return fit_as<Circle>(cloud, request);
    case Shape::Cylinder: return fit_as<Cylinder>(cloud, request);
    case Shape::Cone: break;
  }
  return fit_as<Cone>(cloud, request);
}

}  // namespace artcal
