// How exact a least-squares sphere is by artcal, Ceres and PCL, on NIST's spheres, whose answers are known from
// elsewhere (docs/dependencies.md). Not a benchmark of time.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <ceres/ceres.h>
#include <fmt/format.h>

#include "bench/pcl_sphere.h"
#include "fitting/fit.h"

namespace {

namespace fs = std::filesystem;

struct Pair {
  Eigen::Matrix3Xd points;
  Eigen::Vector4d answer;  // centre, diameter
};

std::vector<double> numbers_in(const fs::path& path) {
  std::ifstream stream(path);
  return {std::istream_iterator<double>(stream), {}};
}

Pair read_pair(fs::path data) {
  const auto numbers = numbers_in(data);
  const auto count = static_cast<Eigen::Index>(numbers.at(0));
  return {Eigen::Map<const Eigen::Matrix3Xd>(numbers.data() + 1, 3, count),
          Eigen::Vector4d::Map(numbers_in(data.replace_extension(".fit")).data())};
}

struct Distance {
  Eigen::Vector3d point;
  template <typename Number>
  bool operator()(const Number* sphere, Number* residual) const {
    const Number x = point[0] - sphere[0], y = point[1] - sphere[1], z = point[2] - sphere[2];
    residual[0] = ceres::sqrt(x * x + y * y + z * z) - sphere[3];
    return true;
  }
};

// Centre and radius. With `tolerance` 0 Ceres' own tolerances stay.
Eigen::Vector4d by_ceres(const Eigen::Matrix3Xd& points, Eigen::Vector4d sphere, double tolerance) {
  ceres::Problem problem;
  for (const auto& point : points.colwise()) {
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Distance, 1, 4>(new Distance{point}), nullptr,
                             sphere.data());
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  if (tolerance > 0.0) {
    options.function_tolerance = options.gradient_tolerance = options.parameter_tolerance = tolerance;
    options.max_num_iterations = 200;
  }
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return sphere;
}

// Coordinates about the centroid, since PCL has floats.
Eigen::Vector4d by_pcl(const Eigen::Matrix3Xd& points, Eigen::Vector4d sphere) {
  const Eigen::Vector3d middle = points.rowwise().mean();
  sphere.head<3>() -= middle;
  sphere = PclSphere(points.colwise() - middle).refine(sphere.cast<float>()).cast<double>();
  sphere.head<3>() += middle;
  return sphere;
}

// The larger of the errors of centre and diameter, mm.
double error(const Eigen::Vector4d& sphere, const Pair& pair) {
  return std::max((sphere - pair.answer).head<3>().norm(), std::abs(2.0 * sphere[3] - pair.answer[3]));
}

}  // namespace

int main() {
  std::map<std::string, double> worst;
  int pairs = 0;
  const fs::path folder = fs::path(ARTCAL_SOURCE_DIR) / "tests/reference/nist-geometric-elements/Sphere";
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".ds") {
      continue;
    }
    const Pair pair = read_pair(entry.path());
    // A start that is off by a twentieth of the diameter, which artcal does not need.
    Eigen::Vector4d start = pair.answer;
    start.head<3>() += 0.05 * pair.answer[3] * Eigen::Vector3d(1.0, -1.0, 0.5);
    start[3] *= 0.525;
    const auto note = [&](const std::string& by, const Eigen::Vector4d& sphere) {
      worst[by] = std::max(worst[by], error(sphere, pair));
    };
    const auto own = artcal::fit<artcal::Sphere>(pair.points);
    note("artcal", own ? (Eigen::Vector4d() << own->feature.centre, own->feature.radius).finished() : start);
    note("Ceres, its defaults", by_ceres(pair.points, start, 0.0));
    note("Ceres, tolerances 1e-16", by_ceres(pair.points, start, 1e-16));
    note("PCL", by_pcl(pair.points, start));
    ++pairs;
  }
  for (const auto& [by, off] : worst) {
    std::puts(fmt::format("{:<26}{:.2g} mm at worst of {} spheres", by, off, pairs).c_str());
  }
}
