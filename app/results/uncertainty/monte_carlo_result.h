#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "acquisition/recording/recording.h"
#include "identification/monte_carlo/monte_carlo.h"

namespace artcal {

/// What `artcal uncertainty --monte-carlo` found, and from what. Nothing in it depends on how the trials were shared
/// out or on the clock.
struct MonteCarloResult {
  const Recording& recording;
  const IdentifyOptions& options;
  const Identification& identification;
  MonteCarloOptions monte_carlo;
  TrialsWanted wanted;
  std::vector<Measurand> quantities;
  const MonteCarloCount& count;
  bool complete = true;

  [[nodiscard]] std::vector<MonteCarloSummary> summary() const {
    return artcal::summary(quantities, count, wanted.digits);
  }
};

/// What a count of trials is made from: where it differs, trials cannot be put together.
nlohmann::ordered_json made_from_json(const Recording& recording, const IdentifyOptions& options,
                                      const Identification& identification, const MonteCarloOptions& monte_carlo);

nlohmann::ordered_json to_json(const MonteCarloResult& result);
std::string to_text(const MonteCarloResult& result);

}  // namespace artcal
