#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "acquisition/recording/noise.h"
#include "app/results/recorded/recorded_object.h"
#include "identification/monte_carlo/distribution.h"

namespace artcal {

/// A quantity of a Monte Carlo as its result has it (table "propagated" of docs/result-schema.md), in `unit`.
struct RecordedQuantity {
  std::string kind, name, unit;
  double estimate = 0.0;
  std::optional<double> u_first_order;  ///< nothing of what is not linear
  double u = 0.0;
  std::optional<Interval> interval_95;  ///< nothing where an end lies beyond the histogram
  bool is_stable = false;
  bool differs_from_first_order = false;

  [[nodiscard]] bool is_parameter() const { return kind == "parameter"; }
};

/// A Monte Carlo (table "monte_carlo").
struct RecordedMonteCarlo {
  std::string model, probe;
  Noise noise;  ///< as stated; nothing of it where it was estimated
  int digits = 0;
  std::size_t trials = 0, not_converged = 0;
  bool is_complete = false;
  std::size_t seed = 0;
  std::vector<RecordedQuantity> quantities;
  std::vector<std::string> warnings;
};

/// Throws NotAsInSchema.
RecordedMonteCarlo recorded_monte_carlo(const RecordedObject& result);

}  // namespace artcal
