#include "core/text/point_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace artcal {

std::string decimals_text(double value, double resolution) {
  constexpr double max_decimals = 12.0;
  const double decimals = std::clamp(std::ceil(-std::log10(resolution) - 1e-9), 0.0, max_decimals);
  const std::string text = fmt::format("{:.{}f}", value, static_cast<int>(decimals));
  return text.find_first_of("123456789") == std::string::npos && text.front() == '-' ? text.substr(1) : text;
}

std::string point_text(const Eigen::Vector3d& point, double resolution) {
  return fmt::format("({}, {}, {})", decimals_text(point.x(), resolution), decimals_text(point.y(), resolution),
                     decimals_text(point.z(), resolution));
}

}  // namespace artcal
