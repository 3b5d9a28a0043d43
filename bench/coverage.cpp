// Do 95 % intervals hold the truth? Simulated recordings of arms and bars, each drawn anew (arm, placements, postures,
// noise, errors of the certificate), identified, and the truth looked up in the intervals of parameters, points and
// lengths: first order over all recordings, Monte Carlo over the first of them. The truth of what is held is held, so
// that both arms stand in the same frame.
//   coverage [recordings] [recordings with Monte Carlo] [trials of each] [model] [arc seconds]
// A model such as dh+gain+coupling: the arms have such errors too (of gain, coupling, gravity, radius). The last: every
// joint's encoder is eccentric by up to this amplitude, which the model does not have. With a negative number of trials
// the noise is estimated from the residuals. Placements are left out.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <future>
#include <map>
#include <mutex>

#include <fmt/format.h>

#include "artefacts/simulation/simulate.h"
#include "artefacts/virtual_probing/postures.h"
#include "identification/identify.h"
#include "identification/monte_carlo/monte_carlo.h"
#include "identification/uncertainty/uncertain_arm.h"
#include "tests/support/plans.h"

namespace artcal {
namespace {

constexpr double k_95 = 1.959964;

SimulationPlan plan_of(std::uint64_t seed, const Model& model, double eccentricity) {
  SimulationPlan plan = testing::plan_for(testing::bar_of(FeatureKind::Sphere), 20);
  plan.nominal.probes[0].on_axis = true;
  plan.nominal.probes[0].tip_in_last = {0.0, 0.0, 183.5};
  for (Joint& joint : plan.nominal.joints) {
    joint.mass = 1.5;
  }
  plan.arm.arm = plan.nominal;
  plan.placements.clear();
  for (int i = 0; i < 7; ++i) {
    PlannedPlacement placement;
    placement.name = std::to_string(i);
    plan.placements.push_back(placement);
  }
  plan.probings[0].placements = {0, 1, 2, 3, 4, 5, 6};
  plan.errors = {0.3, 2e-3, 0.0, 0.0, {"a6", "d6", "d1", "theta1"}};
  for (const ParameterGroup group : model) {
    plan.errors.gain += group == ParameterGroup::Gain ? 2e-4 : 0.0;
    plan.errors.coupling += group == ParameterGroup::Coupling ? 1e-4 : 0.0;
    plan.errors.compliance += group == ParameterGroup::Gravity ? 10.0 * units::arcsecond / 1e3 : 0.0;
    plan.errors.radius += group == ParameterGroup::Radius ? 0.02 : 0.0;
  }
  plan.errors.eccentricity = eccentricity;
  for (VirtualJoint& joint : plan.arm.joints) {
    joint.encoder_noise = 2.0 * units::arcsecond;
  }
  plan.noise.probing = 0.003;
  for (CertifiedDistance& distance : plan.artefacts[0].certified.distances) {
    distance.u = 0.003;  // as much as the readings leave open
  }
  plan.draw_artefacts = true;
  plan.seed = seed;
  return plan;
}

/// How often each quantity was held.
class Tally {
 public:
  void add(const std::string& kind, int number, bool fixed) {
    auto& [hits, count] = tally_[kind][number];
    hits += fixed ? 1 : 0;
    ++count;
  }
  void add(const Tally& other) {
    for (const auto& [kind, numbers] : other.tally_) {
      for (const auto& [number, entry] : numbers) {
        auto& [hits, count] = tally_[kind][number];
        hits += entry.first;
        count += entry.second;
      }
    }
  }
  void print() const {
    for (const auto& [kind, numbers] : tally_) {
      int hits = 0;
      int count = 0;
      double low = 1.0;
      double high = 0.0;
      for (const auto& [number, entry] : numbers) {
        hits += entry.first;
        count += entry.second;
        low = std::min(low, 1.0 * entry.first / entry.second);
        high = std::max(high, 1.0 * entry.first / entry.second);
      }
      fmt::print("{:<32} {:6.2f} %   single ones {:.1f} to {:.1f} %   {} quantities\n", kind, 100.0 * hits / count,
                 100.0 * low, 100.0 * high, numbers.size());
    }
  }

