// Identification of the arm of Gao 2013 (23 of 25 parameters) from known coordinates of random postures,
// ours beside the same least squares written with Ceres' automatic differentiation, in one run. Both
// start at the nominal arm, use one thread and stop by the same tolerances.
#include <array>
#include <cmath>
#include <numbers>

#include <benchmark/benchmark.h>
#include <ceres/ceres.h>

#include "artefacts/virtual_probing/virtual_probing.h"
#include "core/normal_vector.h"
#include "core/random.h"
#include "identification/identifiability/coupling.h"
#include "identification/identify.h"
#include "identification/least_squares/arm_fit.h"
#include "identification/uncertainty/covariance.h"
#include "tests/support/arms.h"

namespace artcal {
namespace {

constexpr double noise_mm = 0.01;

/// Noisy readings of a slightly wrong arm.
struct Task {
  Recording recording;
  Constraints constraints;
  std::vector<Parameter> free;
};

Task make_task(int poses) {
  RandomStream random(7, "benchmark");
  Arm truth = test::gao_arm();
  for (auto& joint : truth.joints) {
    joint.a += 0.1 * random.normal();
    joint.d += 0.1 * random.normal();
    joint.theta += 1e-3 * random.normal();
    joint.alpha += 1e-3 * random.normal();
  }
  VirtualProbing probing;
  probing.readings = poses;
  VirtualRecording made = probe_virtually(truth, probing);
  for (auto& reading : made.recording.readings) {
    reading.reference += noise_mm * normal_vector(random);
  }
  made.recording.arm = test::gao_arm();
  Task task{std::move(made.recording), {}, {}};
  task.constraints = *build_constraints(task.recording, made.artefacts);
  for (const auto& parameter : parameters_of(task.recording.arm)) {
    if (parameter.name != "a6" && parameter.name != "d6") {
      task.free.push_back(parameter);
    }
  }
  return task;
}

void artcal_solve(benchmark::State& state) {
  const Task task = make_task(static_cast<int>(state.range(0)));
  Noise noise;
  noise.reading = noise_mm;
  for (auto _ : state) {
    const auto fit = fit_arm(task.recording, task.constraints, task.recording.arm, task.free, noise, {});
    benchmark::DoNotOptimize(fit->cost);
    state.counters["iterations"] = fit->iterations;
    state.counters["cost"] = fit->cost;
  }
  state.SetComplexityN(state.range(0));
}

/// What rank and covariance add to the solve: the covariance is made from the solve's last linearisation.
void artcal_rank_solve_covariance(benchmark::State& state) {
  const Task task = make_task(static_cast<int>(state.range(0)));
  CouplingOptions coupling_options;
  coupling_options.noise.reading = noise_mm;
  for (auto _ : state) {
    const auto analysis = analyse_coupling(task.recording, task.constraints, task.recording.arm, coupling_options);
    const auto fit =
        fit_arm(task.recording, task.constraints, task.recording.arm, task.free, coupling_options.noise, {});
    const auto covariance = arm_covariance(fit->scale, fit->linearisation);
    benchmark::DoNotOptimize((*covariance)(0, 0));
    state.counters["rank"] = analysis->rank;
  }
}

void artcal_whole(benchmark::State& state) {
  const Task task = make_task(static_cast<int>(state.range(0)));
  IdentifyOptions options;
  options.noise.reading = noise_mm;
  options.leave_out = false;
  for (auto _ : state) {
    const auto result = identify(task.recording, task.constraints, options);
    benchmark::DoNotOptimize(result->cost);
  }
}

/// The peer: one residual block a pose, 25 numbers of which a6 and d6 are held, Jets through the chain.
struct PoseCost {
  std::array<double, 6> q;
  Eigen::Vector3d reference;

  template <typename T>
  bool operator()(const T* p, T* residual) const {
    // p: a1…a6, d1…d6, theta1…theta6, alpha1…alpha6, l
    Eigen::Matrix<T, 3, 3> rotation = Eigen::Matrix<T, 3, 3>::Identity();
    Eigen::Matrix<T, 3, 1> origin = Eigen::Matrix<T, 3, 1>::Zero();
    for (int i = 0; i < 6; ++i) {
      using std::cos;
      using std::sin;
      const T theta = p[12 + i] + q[i];
      const T c = cos(theta), s = sin(theta), ca = cos(p[18 + i]), sa = sin(p[18 + i]);
      Eigen::Matrix<T, 3, 3> step;
      step << c, -s * ca, s * sa, s, c * ca, -c * sa, T(0), sa, ca;
      origin += rotation * Eigen::Matrix<T, 3, 1>(p[i] * c, p[i] * s, p[6 + i]);
      rotation = (rotation * step).eval();
    }
    const Eigen::Matrix<T, 3, 1> tip = origin + rotation.col(2) * p[24];
    for (int k = 0; k < 3; ++k) {
      residual[k] = (tip[k] - reference[k]) / noise_mm;
    }
    return true;
  }
};

/// The same stop as ours: a step below a nanometre (here angles count in rad, which is stricter for none).
class StopWhenStill final : public ceres::IterationCallback {
 public:
  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    return summary.iteration > 0 && summary.step_norm < 1e-6 ? ceres::SOLVER_TERMINATE_SUCCESSFULLY
                                                             : ceres::SOLVER_CONTINUE;
  }
};

void ceres_autodiff(benchmark::State& state) {
  const Task task = make_task(static_cast<int>(state.range(0)));
  for (auto _ : state) {
    std::array<double, 25> p{};
    const auto parameters = parameters_of(task.recording.arm);
    for (std::size_t i = 0; i < p.size(); ++i) {
      p[i] = value(task.recording.arm, parameters[i]);
    }
    ceres::Problem problem;
    for (std::size_t i = 0; i < task.recording.readings.size(); ++i) {
      PoseCost cost{{}, task.recording.readings[i].reference};
      for (int j = 0; j < 6; ++j) {
        cost.q[j] = task.recording.joints(j, static_cast<Eigen::Index>(i));
      }
      problem.AddResidualBlock(new ceres::AutoDiffCostFunction<PoseCost, 3, 25>(new PoseCost(cost)), nullptr, p.data());
    }
    problem.SetManifold(p.data(), new ceres::SubsetManifold(25, {5, 11}));
    ceres::Solver::Options options;
    options.linear_solver_type = state.range(1) == 0 ? ceres::DENSE_QR : ceres::DENSE_NORMAL_CHOLESKY;
    options.logging_type = ceres::SILENT;
    options.num_threads = 1;
    options.initial_trust_region_radius = 1e16;
    options.parameter_tolerance = 1e-14;
    options.function_tolerance = 0.0;
    options.gradient_tolerance = 0.0;
    StopWhenStill stop_when_still;
    options.callbacks.push_back(&stop_when_still);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    state.counters["iterations"] = static_cast<double>(summary.iterations.size() - 1);
    state.counters["cost"] = summary.final_cost;
  }
  state.SetComplexityN(state.range(0));
}

BENCHMARK(artcal_solve)->Arg(100)->Arg(1000)->Arg(10000)->Arg(100000)->Complexity()->Unit(benchmark::kMillisecond);
BENCHMARK(ceres_autodiff)
    ->ArgsProduct({{100, 1000, 10000, 100000}, {0, 1}})
    ->ArgNames({"poses", "cholesky"})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(artcal_rank_solve_covariance)->Arg(10000)->Unit(benchmark::kMillisecond);
BENCHMARK(artcal_whole)->Arg(10000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace artcal
