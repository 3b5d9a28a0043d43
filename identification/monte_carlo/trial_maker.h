#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "identification/identify.h"
#include "identification/monte_carlo/monte_carlo.h"
#include "identification/monte_carlo/reidentification.h"
#include "identification/monte_carlo/simulated_measurement.h"
#include "identification/monte_carlo/trial_inputs.h"

namespace artcal {

/// Makes the trials of a MonteCarlo: draws inputs, identifies an arm from them and has it measure. Const once prepared;
/// threads share it, each with a Scratch of its own.
class TrialMaker {
 public:
  /// As MonteCarlo::prepare().
  static Expected<std::unique_ptr<TrialMaker>> prepare(const Recording& recording, const Constraints& constraints,
                                                       const IdentifyOptions& options,
                                                       const Identification& identification,
                                                       const MonteCarloOptions& monte_carlo);
  TrialMaker(const TrialMaker&) = delete;
  TrialMaker& operator=(const TrialMaker&) = delete;

  /// The identified parameters, then what is measured.
  [[nodiscard]] const std::vector<Measurand>& quantities() const { return quantities_; }
  /// Of a quantity: what moves the tip by some 1 mm, in its unit.
  [[nodiscard]] double natural_unit(std::size_t quantity) const;

  struct Scratch {
    TrialInputs inputs;
    Reidentification::Scratch solving;
  };
  [[nodiscard]] Scratch scratch() const { return {TrialInputs(system_, *recording_, spread_), again_->scratch()}; }

  /// Trials first … first + count − 1 of `seed`.
  [[nodiscard]] TrialResults make(std::uint64_t seed, std::int64_t first, std::int64_t count, Scratch& scratch) const;

 private:
  TrialMaker() = default;

  const Recording* recording_ = nullptr;
  ArmFit fit_;
  System system_;
  InputSpread spread_;
  std::optional<Reidentification> again_;
  std::optional<Measuring> measuring_;
  std::vector<Measurand> quantities_;
};

}  // namespace artcal
