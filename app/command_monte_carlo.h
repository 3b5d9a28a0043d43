#pragma once

#include <string>
#include <vector>

#include "app/command.h"
#include "app/identify_request.h"

namespace artcal {

/// What `artcal uncertainty --monte-carlo` takes beside what `artcal uncertainty` takes.
struct MonteCarloRequest {
  bool asked = false;
  IdentifyChoices choices;  ///< its noise stands in the options of `artcal uncertainty`
  std::string trials = "auto";
  int digits = 2;
  int threads = 0;
  std::string u_temperature;
  std::vector<std::string> points;
  std::string state, resume, shard;
  std::vector<std::string> merge;

  /// Adds all but what `artcal uncertainty` has already: noise, seed and probe.
  void add_to(CLI::App& parser);
};

/// Runs it. `probe` and `seed` come from the options that both kinds of uncertainty share. Returns the exit code.
Expected<int> monte_carlo_and_tell(const MonteCarloRequest& request, const CommonOptions& common,
                                   const std::string& recording, const std::string& probe, std::uint64_t seed);

}  // namespace artcal
