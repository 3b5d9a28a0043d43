#include "fitting/options.h"

#include <cmath>

#include <fmt/format.h>

namespace artcal::fitting {
namespace {

std::string_view name_of(Criterion criterion) {
  switch (criterion) {
    case Criterion::LeastSquares: return "least squares";
    case Criterion::MinimumZone: return "minimum zone";
    case Criterion::MinimumCircumscribed: return "minimum circumscribed";
    case Criterion::MaximumInscribed: return "maximum inscribed";
  }
  return "";
}

bool offered(Criterion criterion, const Abilities& abilities) {
  return criterion == Criterion::LeastSquares ||
         (criterion == Criterion::MinimumZone ? abilities.minimum_zone : abilities.enclosing);
}

bool positive(double value) { return std::isfinite(value) && value > 0.0; }

}  // namespace

Expected<void> check_options(const FitOptions& options, const Abilities& abilities) {
  const auto& [feature, minimum_zone, enclosing, fixed_radius, tip, tip_needs_towards] = abilities;
  if (!offered(options.criterion, abilities)) {
    return wrong_usage(fmt::format("there is no {} {}; ask for least squares", name_of(options.criterion), feature));
  }
  if (options.criterion != Criterion::LeastSquares && (options.weights.size() != 0 || options.fixed_radius)) {
    return wrong_usage(
        fmt::format("weights and a fixed radius belong to least squares, not to {}", name_of(options.criterion)));
  }
  if (options.fixed_radius && !fixed_radius) {
    return wrong_usage(fmt::format("a fixed radius is for a sphere, not for a {}", feature));
  }
  if (options.fixed_radius && !positive(*options.fixed_radius)) {
    return wrong_usage(fmt::format("the fixed radius is {} mm, expected a length above zero", *options.fixed_radius));
  }
  if (options.noise && !positive(*options.noise)) {
    return wrong_usage(fmt::format("the noise is {} mm, expected a length above zero", *options.noise));
  }
  if (!(options.tip_radius >= 0.0) || !std::isfinite(options.tip_radius)) {
    return wrong_usage(fmt::format("the tip radius is {} mm, expected zero or more", options.tip_radius));
  }
  if (options.side == Side::Inside && options.fixed_radius && options.tip_radius >= *options.fixed_radius) {
    return wrong_usage(fmt::format(
        "a tip of radius {:.6g} mm does not fit inside a {} of radius {:.6g} mm; is the side right, and the "
        "tip's diameter?",
        options.tip_radius, feature, *options.fixed_radius));
  }
  if (options.tip_radius > 0.0 && !tip) {
    return wrong_usage(fmt::format("a tip radius cannot be taken off a {}: it has no surface", feature));
  }
  if (options.tip_radius > 0.0 && tip_needs_towards && !options.towards) {
    return wrong_usage(
        fmt::format("a {} with a tip radius needs the direction from the material towards the probe", feature));
  }
  if (options.circle_normal && (feature != "circle" || options.circle == CircleConvention::Spatial)) {
    return wrong_usage(fmt::format("a known normal is for a circle that is projected onto its plane, not for a {}{}",
                                   feature == "circle" ? "spatial " : "", feature));
  }
  if (options.circle_normal && !(options.circle_normal->allFinite() && options.circle_normal->norm() > 0.0)) {
    return wrong_usage("the normal of the circle is zero or not finite");
  }
  if (options.towards && !(options.towards->allFinite() && options.towards->norm() > 0.0)) {
    return wrong_usage("the direction to point towards is zero or not finite");
  }
  return {};
}

}  // namespace artcal::fitting
