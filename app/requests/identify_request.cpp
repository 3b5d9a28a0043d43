#include "app/requests/identify_request.h"

#include <fmt/format.h>

#include "app/requests/model_asked.h"
#include "app/requests/stated_noise.h"

namespace artcal {
namespace {

// The command line replaces the recording's noise as a whole: half of one and half of the other is neither.
Expected<Noise> noise_of(const IdentifyChoices& choices, const Recording& recording) {
  if (choices.noise.empty() && choices.encoder_noise.empty() && choices.probing_noise.empty()) {
    return recording.noise;
  }
  Noise noise;
  const auto put = [](const std::string& text, const char* option, auto read, std::optional<double>& into) {
    return text.empty() ? Expected<void>()
                        : read(text, option, ZeroNoise::Refused).map([&](double value) { into = value; });
  };
  for (const auto& done : {put(choices.noise, "--noise", stated_length_noise, noise.reading),
                           put(choices.encoder_noise, "--encoder-noise", stated_angle_noise, noise.encoder),
                           put(choices.probing_noise, "--probing-noise", stated_length_noise, noise.probing)}) {
    if (!done) {
      return tl::unexpected(done.error());
    }
  }
  if (noise.reading.has_value() == noise.encoder.has_value() ||
      noise.encoder.has_value() != noise.probing.has_value()) {
    return wrong_usage("state either --noise, or --encoder-noise and --probing-noise together");
  }
  return noise;
}

// "none", "huber" or "cauchy".
Loss loss_named(const std::string& name) {
  return name == "huber" ? Loss::Huber : name == "cauchy" ? Loss::Cauchy : Loss::None;
}

}  // namespace

IdentifyOptions recorded_options(const Recording& recording) {
  IdentifyOptions options;
  options.hold = recording.identify.hold;
  options.free = recording.identify.free;
  options.loss = loss_named(recording.identify.loss);
  options.noise = recording.noise;
  return options;
}

void IdentifyChoices::add_to(CLI::App& parser, const std::string& group) {
  parser.add_option("--hold", hold, "parameters to keep at their nominal value, such as l,a1")
      ->delimiter(',')
      ->type_name("NAMES")
      ->group(group);
  parser.add_option("--free", free, "parameters to identify although they are fixed by default, such as a6")
      ->delimiter(',')
      ->type_name("NAMES")
      ->group(group);
  parser
      .add_option("--model", model,
                  "what is identified: dh, or dh with groups of parameters behind it, such as dh+eccentricity+gravity "
                  "(of eccentricity, eccentricity2, gain, coupling, gravity, thermal, hayati, tip, radius); auto adds "
                  "groups while placements left out improve by more than noise")
      ->type_name("MODEL")
      ->group(group);
  parser.add_option("--loss", loss, "how readings far off count")
      ->check(CLI::IsMember({"none", "huber", "cauchy"}))
      ->group(group);
  parser
      .add_flag("--accept-misfit", accept_misfit,
                "write an arm that does not fit its readings all the same, marked as such; by default exit code 4")
      ->group(group);
  parser.add_option("--noise", noise, "noise of a reading's coordinate, such as \"15 um\"; else estimated")
      ->group(group);
}

void IdentifyChoices::add_noise_of_parts_to(CLI::App& parser) {
  parser.add_option("--encoder-noise", encoder_noise, "noise of each joint, such as \"2 arcsec\"");
  parser.add_option("--probing-noise", probing_noise, "noise of the tip beside the joints', such as \"3 um\"");
}

Expected<IdentifyOptions> IdentifyChoices::options(const Recording& recording) const {
  IdentifyOptions options = recorded_options(recording);
  options.hold.insert(options.hold.end(), hold.begin(), hold.end());
  options.free.insert(options.free.end(), free.begin(), free.end());
  const auto asked = model_asked(model, recording);
  if (!asked) {
    return tl::unexpected(asked.error());
  }
  options.model = asked->groups;
  options.automatic = asked->automatic;
  options.accept_misfit = accept_misfit;
  options.loss = loss.empty() ? options.loss : loss_named(loss);
  return noise_of(*this, recording).map([&](const Noise& given) {
    options.noise = given;
    return options;
  });
}

}  // namespace artcal
