// Monte Carlo re-identifications of a real recording (examples/two-socket-bar: 387 readings, 31 parameters of which 25
// can be determined), ours beside the same loop written with Ceres' defaults and automatic differentiation, in one run.
// Both get the same drawn readings and certificates, begin at the first solution, and minimise the same sum of squares.
#include <algorithm>
#include <array>
#include <cmath>

#include <benchmark/benchmark.h>
#include <ceres/ceres.h>

#include "acquisition/recording/recording_file.h"
#include "artefacts/constraints/bound_recording.h"
#include "identification/identify.h"
#include "identification/monte_carlo/monte_carlo.h"
#include "identification/monte_carlo/reidentification.h"
#include "identification/monte_carlo/trial_inputs.h"

namespace artcal {
namespace {

constexpr int joints = 7;
constexpr int numbers = 4 * joints + 3;  // a, d, theta, alpha of each joint, then the tip

/// The recording, identified once.
struct Task {
  Recording recording;
  Constraints constraints;
  IdentifyOptions options;
  Identification identification;
  std::vector<Parameter> free;
  ArmFit fit;
  InputSpread spread;
};

Task make_task() {
  Task t;
  auto bound =
      bind_recording(*read_recording(std::string(ARTCAL_SOURCE_DIR) + "/examples/two-socket-bar/recording.toml"));
  t.recording = std::move(bound->recording);
  t.constraints = std::move(bound->constraints);
  t.options.leave_out = false;
  t.identification = *identify(t.recording, t.constraints, t.options);
  for (const int i : t.identification.free) {
    t.free.push_back(t.identification.parameters[i].parameter);
  }
  Noise noise;
  noise.reading = t.identification.noise;
  t.fit = *fit_arm(t.recording, t.constraints, t.identification.arm, t.free, noise, {});
  t.spread.probing = t.identification.noise;
  return t;
}

const Task& task() {
  static const Task made = make_task();
  return made;
}

const System& first_system() {
  static const System made = make_system(task().recording, task().constraints, task().fit.arm, task().free);
  return made;
}

double cost_at(const System& drawn, const Eigen::VectorXd& x) {
  // The least over the unknowns at this arm: one more solve with nothing of the arm free.
  const System fixed = [&] {
    System copy = drawn;
    copy.start = drawn.arm_at(x.data());
    copy.free.clear();
    copy.scale.resize(0);
    return copy;
  }();
  return solve(fixed, task().fit.weights, Eigen::VectorXd(), task().fit.unknowns).final_cost;
}

void artcal_trial(benchmark::State& state) {
  const Task& t = task();
  const auto again = *Reidentification::of(first_system(), t.fit, {});
  auto scratch = again.scratch();
  TrialInputs inputs(first_system(), t.recording, t.spread);
  std::uint64_t trial = 0;
  Eigen::VectorXd x;
  double steps = 0.0;
  for (auto _ : state) {
    inputs.draw(1, trial++);
    const auto answer = again.solve(inputs.system(), scratch);
    if (!answer.converged) {
      state.SkipWithError("a trial did not converge");
      break;
    }
    steps += answer.steps;
  }
  inputs.draw(1, 0);
  state.counters["cost_of_trial_0"] = cost_at(inputs.system(), again.solve(inputs.system(), scratch).x);
  state.counters["steps"] = steps / static_cast<double>(trial);
}

/// The peer's arm: the chain of modified Denavit-Hartenberg, in Jets.
struct ReadingCost {
  std::array<double, joints> q;
  Eigen::Vector3d shift;
  double weight;

  template <typename T>
  bool operator()(const T* p, const T* point, T* residual) const {
    using std::cos;
    using std::sin;
    Eigen::Matrix<T, 3, 3> rotation = Eigen::Matrix<T, 3, 3>::Identity();
    Eigen::Matrix<T, 3, 1> origin = Eigen::Matrix<T, 3, 1>::Zero();
    for (int i = 0; i < joints; ++i) {
      const T* joint = p + 4 * i;
      const T theta = joint[2] + q[static_cast<std::size_t>(i)];
      const T c = cos(theta), s = sin(theta), ca = cos(joint[3]), sa = sin(joint[3]);
      Eigen::Matrix<T, 3, 3> step;
      step << c, -s, T(0), ca * s, ca * c, -sa, sa * s, sa * c, ca;
      origin += rotation * Eigen::Matrix<T, 3, 1>(joint[0], -sa * joint[1], ca * joint[1]);
      rotation = (rotation * step).eval();
    }
    const Eigen::Matrix<T, 3, 1> tip = origin + rotation * Eigen::Matrix<T, 3, 1>(p[28], p[29], p[30]);
    for (int k = 0; k < 3; ++k) {
      residual[k] = weight * (tip[k] + shift[k] - point[k]);
    }
    return true;
  }
};

struct DistanceCost {
  double value, weight;