 private:
  std::map<std::string, std::map<int, std::pair<int, int>>> tally_;
};

// Where the arm's tip is when its encoders read q.
Eigen::Vector3d true_tip(const VirtualArm& arm, Eigen::VectorXd q) {
  for (std::size_t joint = 0; joint < arm.joints.size(); ++joint) {
    double& angle = q[static_cast<Eigen::Index>(joint)];
    angle += encoder_error(arm.joints[joint], angle);
  }
  return tip_at(arm.arm, 0, q);
}

void first_order(const VirtualArm& truth, const Identification& found, Tally& tally) {
  std::vector<Parameter> free;
  for (const int i : found.free) {
    const IdentifiedParameter& parameter = found.parameters[i];
    free.push_back(parameter.parameter);
    tally.add("first order: parameters", i,
              std::abs(parameter.identified - value(truth.arm, parameter.parameter)) < k_95 * parameter.u);
  }
  const UncertainArm arm(found.arm, {free, found.covariance, 0.0, 0.0});
  RandomStream random(1, "coverage: postures");
  for (int i = 0; i < 30; ++i) {
    const std::array<Eigen::VectorXd, 2> q{random_posture(found.arm, random), random_posture(found.arm, random)};
    const UncertainTip first = arm.tip(q[0]);
    const UncertainTip second = arm.tip(q[1]);
    const Eigen::Vector3d off = first.in_base - true_tip(truth, q[0]);
    const Eigen::Matrix3d covariance = arm.of_point(first);
    for (int k = 0; k < 3; ++k) {
      tally.add("first order: points", 3 * i + k, std::abs(off[k]) < k_95 * std::sqrt(covariance(k, k)));
    }
    const double length = (second.in_base - first.in_base).norm();
    const double true_length = (true_tip(truth, q[1]) - true_tip(truth, q[0])).norm();
    tally.add("first order: lengths", i, std::abs(length - true_length) < k_95 * arm.of_length(first, second));
  }
}

void monte_carlo(const Simulation& simulation, const Constraints& constraints, const IdentifyOptions& options,
                 const Identification& found, std::int64_t trials, Tally& tally) {
  const Arm& truth = simulation.arm.arm;
  MonteCarloOptions asked;
  asked.measuring.balls = 0;
  const auto made = MonteCarlo::prepare(simulation.recording, constraints, options, found, asked);
  const auto plan = plan_measuring(found.arm, asked.measuring);
  MonteCarloCount count = *made->begin();
  if (!made->run(count, {trials, 2}, {{}, {}, nullptr, 1})) {
    std::abort();
  }
  std::vector<double> true_values;
  for (const int i : found.free) {
    true_values.push_back(value(truth, found.parameters[i].parameter));
  }
  for (const auto& point : plan->points) {
    const Eigen::Vector3d there = tip_at(truth, 0, point.q);
    true_values.insert(true_values.end(), there.begin(), there.end());
  }
  for (const auto& length : plan->lengths) {
    true_values.push_back((tip_at(truth, 0, length.q[1]) - tip_at(truth, 0, length.q[0])).norm());
    true_values.push_back(0.0);  // E_Uni has no truth to hold
  }
  const auto results = summary(made->quantities(), count);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const auto kind = made->quantities()[i].kind;
    if (kind == Measurand::Kind::EUni || !results[i].symmetric) {
      continue;
    }
    const char* name = kind == Measurand::Kind::Parameter    ? "Monte Carlo: parameters"
                       : kind == Measurand::Kind::Coordinate ? "Monte Carlo: points"
                                                             : "Monte Carlo: lengths";
    tally.add(name, static_cast<int>(i),
              true_values[i] > results[i].symmetric->low && true_values[i] < results[i].symmetric->high);
  }
}

int run(int recordings, int with_monte_carlo, std::int64_t trials, const Model& model, double eccentricity) {
  std::atomic<int> next{0};
  std::mutex counting;
  Tally tally;
  int failed = 0;
  int flagged = 0;
  int enlarged = 0;
  double scales = 0.0;
  const auto work = [&] {
    for (int i = next++; i < recordings; i = next++) {
      const SimulationPlan plan = plan_of(static_cast<std::uint64_t>(i) + 1, model, eccentricity);
      const auto simulation = simulate(plan, 1);
      Tally own;
      bool done = false;
      bool found_something = false;
      bool is_enlarged = false;
      double scale = 1.0;
      if (simulation) {
        const auto constraints = *build_constraints(simulation->recording, {plan.artefacts[0].certified});
        IdentifyOptions options;
        options.noise = trials < 0 ? Noise{} : Noise{{}, 2.0 * units::arcsecond, 0.003};
        options.threads = 1;
        options.model = model;
        if (const auto found = identify(simulation->recording, constraints, options)) {
          done = true;
          found_something = !found->model_study.findings.empty();
          is_enlarged = found->cross_validation.scale > 1.0;
          scale = found->cross_validation.scale;
          first_order(simulation->arm, *found, own);
          if (i < with_monte_carlo) {
            monte_carlo(*simulation, constraints, options, *found, trials, own);
          }
        }
      }
      const std::lock_guard lock(counting);
      tally.add(own);
      failed += done ? 0 : 1;
      flagged += found_something ? 1 : 0;
      enlarged += is_enlarged ? 1 : 0;
      scales += std::log(scale);
    }
  };
  auto other = std::async(std::launch::async, work);
  work();
  other.get();
  fmt::print("{}: {} recordings, {} not identified; a sound model was doubted in {}; Monte Carlo of {} trials on {}\n",
             model_text(model), recordings, failed, flagged, trials, with_monte_carlo);
  fmt::print("unmodelled error was found in {}; geometric mean of the factor {:.3f}\n", enlarged,
             std::exp(scales / recordings));
  tally.print();
  return 0;
}

}  // namespace
}  // namespace artcal

int main(int argc, char** argv) {
  const auto number = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
  const auto model = artcal::model_request(argc > 4 ? argv[4] : "dh");
  if (!model || model->automatic) {
    fmt::print(stderr, "no model: {}\n", argv[4]);
    return 2;
  }
  return artcal::run(number(1, 1000), number(2, 200), number(3, 1000), model->groups,
                     number(5, 0) * artcal::units::arcsecond);
}
