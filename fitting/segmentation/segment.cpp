#include "fitting/segmentation/segment.h"
#include "fitting/segmentation/spheres/other_unit.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/text/point_text.h"
#include "fitting/bounding_box.h"

namespace artcal {
namespace {

Expected<void> check(const ScanContents& wanted) {
  if (wanted.radii.empty() && wanted.planes <= 0) {
    return wrong_usage("there is no sphere and no plane to look for");
  }
  return {};
}

Pattern pattern_of(const ScanContents& wanted, const SegmentOptions& options) {
  Pattern pattern{wanted.radii, wanted.distances, 1.0};
  if (!wanted.radii.empty()) {
    pattern.tolerance = options.tolerance.value_or(0.1 * *std::min_element(wanted.radii.begin(), wanted.radii.end()));
  }
  return pattern;
}

std::vector<FoundPoint> found_points(const std::vector<FoundSphere>& spheres) {
  std::vector<FoundPoint> points;
  for (const FoundSphere& sphere : spheres) {
    points.push_back({sphere.fitted.feature.centre, sphere.radius_wanted});
  }
  return points;
}

RejectedSphere stray(const FoundSphere& sphere) {
  const Eigen::Vector3d& c = sphere.fitted.feature.centre;
  return {sphere.fitted.feature, static_cast<int>(sphere.points.size()), RejectionReason::Stray,
          fmt::format("a sphere of the right radius at {}, but at no certified distance from the others",
                      point_text(c, 0.01 * sphere.radius_wanted))};
}

SegmentStatus status_of(const Segmentation& result, const ScanContents& wanted, std::size_t found) {
  if (found == 0 && result.planes.empty()) {
    return SegmentStatus::Nothing;
  }
  if (!result.matching.unmet.empty()) {
    return SegmentStatus::NotThere;
  }
  if (result.matching.ways.size() > 1) {
    return SegmentStatus::Ambiguous;
  }
  if (found > 0 && result.matching.ways.empty()) {
    return SegmentStatus::NoMatch;
  }
  const bool all_spheres =
      wanted.radii.empty() ||
      (!result.matching.ways.empty() && result.matching.ways.front().count == static_cast<int>(wanted.radii.size()));
  const bool all_planes = static_cast<int>(result.planes.size()) == wanted.planes;
  return all_spheres && all_planes ? SegmentStatus::Complete : SegmentStatus::Partial;
}

std::vector<std::optional<FoundSphere>> all_of(std::vector<FoundSphere>& spheres) {
  return {std::make_move_iterator(spheres.begin()), std::make_move_iterator(spheres.end())};
}

// By the certificate's order; what it has no use for is a stray.
std::vector<std::optional<FoundSphere>> named(std::vector<FoundSphere>& spheres, const Assignment& way,
                                              std::vector<RejectedSphere>& rejected) {
  std::vector<std::optional<FoundSphere>> ordered(way.found.size());
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const auto at = std::find(way.found.begin(), way.found.end(), static_cast<int>(i));
    if (at == way.found.end()) {
      rejected.push_back(stray(spheres[i]));
    } else {
      ordered[static_cast<std::size_t>(at - way.found.begin())] = std::move(spheres[i]);
    }
  }
  return ordered;
}

PlaneSearch plane_search(const Points& points, const ScanContents& wanted, const std::vector<FoundSphere>& spheres) {
  PlaneSearch search;
  search.count = wanted.planes;
  const double diagonal = fitting::bounding_box(points).size().norm();
  // Some thirty points a cube, were they spread over a surface as large as the room they stand in.
  search.patch = std::max(diagonal * std::sqrt(30.0 / static_cast<double>(points.cols())), 1e-6 * diagonal);
  for (const FoundSphere& sphere : spheres) {
    search.taken.insert(search.taken.end(), sphere.points.begin(), sphere.points.end());
  }
  std::sort(search.taken.begin(), search.taken.end());
  return search;
}

}  // namespace

Expected<Segmentation> segment(const Points& points, const ScanContents& wanted, const SegmentOptions& options) {
  if (auto checked = check(wanted); !checked) {
    return tl::unexpected(checked.error());
  }
  auto spheres =
      find_spheres(points, {wanted.radii, options.radius_tolerance, options.fixed_radius, options.distortion});
  if (!spheres) {
    return tl::unexpected(spheres.error());
  }
  Segmentation result;
  result.rejected = std::move(spheres->rejected);
  const Pattern pattern = pattern_of(wanted, options);
  result.tolerance = pattern.tolerance;
  if (!wanted.radii.empty()) {
    auto matching = match(pattern, found_points(spheres->spheres), options.hints);
    if (!matching) {
      return tl::unexpected(matching.error());
    }
    result.matching = std::move(*matching);
  }
  if (wanted.planes > 0 && points.cols() > 0) {
    auto planes = find_planes(points, plane_search(points, wanted, spheres->spheres));
    if (!planes) {
      return tl::unexpected(planes.error());
    }
    result.planes = std::move(*planes);
  }
  result.status = status_of(result, wanted, spheres->spheres.size());
  const bool told = result.matching.ways.size() == 1;
  result.spheres =
      told ? named(spheres->spheres, result.matching.ways.front(), result.rejected) : all_of(spheres->spheres);
  if (spheres->spheres.empty() && !wanted.radii.empty()) {
    if (const auto unit = other_unit(points, wanted, options)) {
      result.warnings.push_back(
          fmt::format("the points look like {}: taken so, there are spheres of the radius wanted", *unit));
    }
  }
  return result;
}

}  // namespace artcal
