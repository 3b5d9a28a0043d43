#include "app/results/fit/segment_result.h"

#include <algorithm>
#include <cmath>

namespace artcal {

const std::string& sphere_name(const SegmentResult& result, std::size_t sphere) {
  return result.artefact.features[static_cast<std::size_t>(result.wanted.spheres[sphere])].name;
}

const std::string& plane_name(const SegmentResult& result, std::size_t plane) {
  return result.artefact.features[static_cast<std::size_t>(result.wanted.planes[plane])].name;
}

std::vector<std::string> missing_names(const SegmentResult& result) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < result.wanted.spheres.size(); ++i) {
    if (i >= result.segmentation.spheres.size() || !result.segmentation.spheres[i]) {
      names.push_back(sphere_name(result, i));
    }
  }
  for (std::size_t i = result.segmentation.planes.size(); i < result.wanted.planes.size(); ++i) {
    names.push_back(plane_name(result, i));
  }
  return names;
}

namespace {

// As the certificate states it, else from its coordinates.
StatedValue stated_between(const SegmentResult& result, int i, int j) {
  const Artefact& artefact = result.artefact;
  const int first = result.wanted.spheres[static_cast<std::size_t>(i)];
  const int second = result.wanted.spheres[static_cast<std::size_t>(j)];
  for (const CertifiedDistance& distance : artefact.distances) {
    if (std::minmax(distance.first, distance.second) == std::minmax(first, second)) {
      return artefact.stated(distance);
    }
  }
  const auto& from = artefact.features[static_cast<std::size_t>(first)].at;
  const auto& to = artefact.features[static_cast<std::size_t>(second)].at;
  // Along a row the certificate states steps; what they add up to holds at the reference temperature.
  const double by_steps = result.wanted.contents.distances(i, j) / artefact.expansion_factor(result.temperature);
  return {from && to ? (*to - *from).norm() : by_steps, artefact.reference_temperature};
}

}  // namespace

std::vector<SeenDistance> seen_distances(const SegmentResult& result) {
  std::vector<SeenDistance> distances;
  const auto& spheres = result.segmentation.spheres;
  const Eigen::MatrixXd& certified = result.wanted.contents.distances;
  for (int i = 0; i < static_cast<int>(certified.rows()); ++i) {
    for (int j = i + 1; j < static_cast<int>(certified.cols()); ++j) {
      const auto& a = spheres[static_cast<std::size_t>(i)];
      const auto& b = spheres[static_cast<std::size_t>(j)];
      if (a && b && std::isfinite(certified(i, j))) {
        distances.push_back({i, j, stated_between(result, i, j), certified(i, j),
                             (a->fitted.feature.centre - b->fitted.feature.centre).norm()});
      }
    }
  }
  return distances;
}

}  // namespace artcal
