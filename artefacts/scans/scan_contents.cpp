#include "artefacts/scans/scan_contents.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

Eigen::MatrixXd distances_between(const Artefact& artefact, const std::vector<int>& spheres) {
  const auto count = static_cast<Eigen::Index>(spheres.size());
  Eigen::MatrixXd distances = Eigen::MatrixXd::Constant(count, count, std::numeric_limits<double>::quiet_NaN());
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < count; ++j) {
      const auto& from = artefact.features[spheres[static_cast<std::size_t>(i)]].at;
      const auto& to = artefact.features[spheres[static_cast<std::size_t>(j)]].at;
      if (from && to) {
        distances(i, j) = (*from - *to).norm();
      }
    }
  }
  const auto place = [&](int feature) { return std::find(spheres.begin(), spheres.end(), feature) - spheres.begin(); };
  for (const CertifiedDistance& distance : artefact.distances) {
    const Eigen::Index i = place(distance.first);
    const Eigen::Index j = place(distance.second);
    if (i < count && j < count) {
      distances(i, j) = distances(j, i) = distance.value;
    }
  }
  return distances;
}

}  // namespace

Expected<ArtefactInScan> scan_contents(const Artefact& artefact, double temperature) {
  ArtefactInScan scan;
  const double expansion = artefact.expansion_factor(temperature);
  for (int i = 0; i < static_cast<int>(artefact.features.size()); ++i) {
    const CertifiedFeature& feature = artefact.features[i];
    if (feature.kind == FeatureKind::Plane) {
      scan.planes.push_back(i);
    } else if (feature.kind == FeatureKind::Sphere) {
      if (!feature.radius) {
        return bad_input(
            fmt::format("the sphere {} of the artefact {} has no diameter; a scan is searched for spheres of "
                        "known diameter",
                        in_quotes(feature.name), in_quotes(artefact.name)));
      }
      scan.spheres.push_back(i);
      scan.contents.radii.push_back(*feature.radius * expansion);
    }
  }
  if (scan.spheres.empty() && scan.planes.empty()) {
    return bad_input(fmt::format("the artefact {} has no sphere and no plane, which are what a scan is searched for",
                                 in_quotes(artefact.name)));
  }
  scan.contents.planes = static_cast<int>(scan.planes.size());
  scan.contents.distances = distances_between(artefact, scan.spheres) * expansion;
  for (Eigen::Index i = 0; i < scan.contents.distances.rows(); ++i) {
    for (Eigen::Index j = 0; j < i; ++j) {
      const double room =
          scan.contents.radii[static_cast<std::size_t>(i)] + scan.contents.radii[static_cast<std::size_t>(j)];
      if (scan.contents.distances(i, j) < 0.99 * room) {
        return bad_input(
            fmt::format("the spheres {} and {} of the artefact {} are {:.6g} mm apart, less than the {:.6g} mm "
                        "that their radii take",
                        in_quotes(artefact.features[scan.spheres[static_cast<std::size_t>(i)]].name),
                        in_quotes(artefact.features[scan.spheres[static_cast<std::size_t>(j)]].name),
                        in_quotes(artefact.name), scan.contents.distances(i, j), room));
      }
    }
  }
  return scan;
}

}  // namespace artcal
