#include "app/stream/session_request.h"

#include <utility>

#include <fmt/format.h>

#include "app/requests/stated_noise.h"
#include "artefacts/artefact/artefact_file.h"
#include "core/text/in_quotes.h"
#include "identification/planning/session_information.h"

namespace artcal {
namespace {

Expected<std::vector<Artefact>> read_artefacts(const SessionRequest& request, const AccessOption& access) {
  std::vector<Artefact> artefacts;
  for (const std::string& path : request.artefacts) {
    auto file = read_artefact_file(path, access.of(path));
    if (!file) {
      return tl::unexpected(file.error());
    }
    for (const CertifiedFeature& feature : file->artefact.features) {
      if (feature.kind == FeatureKind::Anchor || feature.kind == FeatureKind::Coordinates) {
        return bad_input(fmt::format("the feature {} is measured by another instrument too, whose values no stream of "
                                     "an arm has; write its readings into a table by hand",
                                     in_quotes(feature.name)),
                         path);
      }
    }
    artefacts.push_back(std::move(file->artefact));
  }
  return artefacts;
}

Expected<int> find_probe(const SessionRequest& request, const Arm& arm) {
  const int probe = request.probe.empty() ? (arm.probes.size() == 1 || !request.plan.empty() ? 0 : -1)
                                          : probe_index(arm, request.probe);
  if (probe >= 0) {
    return probe;
  }
  std::string known;
  for (const Probe& p : arm.probes) {
    known += (known.empty() ? "" : ", ") + p.name;
  }
  return wrong_usage(
      fmt::format("--probe is {}, expected one of the arm's probes: {}", in_quotes(request.probe), known));
}

// What the readings determine is told where the noise is stated: readings are worth what it says.
Expected<void> predict(const SessionRequest& request, const Arm& arm, const std::vector<Artefact>& artefacts,
                       RecordingSession& session) {
  if (request.encoder_noise.empty() && request.probing_noise.empty()) {
    return request.goal.empty() ? Expected<void>()
                                : wrong_usage(
                                      "--goal needs --encoder-noise and --probing-noise, by which the u of "
                                      "lengths is predicted");
  }
  const auto encoder = stated_angle_noise(request.encoder_noise, "--encoder-noise");
  const auto probing = stated_length_noise(request.probing_noise, "--probing-noise");
  const auto goal = request.goal.empty() ? Expected<double>(0.0) : stated_length_noise(request.goal, "--goal");
  for (const auto* read : {&encoder, &probing, &goal}) {
    if (!*read) {
      return tl::unexpected(read->error());
    }
  }
  session.predict(SessionInformation(arm, artefacts, *encoder, *probing), *goal);
  return {};
}

}  // namespace

void SessionRequest::add_files_to(CLI::App& parser) {
  parser.add_option("stream", format, "stream.toml: the form of the arm's events")->required()->type_name("STREAM");
  parser.add_option("--arm", arm, "the nominal arm")->required()->type_name("ARM");
  parser.add_option("--artefact", artefacts, "an artefact's file; may be given several times")
      ->required()
      ->type_name("FILE");
}

void SessionRequest::add_labels_to(CLI::App& parser) {
  parser
      .add_option("--plan", plan,
                  "a table whose columns artefact, placement, feature, … label the readings to come, such as that of "
                  "artcal plan")
      ->type_name("FILE.csv");
  parser.add_option("--probe", probe, "the probe, where the arm has several")->type_name("NAME");
  parser.add_option("--temperature", temperature, "of the artefacts, in degC; written to every reading");
}

void SessionRequest::add_noise_to(CLI::App& parser) {
  parser.add_option(
      "--encoder-noise", encoder_noise,
      "noise of each joint, such as \"2 arcsec\"; with --probing-noise the uncertainty of lengths that the "
      "readings lead to is told after each");
  parser.add_option("--probing-noise", probing_noise,
                    "noise of the tip's coordinates beside the joints', such as \"3 um\"");
  parser.add_option("--goal", goal, "u of a length to reach, such as \"20 um\"; told beside");
}

Expected<RecordingSession> SessionRequest::begin(const Arm& nominal, const AccessOption& access) const {
  auto form = read_stream_format(format).and_then(
      [&](StreamFormat&& read) { return for_arm(std::move(read), nominal, format); });
  if (!form) {
    return tl::unexpected(form.error());
  }
  const auto certified = read_artefacts(*this, access);
  if (!certified) {
    return tl::unexpected(certified.error());
  }
  const auto first_probe = find_probe(*this, nominal);
  if (!first_probe) {
    return tl::unexpected(first_probe.error());
  }
  LabelSequence::Constants constants;
  if (nominal.probes.size() > 1) {
    constants.emplace_back("probe", nominal.probes[static_cast<std::size_t>(*first_probe)].name);
  }
  if (temperature) {
    constants.emplace_back("temperature", fmt::format("{}", *temperature));
  }
  LabelSequence labels(*certified, constants);
  if (!plan.empty()) {
    if (auto planned = labels.follow(plan); !planned) {
      return tl::unexpected(planned.error());
    }
  }
  RecordingSession session(nominal, *first_probe, *certified, std::move(*form), std::move(labels));
  if (auto predicted = predict(*this, nominal, *certified, session); !predicted) {
    return tl::unexpected(predicted.error());
  }
  return session;
}

}  // namespace artcal
