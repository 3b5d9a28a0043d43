#pragma once

#include <string>

#include "app/arm/rounding_options.h"
#include "app/commands/command.h"
#include "app/requests/access_option.h"
#include "app/requests/identify_request.h"

namespace artcal {

/// `artcal arm from-coordinates`: the maker's own model, from what his software reported.
struct ReportedRequest {
  std::string input, output, frame = "base";
  RoundingOptions rounding;
  RecordingOptions access;
  IdentifyChoices choices;
  CommonOptions common;

  CLI::App* add_to(CLI::App& parser);
  [[nodiscard]] Expected<int> run() const;
};

}  // namespace artcal
