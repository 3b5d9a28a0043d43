#include <chrono>
#include <csignal>
#include <ctime>
#include <filesystem>
#include <memory>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "acquisition/arm/arm_file.h"
#include "app/commands/command.h"
#include "app/commands/identify.h"
#include "app/output/output.h"
#include "app/output/phrases.h"
#include "app/requests/access_option.h"
#include "app/results/result_head.h"
#include "app/stream/recording_folder.h"
#include "app/stream/recording_session.h"
#include "app/stream/source/line_source.h"
#include "app/stream/source/terminal_keys.h"
#include "artefacts/artefact/artefact_file.h"
#include "core/calendar_date.h"
#include "core/text/in_quotes.h"
#include "core/unit_names.h"
#include "identification/planning/session_information.h"

namespace artcal {
namespace {

constexpr int mistakes_found = 1;
constexpr int wait_ms = 50;

struct Request {
  CommonOptions common;
  AccessOption access;
  std::string format, source = "-", arm, folder, plan, probe, date, identified, result;
  std::string encoder_noise, probing_noise, goal;
  std::vector<std::string> artefacts;
  std::optional<double> temperature;
  bool follow = false;
};

volatile std::sig_atomic_t stopped = 0;
void stop(int) { stopped = 1; }

std::string today() {
  return fmt::format("{:%Y-%m-%d}",
                     fmt::localtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

/// A session, its table, and the person who is told.
class Recorder {
 public:
  Recorder(RecordingSession& session, RowFile& table, bool talks) : session_(session), table_(table), talks_(talks) {}

  Expected<void> run(LineSource& source, bool has_keys) {
    TerminalKeys keys;
    has_keys = has_keys && keys.are_there();
    if (has_keys) {
      fmt::print(stderr, "keys: n next feature, p next placement, u undo the last reading, q end\n");
    }
    std::string line;
    while (stopped == 0 && !session_.labels().has_ended()) {
      for (auto key = has_keys ? keys.next() : std::nullopt; key; key = keys.next()) {
        if (auto done = press(*key); !done) {
          return done;
        }
      }
      const LineSource::Kind kind = source.next(line, wait_ms);
      if (kind == LineSource::Kind::End) {
        break;
      }
      if (auto done = take(step(kind, line, source.is_live())); !done) {
        return done;
      }
    }
    return {};
  }

 private:
  static double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }

  RecordingSession::Step step(LineSource::Kind kind, const std::string& line, bool is_live) {
    switch (kind) {
      case LineSource::Kind::Line: return session_.feed(line, is_live ? std::optional(now()) : std::nullopt);
      case LineSource::Kind::CutOff: return session_.cut_off(line);
      case LineSource::Kind::TooLong: return session_.too_long();
      case LineSource::Kind::Nothing:
      case LineSource::Kind::End: break;
    }
    return {};
  }

  Expected<void> press(char key) {
    for (const auto& [known, words] : {std::pair('n', "next feature"), {'p', "next placement"}, {'u', "undo"}}) {
      if (key == known) {
        return take(session_.operate(words));
      }
    }
    stopped = key == 'q' ? 1 : stopped;
    return {};
  }

  Expected<void> take(const RecordingSession::Step& step) {
    if (step.removes_last) {
      if (auto removed = table_.remove_last(); !removed) {
        return removed;
      }
    }
    if (!step.row.empty()) {
      if (auto written = table_.append(step.row); !written) {
        return written;
      }
      if (talks_) {
        fmt::print("{} {}{}{}\n", table_.rows(), step.label, step.note.empty() ? "" : "  ", step.note);
        std::fflush(stdout);
      }
    }
    if (!step.message.empty()) {
      fmt::print(stderr, "artcal: {}\n", step.message);
    }
    return {};
  }

  RecordingSession& session_;
  RowFile& table_;
  bool talks_;
};

Expected<std::vector<Artefact>> read_artefacts(const Request& request) {
  std::vector<Artefact> artefacts;
  for (const std::string& path : request.artefacts) {
    auto file = read_artefact_file(path, request.access.of(path));
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

Expected<int> find_probe(const Request& request, const Arm& arm) {
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

Expected<double> quantity(const std::string& text, const char* option,
                          std::optional<double> (*unit)(std::string_view)) {
  const auto value = unit(text);
  if (!value || !(*value > 0.0)) {
    return wrong_usage(fmt::format("{} is {}, expected a number above zero with its unit such as {}", option,
                                   in_quotes(text), unit == angle_quantity ? "\"2 arcsec\"" : "\"3 um\""));
  }
  return *value;
}

// What the readings determine is told where the noise is stated: readings are worth what it says.
Expected<void> predict(const Request& request, const Arm& arm, const std::vector<Artefact>& artefacts,
                       RecordingSession& session) {
  if (request.encoder_noise.empty() && request.probing_noise.empty()) {
    return request.goal.empty() ? Expected<void>()
                                : wrong_usage(
                                      "--goal needs --encoder-noise and --probing-noise, by which the u of "
                                      "lengths is predicted");
  }
  const auto encoder = quantity(request.encoder_noise, "--encoder-noise", angle_quantity);
  const auto probing = quantity(request.probing_noise, "--probing-noise", length_quantity);
  const auto goal = request.goal.empty() ? Expected<double>(0.0) : quantity(request.goal, "--goal", length_quantity);
  for (const auto* read : {&encoder, &probing, &goal}) {
    if (!*read) {
      return tl::unexpected(read->error());
    }
  }
  session.predict(SessionInformation(arm, artefacts, *encoder, *probing), *goal);
  return {};
}

Expected<RecordingSession> begin_session(const Request& request, const Arm& arm) {
  auto format = read_stream_format(request.format).and_then([&](StreamFormat&& read) {
    return for_arm(std::move(read), arm, request.format);
  });
  if (!format) {
    return tl::unexpected(format.error());
  }
  const auto artefacts = read_artefacts(request);
  if (!artefacts) {
    return tl::unexpected(artefacts.error());
  }
  const auto probe = find_probe(request, arm);
  if (!probe) {
    return tl::unexpected(probe.error());
  }
  LabelSequence::Constants constants;
  if (arm.probes.size() > 1) {
    constants.emplace_back("probe", arm.probes[static_cast<std::size_t>(*probe)].name);
  }
  if (request.temperature) {
    constants.emplace_back("temperature", fmt::format("{}", *request.temperature));
  }
  LabelSequence labels(*artefacts, constants);
  if (!request.plan.empty()) {
    if (auto planned = labels.follow(request.plan); !planned) {
      return tl::unexpected(planned.error());
    }
  }
  RecordingSession session(arm, *probe, *artefacts, std::move(*format), std::move(labels));
  if (auto predicted = predict(request, arm, *artefacts, session); !predicted) {
    return tl::unexpected(predicted.error());
  }
  return session;
}

nlohmann::ordered_json to_json(const Request& request, const RecordingSession& session, std::size_t rows,
                               std::size_t before) {
  auto json = result_head("record");
  json["folder"] = request.folder;
  json["readings"] = rows;
  json["earlier_readings"] = before;
  json["passed_over"] = nlohmann::ordered_json::array();
  for (const auto& [reason, count] : session.passed_over()) {
    json["passed_over"].push_back({{"reason", reason}, {"count", count}});
  }
  json["mistakes"] = session.mistakes();
  return json;
}

std::string to_text(const Request& request, const RecordingSession& session, std::size_t rows, std::size_t before) {
  const std::string folder = request.folder.ends_with('/') ? request.folder : request.folder + "/";
  std::string text = fmt::format("\n{} in {}readings.csv{}\n", plural(rows, "reading"), folder,
                                 before > 0 ? fmt::format(", {} of an earlier run", before) : "");
  for (const auto& [reason, count] : session.passed_over()) {
    text += fmt::format("  passed over {}: {}\n", count, reason);
  }
  for (const std::string& mistake : session.mistakes()) {
    text += "Mistake: " + as_sentence(mistake) + "\n";
  }
  return text;
}

Expected<int> record(const Request& request) {
  if (!request.date.empty() && !is_calendar_date(request.date)) {
    return wrong_usage(fmt::format("--date is {}, expected a day such as 2026-03-10", in_quotes(request.date)));
  }
  const auto arm = read_arm_file(request.arm);
  if (!arm) {
    return tl::unexpected(arm.error());
  }
  auto session = begin_session(request, arm->arm);
  if (!session) {
    return tl::unexpected(session.error());
  }
  auto source = open_source(request.source, request.follow);
  if (!source) {
    return tl::unexpected(source.error());
  }
  const RecordingBegin begin{request.folder,
                             request.arm,
                             {request.artefacts.begin(), request.artefacts.end()},
                             request.date.empty() ? today() : request.date};
  auto table = begin_recording(
      begin, request.access.anywhere ? FileAccess::anywhere() : FileAccess::beside(request.arm), session->header());
  if (!table) {
    return tl::unexpected(table.error());
  }
  const std::size_t before = table->rows();
  if (auto resumed = session->resume(table->first_rows()); !resumed) {
    return tl::unexpected(resumed.error());
  }
  if (before > 0 && request.common.talks()) {
    fmt::print("goes on after {}\n", plural(before, "reading"));
  }
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
  Recorder recorder(*session, *table, request.common.talks());
  if (auto done = recorder.run(**source, request.source != "-" && request.common.talks()); !done) {
    return tl::unexpected(done.error());
  }
  const auto told = request.common.tell(to_json(request, *session, table->rows(), before),
                                        to_text(request, *session, table->rows(), before),
                                        session->mistakes().empty() ? 0 : mistakes_found);
  const std::string recording = (std::filesystem::path(request.folder) / "recording.toml").string();
  if (!told || (request.identified.empty() && request.result.empty())) {
    request.common.say(
        fmt::format("Look for mistakes with artcal inspect {0}, then artcal identify {0}.\n", recording));
    return told;
  }
  request.common.say("\n");
  return identify_recording(recording, request.identified, request.result, request.common.quiet)
      .map([&](int exit_code) { return exit_code == 0 ? *told : exit_code; });
}

}  // namespace

Run set_up_record(CLI::App& parser) {
  auto request = std::make_shared<Request>();
  parser.add_option("stream", request->format, "stream.toml: the form of the arm's events")
      ->required()
      ->type_name("STREAM");
  parser.add_option("--arm", request->arm, "the nominal arm")->required()->type_name("ARM");
  parser.add_option("--artefact", request->artefacts, "an artefact's file; may be given several times")
      ->required()
      ->type_name("FILE");
  parser.add_option("-o,--output", request->folder, "the folder of the recording; one that was begun is continued")
      ->required()
      ->type_name("FOLDER");
  parser
      .add_option("--source", request->source,
                  "where events come from: - (standard input), a file, tcp://HOST:PORT, listen://PORT (loopback), "
                  "serial:///dev/ttyUSB0?baud=115200")
      ->type_name("SOURCE");
  parser.add_flag("--follow", request->follow, "wait for more at the end of a file");
  parser
      .add_option("--plan", request->plan,
                  "a table whose columns artefact, placement, feature, … label the readings to come, such as that of "
                  "artcal plan")
      ->type_name("FILE.csv");
  parser.add_option("--probe", request->probe, "the probe, where the arm has several")->type_name("NAME");
  parser.add_option("--temperature", request->temperature, "of the artefacts, in degC; written to every reading");
  parser.add_option("--date", request->date, "of the measurement; by default today")->type_name("DATE");
  parser.add_option(
      "--encoder-noise", request->encoder_noise,
      "noise of each joint, such as \"2 arcsec\"; with --probing-noise the uncertainty of lengths that the "
      "readings lead to is told after each");
  parser.add_option("--probing-noise", request->probing_noise,
                    "noise of the tip's coordinates beside the joints', such as \"3 um\"");
  parser.add_option("--goal", request->goal, "u of a length to reach, such as \"20 um\"; told beside");
  parser.add_option("--identified", request->identified, "identify at the end, and write the identified arm")
      ->type_name("ARM");
  parser.add_option("--result", request->result, "identify at the end, and write the result as identify --json does")
      ->type_name("FILE");
  request->access.add_to(parser);
  request->common.add_to(parser);
  parser.footer(
      "Keys on the terminal, or lines among the events, set what is read next: n (!next feature), p (!next placement), "
      "u (!undo). The exit code is 1 where events contradict the files.\n"
      "Examples:\n  artcal record examples/streams/faro-json.toml --arm examples/ball-bar/arm.toml \\\n"
      "    --artefact examples/ball-bar/bar.toml --source tcp://localhost:4000 -o today");
  return [request] {
    const auto done = record(*request);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
