// Spheres in scans, beside CGAL's Efficient RANSAC asked for the same: spheres of this radius, in one run on one scan.
#include <benchmark/benchmark.h>

#include <CGAL/Shape_detection/Efficient_RANSAC.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>
#include <sys/resource.h>

#include "fitting/segmentation/spheres/find_spheres.h"
#include "tests/support/scans.h"

namespace {

using namespace artcal;
using testing::SimulatedScan;

constexpr double radius = 12.7;

// Three balls on stems, a bar and a table; about this many points, two thirds of them on the table and the bar.
const SimulatedScan& scan_of(int points) {
  static std::map<int, SimulatedScan> scans;
  const auto known = scans.find(points);
  if (known != scans.end()) {
    return known->second;
  }
  testing::ScanSettings settings;
  settings.centres = testing::ball_bar({0.0, 300.0, 500.0});
  const double thinning = std::sqrt(160'000.0 / points);
  settings.spacing = 0.72 * thinning;
  settings.ball_spacing = 0.29 * thinning;
  return scans.emplace(points, testing::simulate_scan(settings)).first->second;
}

double worst_error(const SimulatedScan& scan, const std::vector<Eigen::Vector3d>& found) {
  double worst = 0.0;
  for (const auto& truth : scan.centres) {
    double nearest = 1e9;
    for (const auto& centre : found) nearest = std::min(nearest, (centre - truth).norm());
    worst = std::max(worst, nearest);
  }
  return worst;
}

double worst_limit(const SimulatedScan& scan) {
  double worst = 0.0;
  for (std::size_t i = 0; i < scan.centres.size(); ++i) {
    const auto limit = testing::least_squares_limit(scan, static_cast<int>(i), scan.centres[i], radius);
    worst = std::max(worst, (limit - scan.centres[i]).norm());
  }
  return worst;
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void artcal_find_spheres(benchmark::State& state) {
  const SimulatedScan& scan = scan_of(static_cast<int>(state.range(0)));
  std::vector<Eigen::Vector3d> found;
  for (auto _ : state) {
    const auto result = find_spheres(scan.points, {{radius}});
    found.clear();
    for (const auto& sphere : result->spheres) found.push_back(sphere.fitted.feature.centre);
  }
  state.counters["points"] = static_cast<double>(scan.points.cols());
  state.counters["found"] = static_cast<double>(found.size());
  state.counters["worst_um"] = 1e3 * worst_error(scan, found);
  state.counters["limit_um"] = 1e3 * worst_limit(scan);
  state.counters["peak_MB"] = peak_megabytes();
}
BENCHMARK(artcal_find_spheres)->Arg(160'000)->Unit(benchmark::kMillisecond);

using Kernel = CGAL::Simple_cartesian<double>;
using Oriented = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Traits = CGAL::Shape_detection::Efficient_RANSAC_traits<Kernel, std::vector<Oriented>,
                                                              CGAL::First_of_pair_property_map<Oriented>,
                                                              CGAL::Second_of_pair_property_map<Oriented>>;
using Ransac = CGAL::Shape_detection::Efficient_RANSAC<Traits>;

// Spheres and planes are looked for, and only spheres of this radius are counted. It needs a normal for each point,
// which a scan does not have: given to it as they truly are on each ball, and straight up elsewhere, or estimated by
// CGAL.
void cgal_efficient_ransac(benchmark::State& state) {
  const bool normals_are_given = state.range(1) != 0;
  const SimulatedScan& scan = scan_of(static_cast<int>(state.range(0)));
  std::vector<Oriented> points;
  for (Eigen::Index i = 0; i < scan.points.cols(); ++i) {
    const Eigen::Vector3d p = scan.points.col(i);
    const int label = scan.labels[static_cast<std::size_t>(i)];
    const Eigen::Vector3d up = (scan.centres[1] - scan.centres[0]).unitOrthogonal();
    const Eigen::Vector3d n = label >= 0 ? (p - scan.centres[static_cast<std::size_t>(label)]).normalized() : up;
    points.emplace_back(Kernel::Point_3(p.x(), p.y(), p.z()), Kernel::Vector_3(n.x(), n.y(), n.z()));
  }
  std::vector<Eigen::Vector3d> found;
  for (auto _ : state) {
    if (!normals_are_given) {
      CGAL::pca_estimate_normals<CGAL::Sequential_tag>(
          points, 12,
          CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Oriented>())
              .normal_map(CGAL::Second_of_pair_property_map<Oriented>()));
    }
    Ransac ransac;
    ransac.set_input(points);
    ransac.add_shape_factory<CGAL::Shape_detection::Plane<Traits>>();
    ransac.add_shape_factory<CGAL::Shape_detection::Sphere<Traits>>();
    Ransac::Parameters parameters;
    parameters.probability = 0.01;
    parameters.min_points = 500;
    parameters.epsilon = 0.08;  // four standard deviations of the noise
    parameters.cluster_epsilon = 2.0;
    parameters.normal_threshold = 0.9;
    ransac.detect(parameters);
    found.clear();
    for (const auto& shape : ransac.shapes()) {
      const auto* sphere = dynamic_cast<CGAL::Shape_detection::Sphere<Traits>*>(shape.get());
      if (sphere != nullptr && std::abs(sphere->radius() - radius) < 0.02 * radius) {
        found.emplace_back(sphere->center().x(), sphere->center().y(), sphere->center().z());
      }
    }
  }
  state.counters["points"] = static_cast<double>(points.size());
  state.counters["found"] = static_cast<double>(found.size());
  state.counters["worst_um"] = 1e3 * worst_error(scan, found);
}
BENCHMARK(cgal_efficient_ransac)
    ->ArgNames({"points", "normals_given"})
    ->Args({160'000, 1})
    ->Args({160'000, 0})
    ->Unit(benchmark::kMillisecond);

BENCHMARK(artcal_find_spheres)->Arg(1'000'000)->Arg(10'000'000)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace
