#pragma once

#include <string>

#include "app/arm/rounding_options.h"
#include "app/commands/command.h"
#include "app/requests/identify_request.h"
#include "app/requests/recording_request.h"

namespace artcal {

/// `artcal arm from-coordinates`: the maker's own model, from what his software reported.
struct ReportedRequest {
  RecordingRequest recording;
  std::string output, frame = "base";
  RoundingOptions rounding;
  IdentifyChoices choices;
  CommonOptions common;

  CLI::App* add_to(CLI::App& parser);
  [[nodiscard]] Expected<int> run() const;
};

}  // namespace artcal
