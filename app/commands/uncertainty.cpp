#include <memory>

#include <fmt/format.h>

#include "acquisition/arm/arm_file.h"
#include "app/commands/command.h"
#include "app/commands/monte_carlo.h"
#include "app/output/output.h"
#include "app/requests/stated_noise.h"
#include "app/results/identification/identified_arm.h"
#include "app/results/uncertainty/uncertainty_result.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

struct UncertaintyArguments {
  CommonOptions common;
  std::string arm;
  std::string probe;
  VolumeSampling sampling;
  MonteCarloRequest monte_carlo;  ///< holds the noise for both
};

Expected<UncertaintySources> sources_of(const UncertaintyArguments& arguments, const ArmFile& file) {
  if (!file.identification) {
    return bad_input(
        "this arm carries no covariance, so nothing is known of its uncertainty; `artcal identify RECORDING -o ARM` "
        "writes one that does",
        file.input.path);
  }
  UncertaintySources sources = uncertainty_sources(file.arm, *file.identification);
  const std::string& encoder_text = arguments.monte_carlo.choices.encoder_noise;
  const std::string& probing_text = arguments.monte_carlo.choices.probing_noise;
  const auto encoder = encoder_text.empty() ? Expected<double>(0.0)
                                            : stated_angle_noise(encoder_text, "--encoder-noise", ZeroNoise::Allowed);
  const auto probing = probing_text.empty() ? Expected<double>(0.0)
                                            : stated_length_noise(probing_text, "--probing-noise", ZeroNoise::Allowed);
  for (const auto* noise : {&encoder, &probing}) {
    if (!*noise) {
      return tl::unexpected(noise->error());
    }
  }
  const bool is_stated = !encoder_text.empty() || !probing_text.empty();
  if (!is_stated && !file.identification->noise && !file.identification->encoder_noise) {
    return wrong_usage(
        "the arm's file does not say how noisy its readings are; state --encoder-noise and "
        "--probing-noise, such as --encoder-noise \"2 arcsec\" --probing-noise \"3 um\"");
  }
  if (is_stated) {
    sources.encoder = *encoder;
    sources.probing = *probing;
  }
  return sources;
}

Expected<int> probe_of(const UncertaintyArguments& arguments, const ArmFile& file) {
  if (arguments.probe.empty()) {
    return 0;
  }
  const int probe = probe_index(file.arm, arguments.probe);
  if (probe < 0) {
    return wrong_usage(fmt::format("the arm has no probe {}", in_quotes(arguments.probe)));
  }
  return probe;
}

Expected<int> survey_and_tell(const UncertaintyArguments& arguments) {
  const auto file = read_arm_file(arguments.arm);
  if (!file) {
    return tl::unexpected(file.error());
  }
  const auto sources = sources_of(arguments, *file);
  if (!sources) {
    return tl::unexpected(sources.error());
  }
  const auto probe = probe_of(arguments, *file);
  if (!probe) {
    return tl::unexpected(probe.error());
  }
  if (auto checked = check_outputs({arguments.common.json}, {file->input}); !checked) {
    return tl::unexpected(checked.error());
  }
  const UncertainArm arm(file->arm, *sources, *probe);
  const SurveyResult result{*file, *sources, *probe, arguments.sampling, survey(arm, arguments.sampling)};
  return arguments.common.tell(to_json(result), to_text(result));
}

}  // namespace

Run set_up_uncertainty(CLI::App& parser) {
  auto arguments = std::make_shared<UncertaintyArguments>();
  parser
      .add_option("file", arguments->arm,
                  "an identified arm, as `artcal identify -o` writes it; with --monte-carlo a recording.toml")
      ->required()
      ->type_name("ARM|RECORDING");
  arguments->monte_carlo.choices.add_noise_of_parts_to(parser);
  parser.add_option("--probe", arguments->probe, "the probe to measure with, where there are several")
      ->type_name("NAME");
  parser.add_option("--lengths", arguments->sampling.lengths, "random places for each length")
      ->check(CLI::Range(1, 1'000'000));
  parser.add_option("--rings", arguments->sampling.rings, "of the map of the volume")->check(CLI::Range(1, 100));
  parser.add_option("--seed", arguments->sampling.seed, "of the random places and postures");
  arguments->monte_carlo.add_to(parser);
  for (const char* of_a_survey : {"--lengths", "--rings"}) {
    parser.get_option("--monte-carlo")->excludes(parser.get_option(of_a_survey));
  }
  arguments->monte_carlo.access.add_to(parser);
  arguments->common.add_to(parser);
  parser.footer(
      "Example:\n  artcal identify examples/ball-bar/recording.toml -o arm.toml\n"
      "  artcal uncertainty arm.toml --encoder-noise \"2 arcsec\" --probing-noise \"3 um\"\n"
      "  artcal uncertainty examples/two-socket-bar/recording.toml --monte-carlo --trials 10000");
  return [arguments] {
    const auto done = arguments->monte_carlo.asked
                          ? monte_carlo_and_tell(arguments->monte_carlo, arguments->common, arguments->arm,
                                                 arguments->probe, arguments->sampling.seed)
                          : survey_and_tell(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
