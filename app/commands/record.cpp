#include <chrono>
#include <ctime>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "acquisition/arm/arm_file.h"
#include "app/commands/command.h"
#include "app/commands/identify.h"
#include "app/output/output.h"
#include "app/output/phrases.h"
#include "app/output/stop_on_signal.h"
#include "app/requests/access_option.h"
#include "app/results/result_head.h"
#include "app/stream/recorder.h"
#include "app/stream/recording_folder.h"
#include "app/stream/recording_session.h"
#include "app/stream/session_request.h"
#include "app/stream/source/line_source.h"
#include "app/stream/source/terminal_keys.h"
#include "core/calendar_date.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

struct RecordArguments {
  CommonOptions common;
  AccessOption access;
  SessionRequest session;
  std::string source = "-", folder, date, identified, result;
  bool follow = false;
};

std::string today() {
  return fmt::format("{:%Y-%m-%d}",
                     fmt::localtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

nlohmann::ordered_json record_json(const RecordArguments& arguments, const RecordingSession& session, std::size_t rows,
                                   std::size_t before) {
  auto json = result_head("record");
  json["folder"] = arguments.folder;
  json["readings"] = rows;
  json["earlier_readings"] = before;
  json["passed_over"] = nlohmann::ordered_json::array();
  for (const auto& [reason, count] : session.passed_over()) {
    json["passed_over"].push_back({{"reason", reason}, {"count", count}});
  }
  json["mistakes"] = session.mistakes();
  return json;
}

std::string record_text(const RecordArguments& arguments, const RecordingSession& session, std::size_t rows,
                        std::size_t before) {
  const std::string folder = arguments.folder.ends_with('/') ? arguments.folder : arguments.folder + "/";
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

Expected<void> record_events(const RecordArguments& arguments, LineSource& source, RecordingSession& session,
                             RowFile& table) {
  Recorder::Person person;
  person.tell_reading = [talks = arguments.common.talks()](const std::string& reading) {
    if (talks) {
      fmt::print("{}\n", reading);
      std::fflush(stdout);
    }
  };
  person.tell = [](const std::string& message) { fmt::print(stderr, "artcal: {}\n", message); };
  std::optional<TerminalKeys> keys;
  if (arguments.source != "-" && arguments.common.talks() && keys.emplace().are_there()) {
    fmt::print(stderr, "keys: {}\n", recorder_keys);
    person.next_key = [&] { return keys->next(); };
  }
  const StopOnSignal signal;
  return Recorder(session, table, std::move(person)).run(source, signal.stop());
}

Expected<int> record(const RecordArguments& arguments) {
  if (!arguments.date.empty() && !is_calendar_date(arguments.date)) {
    return wrong_usage(fmt::format("--date is {}, expected a day such as 2026-03-10", in_quotes(arguments.date)));
  }
  const auto arm = read_arm_file(arguments.session.arm);
  if (!arm) {
    return tl::unexpected(arm.error());
  }
  auto session = arguments.session.begin(arm->arm, arguments.access);
  if (!session) {
    return tl::unexpected(session.error());
  }
  auto source = open_source(arguments.source, arguments.follow);
  if (!source) {
    return tl::unexpected(source.error());
  }
  const RecordingBegin begin{arguments.folder,
                             arguments.session.arm,
                             {arguments.session.artefacts.begin(), arguments.session.artefacts.end()},
                             arguments.date.empty() ? today() : arguments.date};
  auto table = begin_recording(
      begin, arguments.access.anywhere ? FileAccess::anywhere() : FileAccess::beside(arguments.session.arm),
      session->header());
  if (!table) {
    return tl::unexpected(table.error());
  }
  const std::size_t before = table->rows();
  if (auto resumed = session->resume(table->first_rows()); !resumed) {
    return tl::unexpected(resumed.error());
  }
  if (before > 0 && arguments.common.talks()) {
    fmt::print("goes on after {}\n", plural(before, "reading"));
  }
  if (auto done = record_events(arguments, **source, *session, *table); !done) {
    return tl::unexpected(done.error());
  }
  const auto told = arguments.common.tell(record_json(arguments, *session, table->rows(), before),
                                          record_text(arguments, *session, table->rows(), before),
                                          session->mistakes().empty() ? 0 : mistakes_found);
  const std::string recording = (std::filesystem::path(arguments.folder) / "recording.toml").string();
  if (!told || (arguments.identified.empty() && arguments.result.empty())) {
    arguments.common.say(
        fmt::format("Look for mistakes with artcal inspect {0}, then artcal identify {0}.\n", recording));
    return told;
  }
  arguments.common.say("\n");
  return identify_recording(recording, arguments.identified, arguments.result, arguments.common.quiet)
      .map([&](int exit_code) { return exit_code == 0 ? *told : exit_code; });
}

}  // namespace

Run set_up_record(CLI::App& parser) {
  auto arguments = std::make_shared<RecordArguments>();
  arguments->session.add_files_to(parser);
  parser.add_option("-o,--output", arguments->folder, "the folder of the recording; one that was begun is continued")
      ->required()
      ->type_name("FOLDER");
  parser
      .add_option("--source", arguments->source,
                  "where events come from: - (standard input), a file, tcp://HOST:PORT, listen://PORT (loopback), "
                  "serial:///dev/ttyUSB0?baud=115200")
      ->type_name("SOURCE");
  parser.add_flag("--follow", arguments->follow, "wait for more at the end of a file");
  arguments->session.add_labels_to(parser);
  parser.add_option("--date", arguments->date, "of the measurement; by default today")->type_name("DATE");
  arguments->session.add_noise_to(parser);
  parser.add_option("--identified", arguments->identified, "identify at the end, and write the identified arm")
      ->type_name("ARM");
  parser.add_option("--result", arguments->result, "identify at the end, and write the result as identify --json does")
      ->type_name("FILE");
  arguments->access.add_to(parser);
  arguments->common.add_to(parser);
  parser.footer(
      "Keys on the terminal, or lines among the events, set what is read next: n (!next feature), p (!next placement), "
      "u (!undo). The exit code is 1 where events contradict the files.\n"
      "Examples:\n  artcal record examples/streams/faro-json.toml --arm examples/ball-bar/arm.toml \\\n"
      "    --artefact examples/ball-bar/bar.toml --source tcp://localhost:4000 -o today");
  return [arguments] {
    const auto done = record(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