  template <typename T>
  bool operator()(const T* first, const T* second, T* residual) const {
    using std::sqrt;
    T squares(0.0);
    for (int k = 0; k < 3; ++k) {
      squares += (second[k] - first[k]) * (second[k] - first[k]);
    }
    residual[0] = weight * (sqrt(squares) - value);
    return true;
  }
};

std::array<double, numbers> numbers_of(const Arm& arm) {
  std::array<double, numbers> p{};
  for (std::size_t i = 0; i < joints; ++i) {
    const Joint& joint = arm.joints[i];
    p[4 * i] = joint.a;
    p[4 * i + 1] = joint.d;
    p[4 * i + 2] = joint.theta;
    p[4 * i + 3] = joint.alpha;
  }
  Eigen::Vector3d::Map(p.data() + 4 * joints) = arm.probes.front().tip_in_last;
  return p;
}

std::vector<int> fixed_numbers() {
  std::vector<int> fixed;
  for (int i = 0; i < numbers; ++i) {
    Arm moved = task().fit.arm;
    const bool free = std::any_of(task().free.begin(), task().free.end(), [&](const Parameter& parameter) {
      set_value(moved, parameter, value(moved, parameter) + 1.0);
      const bool here =
          numbers_of(moved)[static_cast<std::size_t>(i)] != numbers_of(task().fit.arm)[static_cast<std::size_t>(i)];
      set_value(moved, parameter, value(task().fit.arm, parameter));
      return here;
    });
    if (!free) {
      fixed.push_back(i);
    }
  }
  return fixed;
}

// Returns the cost and, through `p`, the arm.
double solve_with_ceres(const System& drawn, const std::vector<int>& fixed, std::array<double, numbers>& p) {
  const Task& t = task();
  const Constraints& constraints = *drawn.constraints;
  std::vector<Eigen::Vector3d> points;
  for (const FeatureConstraint& feature : constraints.features) {
    points.emplace_back(t.fit.unknowns.groups[*feature.group].values.segment<3>(feature.offset));
  }
  ceres::Problem problem;
  for (std::size_t f = 0; f < constraints.features.size(); ++f) {
    const FeatureConstraint& feature = constraints.features[f];
    for (std::size_t k = 0; k < feature.readings.size(); ++k) {
      ReadingCost cost{{}, drawn.shifts[feature.readings[k]], t.fit.weights.features[f].scalar[k]};
      for (int j = 0; j < joints; ++j) {
        cost.q[static_cast<std::size_t>(j)] = t.recording.joints(j, feature.readings[k]);
      }
      problem.AddResidualBlock(new ceres::AutoDiffCostFunction<ReadingCost, 3, numbers, 3>(new ReadingCost(cost)),
                               nullptr, p.data(), points[f].data());
    }
  }
  for (std::size_t d = 0; d < constraints.distances.size(); ++d) {
    const DistanceConstraint& distance = constraints.distances[d];
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<DistanceCost, 1, 3, 3>(
                                 new DistanceCost{distance.value, t.fit.weights.distances[d]}),
                             nullptr, points[distance.first].data(), points[distance.second].data());
  }
  problem.SetManifold(p.data(), new ceres::SubsetManifold(numbers, fixed));
  ceres::Solver::Options options;  // Ceres' own
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  return summary.final_cost;
}

void ceres_autodiff_trial(benchmark::State& state) {
  const Task& t = task();
  TrialInputs inputs(first_system(), t.recording, t.spread);
  const auto fixed = fixed_numbers();
  std::uint64_t trial = 0;
  for (auto _ : state) {
    inputs.draw(1, trial++);
    auto p = numbers_of(t.fit.arm);
    benchmark::DoNotOptimize(solve_with_ceres(inputs.system(), fixed, p));
  }
  inputs.draw(1, 0);
  auto p = numbers_of(t.fit.arm);
  state.counters["cost_of_trial_0"] = solve_with_ceres(inputs.system(), fixed, p);
}

/// The whole of it on two threads, with nothing to measure but the parameters.
void artcal_10000_trials_two_threads(benchmark::State& state) {
  const Task& t = task();
  MonteCarloOptions options;
  options.measuring.points = 0;
  options.measuring.lengths = 0;
  options.measuring.balls = 0;
  for (auto _ : state) {
    const auto monte_carlo = MonteCarlo::prepare(t.recording, t.constraints, t.options, t.identification, options);
    MonteCarloCount count = *monte_carlo->begin();
    const auto run = monte_carlo->run(count, {10'000, 2}, {{}, {}, nullptr, 2});
    state.counters["not_converged"] = static_cast<double>(count.not_converged);
    if (!run) {
      state.SkipWithError("the run ended with an error");
    }
  }
}

BENCHMARK(artcal_trial)->Unit(benchmark::kMillisecond)->MinTime(2.0);
BENCHMARK(ceres_autodiff_trial)->Unit(benchmark::kMillisecond)->MinTime(2.0);
BENCHMARK(artcal_10000_trials_two_threads)
    ->Unit(benchmark::kSecond)
    ->Iterations(1)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

}  // namespace
}  // namespace artcal
