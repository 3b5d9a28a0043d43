#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/requests/access_option.h"
#include "app/requests/identify_request.h"
#include "identification/monte_carlo/monte_carlo.h"

namespace artcal {

/// Trials that a run makes.
struct TrialRange {
  std::int64_t first = 0;
  TrialsWanted wanted;
};

/// What `artcal uncertainty --monte-carlo` takes beside what `artcal uncertainty` takes.
struct MonteCarloRequest {
  bool asked = false;
  RecordingOptions access;
  IdentifyChoices choices;  ///< its noise stands in the options of `artcal uncertainty`
  std::string trials = "auto";
  int digits = 2;
  int threads = 0;
  std::string u_temperature, u_arm_temperature;
  std::vector<std::string> points;
  std::string state, resume, shard;
  std::vector<std::string> merge;

  /// Adds all but what `artcal uncertainty` has already: noise, seed and probe.
  void add_to(CLI::App& parser);

  /// Those of the shard, or all. Usage: numbers that are none, options that do not go together.
  [[nodiscard]] Expected<TrialRange> range() const;
  /// What is drawn and measured. Usage: a point, a probe or a temperature that is none.
  [[nodiscard]] Expected<MonteCarloOptions> options(const Arm& arm, const std::string& probe, std::uint64_t seed) const;
};

}  // namespace artcal
