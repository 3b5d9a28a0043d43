// Speed of the fits. The bounds that matter are ratios within one run: a fit of a million points against
// reading them, twice (a plain loop, and the fastest sum the compiler makes of them).
#include <cmath>

#include <benchmark/benchmark.h>

#include "bench/pcl_sphere.h"
#include "core/random.h"
#include "fitting/fit.h"
#include "fitting/robust/robust.h"

namespace {

using namespace artcal;

// The upper half of a ball of 12.7 mm, 10 µm of noise, away from the origin.
Eigen::Matrix3Xd half_ball(Eigen::Index count) {
  RandomStream random(1, "benchmark");
  Eigen::Matrix3Xd points(3, count);
  for (auto&& p : points.colwise()) {
    Eigen::Vector3d direction = random.direction();
    direction.z() = std::abs(direction.z());
    p = Eigen::Vector3d(500.0, 300.0, -200.0) + (12.7 + 0.01 * random.normal()) * direction;
  }
  return points;
}

Eigen::Matrix3Xd tube(Eigen::Index count) {
  RandomStream random(2, "benchmark");
  Eigen::Matrix3Xd points(3, count);
  for (auto&& p : points.colwise()) {
    const double angle = random.uniform(0.0, 6.283);
    const double radius = 9.0 + 0.01 * random.normal();
    p = Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), random.uniform(-20.0, 20.0));
  }
  return points;
}

void read_plain_loop(benchmark::State& state) {
  const auto points = half_ball(state.range(0));
  for (auto _ : state) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < points.size(); ++i) {
      sum += points.data()[i];
    }
    benchmark::DoNotOptimize(sum);
  }
}
BENCHMARK(read_plain_loop)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void read_vectorised(benchmark::State& state) {
  const auto points = half_ball(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(points.sum());
  }
}
BENCHMARK(read_vectorised)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

template <typename F>
void fit_points(benchmark::State& state, const Eigen::Matrix3Xd& points) {
  for (auto _ : state) {
    const auto fitted = fit<F>(points);
    if (!fitted) {
      state.SkipWithError("the fit failed");
    }
    benchmark::DoNotOptimize(fitted);
  }
}

// The peer, on the same points about their centroid, which floats need, and from a start 0.1 mm off.
void sphere_by_pcl(benchmark::State& state) {
  Eigen::Matrix3Xd points = half_ball(state.range(0));
  const Eigen::Vector3d centroid = points.rowwise().mean();
  points.colwise() -= centroid;
  const PclSphere pcl(points);
  const Eigen::Vector3d truth = Eigen::Vector3d(500.0, 300.0, -200.0) - centroid;
  const Eigen::Vector4d start(truth.x() + 0.1, truth.y() - 0.1, truth.z() + 0.1, 12.8);
  Eigen::Vector4f refined;
  for (auto _ : state) {
    refined = pcl.refine(start.cast<float>());
    benchmark::DoNotOptimize(refined);
  }
  state.counters["off_um"] = 1e3 * (refined.head<3>().cast<double>() - truth).norm();
}
BENCHMARK(sphere_by_pcl)->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void sphere(benchmark::State& state) { fit_points<Sphere>(state, half_ball(state.range(0))); }
BENCHMARK(sphere)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(sphere)->Arg(25)->Unit(benchmark::kMicrosecond);

void cylinder(benchmark::State& state) { fit_points<Cylinder>(state, tube(state.range(0))); }
BENCHMARK(cylinder)->Arg(25)->Arg(10'000)->Unit(benchmark::kMicrosecond);

void minimum_zone_sphere(benchmark::State& state) {
  const auto points = half_ball(state.range(0));
  FitOptions options;
  options.criterion = Criterion::MinimumZone;
  for (auto _ : state) {
    benchmark::DoNotOptimize(fit<Sphere>(points, options));
  }
}
BENCHMARK(minimum_zone_sphere)->Arg(25)->Arg(10'000)->Unit(benchmark::kMicrosecond);

void robust_sphere(benchmark::State& state) {
  const auto points = half_ball(state.range(0));
  for (auto _ : state) {
    benchmark::DoNotOptimize(fit_robust<Sphere>(points));
  }
}
BENCHMARK(robust_sphere)->Arg(25)->Unit(benchmark::kMicrosecond);

}  // namespace
