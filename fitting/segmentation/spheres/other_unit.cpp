#include "fitting/segmentation/spheres/other_unit.h"

#include <array>
#include <utility>

#include "core/units.h"

namespace artcal {
namespace {

// What the points would have to be multiplied by, and what that would make their unit.
constexpr std::array<std::pair<double, const char*>, 4> mistakes{{
    {units::metre / units::millimetre, "metres read as millimetres"},
    {units::millimetre / units::metre, "millimetres read as metres"},
    {units::inch / units::millimetre, "inches read as millimetres"},
    {units::millimetre / units::inch, "millimetres read as inches"},
}};

}  // namespace

std::optional<std::string> other_unit(const Points& points, const ScanContents& wanted, const SegmentOptions& options) {
  for (const auto& [factor, name] : mistakes) {
    SphereSearch search{wanted.radii, options.radius_tolerance, options.fixed_radius};
    for (double& radius : search.radii) {
      radius /= factor;
    }
    const auto found = find_spheres(points, search);
    if (found && !found->spheres.empty()) {
      return name;
    }
  }
  return std::nullopt;
}

}  // namespace artcal
