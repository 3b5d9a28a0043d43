#include "identification/monte_carlo/trial_maker.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace artcal {
namespace {

constexpr double least_noise_of_an_arm = 1e-8;  // mm; readings that agree better were not taken by an arm

Noise noise_in_use(const IdentifyOptions& options, const Identification& identification) {
  Noise noise = options.noise;
  if (!noise.is_given()) {
    noise.reading = identification.noise;
  }
  return noise;
}

InputSpread spread_of(const Noise& noise, const Identification& identification, const MonteCarloOptions& monte_carlo) {
  InputSpread spread;
  spread.encoder = noise.encoder.value_or(0.0);
  spread.probing = noise.reading ? *noise.reading : *noise.probing;
  spread.temperature = monte_carlo.u_temperature;
  spread.arm_temperature = monte_carlo.u_arm_temperature;
  spread.scale_factor = identification.scale_factor;
  if (!identification.noise_is_given) {
    spread.degrees_of_freedom = identification.degrees_of_freedom;
  }
  return spread;
}

}  // namespace

Expected<std::unique_ptr<TrialMaker>> TrialMaker::prepare(const Recording& recording, const Constraints& constraints,
                                                          const IdentifyOptions& options,
                                                          const Identification& identification,
                                                          const MonteCarloOptions& monte_carlo) {
  const Noise noise = noise_in_use(options, identification);
  if (noise.reading.value_or(1.0) < least_noise_of_an_arm) {
    return no_solution(
        "the readings agree to the last digits, so that there is no noise to draw from; state one, such as --noise "
        "\"15 um\"");
  }
  if (!identification.weak.empty()) {
    return no_solution(fmt::format(
        "{} {} estimated with a weak prior, which trials with new noise do not draw; fix what the readings hardly "
        "determine: --hold {}",
        fmt::join(identification.weak, ", "), identification.weak.size() == 1 ? "is" : "are",
        fmt::join(identification.weak, ",")));
  }
  if (monte_carlo.u_arm_temperature > 0.0 && !expands(identification.arm)) {
    return bad_input(
        "an uncertainty of the arm's temperature is stated, but no link of this arm expands: leave out "
        "--u-arm-temperature, or state how the links expand in the arm's file");
  }
  std::unique_ptr<TrialMaker> maker(new TrialMaker);
  maker->recording_ = &recording;
  const SolveOptions solve_options{options.loss, options.max_iterations};
  std::vector<Parameter> free;
  for (const int index : identification.free) {
    free.push_back(identification.parameters[index].parameter);
  }
  auto fit = fit_arm(recording, constraints, identification.arm, free, noise, solve_options);
  if (!fit) {
    return tl::unexpected(fit.error());
  }
  maker->fit_ = std::move(*fit);
  maker->system_ = make_system(recording, constraints, maker->fit_.arm, free);
  maker->spread_ = spread_of(noise, identification, monte_carlo);
  auto again = Reidentification::of(maker->system_, maker->fit_, solve_options);
  if (!again) {
    return tl::unexpected(again.error());
  }
  maker->again_ = std::move(*again);
  auto plan = plan_measuring(maker->fit_.arm, monte_carlo.measuring);
  if (!plan) {
    return tl::unexpected(plan.error());
  }
  const double encoder = maker->spread_.scale_factor * maker->spread_.encoder;
  const double probing = maker->spread_.scale_factor * maker->spread_.probing;
  // The trials take the model as true, and so must what they are compared with.
  const double unmodelled = identification.cross_validation.scale;
  const UncertainArm uncertain(
      maker->fit_.arm, {free, identification.covariance / (unmodelled * unmodelled), encoder, probing}, plan->probe);
  maker->measuring_.emplace(std::move(*plan), uncertain, encoder, probing);
  for (const int index : identification.free) {
    const IdentifiedParameter& known = identification.parameters[index];
    maker->quantities_.push_back({Measurand::Kind::Parameter, known.parameter.name, known.parameter.unit(),
                                  value(maker->fit_.arm, known.parameter), known.u / unmodelled});
  }
  const auto& measured = maker->measuring_->quantities();
  maker->quantities_.insert(maker->quantities_.end(), measured.begin(), measured.end());
  return maker;
}

double TrialMaker::natural_unit(std::size_t quantity) const {
  return quantity < system_.free.size() ? system_.scale[static_cast<Eigen::Index>(quantity)] : 1.0;
}

TrialResults TrialMaker::make(std::uint64_t seed, std::int64_t first, std::int64_t count, Scratch& scratch) const {
  TrialResults results{first, {}, {}};
  const std::size_t width = quantities_.size();
  results.values.resize(width * static_cast<std::size_t>(count));
  for (std::int64_t t = 0; t < count; ++t) {
    const auto trial = static_cast<std::uint64_t>(first + t);
    double* values = results.values.data() + width * static_cast<std::size_t>(t);
    scratch.inputs.draw(seed, trial);
    const Reidentification::Answer answer = again_->solve(scratch.inputs.system(), scratch.solving);
    if (answer.converged) {
      const Arm arm = system_.arm_at(answer.x.data());
      for (const Parameter& parameter : system_.free) {
        *values++ = value(arm, parameter);
      }
      RandomStream random(seed, "trial: measuring", trial);
      measuring_->measure(arm, random, values);
    }
    const double* row = results.values.data() + width * static_cast<std::size_t>(t);
    results.converged.push_back(answer.converged &&
                                std::all_of(row, row + width, [](double number) { return std::isfinite(number); }));
  }
  return results;
}

}  // namespace artcal
