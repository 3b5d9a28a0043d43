#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "identification/identify.h"

namespace artcal {

/// What a recording asks of its own identification.
IdentifyOptions recorded_options(const Recording& recording);

/// What a command line says of an identification, beside what the recording says of its own.
struct IdentifyChoices {
  std::vector<std::string> hold, free;
  bool accept_misfit = false;
  std::string loss;
  std::string model;  ///< as model_request() reads it; empty: the recording's
  std::string noise, encoder_noise, probing_noise;

  /// Adds --hold, --free, --model, --loss and --noise; `group` heads them in the help.
  void add_to(CLI::App& parser, const std::string& group);
  /// Adds --encoder-noise and --probing-noise.
  void add_noise_of_parts_to(CLI::App& parser);
  /// The recording's choices and these. Usage: a model that is not known, a noise that is none, or half of one and half
  /// of the other.
  [[nodiscard]] Expected<IdentifyOptions> options(const Recording& recording) const;
};

}  // namespace artcal
