#pragma once

#include <string>

#include "app/commands/command.h"
#include "app/requests/monte_carlo_request.h"

namespace artcal {

/// Runs `artcal uncertainty --monte-carlo`. `probe` and `seed` come from the options that both kinds of uncertainty
/// share. Returns the exit code.
Expected<int> monte_carlo_and_tell(const MonteCarloRequest& request, const CommonOptions& common,
                                   const std::string& recording, const std::string& probe, std::uint64_t seed);

}  // namespace artcal
