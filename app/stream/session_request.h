#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "acquisition/arm/arm.h"
#include "app/requests/access_option.h"
#include "app/stream/recording_session.h"
#include "core/error.h"

namespace artcal {

/// What a command line says of a session that events are recorded into.
struct SessionRequest {
  std::string format, arm, plan, probe;
  std::string encoder_noise, probing_noise, goal;
  std::vector<std::string> artefacts;
  std::optional<double> temperature;

  void add_files_to(CLI::App& parser);
  void add_labels_to(CLI::App& parser);
  void add_noise_to(CLI::App& parser);

  /// The session before its first reading; `nominal` is what the arm's file says. Usage or bad input: a file that
  /// cannot be read, a probe that the arm does not have, features that no stream of an arm measures.
  [[nodiscard]] Expected<RecordingSession> begin(const Arm& nominal, const AccessOption& access) const;
};

}  // namespace artcal
