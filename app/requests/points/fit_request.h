#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "fitting/fit.h"

namespace artcal {

enum class Shape { Sphere, Plane, Line, Circle, Cylinder, Cone };

/// The word for it on the command line and in results.
std::string_view name_of(Shape shape);
std::string_view name_of(Criterion criterion);

/// What `artcal fit` was asked, in words.
struct FitWords {
  std::string shape, unit, criterion = "least-squares";
  std::string diameter, tip_diameter, noise;  ///< a number with its unit, or empty
  bool inside = false, spatial = false, robust = false;
  std::vector<double> towards, normal;
};

/// The same, understood.
struct FitRequest {
  Shape shape = Shape::Sphere;
  std::string unit;          ///< of the file
  double unit_factor = 1.0;  ///< mm per unit
  FitOptions options;
  bool robust = false;
};

/// Usage errors for units and quantities that are none, and for what contradicts itself.
Expected<FitRequest> parse(const FitWords& words);

/// The words that --shape and --criterion take.
std::vector<std::string> shape_names();
std::vector<std::string> criterion_names();

}  // namespace artcal
