#include "fitting/least_squares/estimate.h"

#include <fmt/format.h>

namespace artcal::fitting {

std::optional<std::string> scatter_hides(std::string_view feature, const Cloud& cloud, double noise, double radius) {
  constexpr double much = 0.05;  // of the radius
  if (!(noise > much * std::abs(radius))) {
    return std::nullopt;
  }
  return fmt::format(
      "the points do not determine a {}: they scatter by {:.3g} mm about the best one, of radius {:.4g} mm; are there "
      "outliers among them, which a robust fit lists, or points of something else?",
      feature, noise * cloud.scale, std::abs(radius) * cloud.scale);
}

std::string as_noise_shows(const Cloud& cloud, double noise) {
  constexpr double roundings = 1e3;
  return noise > roundings * cloud.rounding
             ? fmt::format(", as far as their noise of {:.2g} mm shows", noise * cloud.scale)
             : "";
}

}  // namespace artcal::fitting
