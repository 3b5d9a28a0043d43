#include "app/commands/record.h"

#include <csignal>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "acquisition/arm/arm_file.h"
#include "acquisition/csv/csv.h"
#include "acquisition/recording/readings_file.h"
#include "acquisition/recording/recording_text.h"
#include "app/output/output.h"
#include "app/output/phrases.h"
#include "app/stream/line_source.h"
#include "app/stream/recording_session.h"
#include "app/stream/row_file.h"
#include "core/text/in_quotes.h"
#include "core/toml/toml_text.h"

namespace artcal {
namespace {

constexpr int wait_ms = 200;

struct Request {
  CommonOptions common;
  std::string format, source = "-", arm, folder, plan, date;
  std::vector<std::string> artefacts;
  bool follow = false;
};

volatile std::sig_atomic_t stopped = 0;
void stop(int) { stopped = 1; }

// The labels of a table of readings, in its order; its angles are not looked at.
Expected<std::vector<ReadingLabel>> labels_of(const std::string& path, const Arm& arm) {
  Recording planned;
  planned.arm = arm;
  planned.joints.resize(static_cast<Eigen::Index>(arm.joints.size()), 0);
  if (auto read = read_readings(path, {}, planned); !read) {
    return tl::unexpected(read.error());
  }
  std::vector<ReadingLabel> labels;
  for (const Reading& reading : planned.readings) {
    labels.push_back({planned.artefacts.name(reading.artefact), planned.placements.name(reading.placement),
                      planned.features.name(reading.feature)});
  }
  return labels;
}

std::string seen_from(const std::filesystem::path& folder, const std::string& path) {
  std::error_code error;
  const auto relative = std::filesystem::proximate(path, folder, error);
  return error ? path : relative.string();
}

std::string recording_text(const Request& request, const std::filesystem::path& folder) {
  std::string artefacts;
  for (const std::string& path : request.artefacts) {
    artefacts += (artefacts.empty() ? "" : ", ") + toml_text(seen_from(folder, path));
  }
  return fmt::format(
      "# Written by artcal record.\nschema = \"artcal-recording/1\"\nname = {}\n{}arm = {}\nartefacts = [{}]\n"
      "readings = [\"readings.csv\"]\nunits = {{ joint = \"deg\", length = \"mm\" }}\n",
      toml_text(folder.filename().string().empty() ? "recording" : folder.filename().string()),
      request.date.empty() ? "" : fmt::format("date = {}\n", request.date), toml_text(seen_from(folder, request.arm)),
      artefacts);
}

/// A session, its table, and the person who is told.
class Recorder {
 public:
  Recorder(RecordingSession session, RowFile& table, bool talks)
      : session_(std::move(session)), table_(table), talks_(talks) {}

  Expected<void> run(LineSource& source) {
    std::string line;
    while (stopped == 0 && !session_.plan_is_done()) {
      const LineSource::Kind kind = source.next(line, wait_ms);
      if (kind == LineSource::Kind::End) {
        break;
      }
      if (kind == LineSource::Kind::Nothing) {
        continue;
      }
      if (auto done = take(kind == LineSource::Kind::TooLong ? session_.too_long() : step(line)); !done) {
        return done;
      }
    }
    return {};
  }

  [[nodiscard]] const RecordingSession& session() const { return session_; }

 private:
  // Lines that begin with ! are a person's: !feature NAME, !placement NAME, !undo.
  RecordingSession::Step step(const std::string& line) {
    if (!line.starts_with('!')) {
      return session_.feed(line);
    }
    const auto blank = line.find(' ');
    const std::string word = line.substr(1, blank - 1);
    const std::string name = blank == std::string::npos ? "" : line.substr(blank + 1);
    if (word == "feature" && !name.empty()) {
      session_.next_feature(name);
      return {"", "next feature: " + name};
    }
    if (word == "placement" && !name.empty()) {
      session_.next_placement(name);
      return {"", "next placement: " + name};
    }
    if (word == "undo") {
      undone_ = session_.undo();
      return {"", undone_ ? "the last reading is taken back" : "there is no reading to take back"};
    }
    return {"", "not understood: expected !feature NAME, !placement NAME or !undo"};
  }

  Expected<void> take(const RecordingSession::Step& step) {
    if (std::exchange(undone_, false)) {
      if (auto removed = table_.remove_last(); !removed) {
        return removed;
      }
    }
    if (!step.row.empty()) {
      if (auto written = table_.append(step.row); !written) {
        return written;
      }
      if (talks_) {
        fmt::print("{} {}\n", table_.rows(), step.row.substr(0, step.row.find(",", step.row.find(",") + 1)));
        std::fflush(stdout);
      }
    }
    if (!step.message.empty()) {
      fmt::print(stderr, "artcal: {}\n", step.message);
    }
    return {};
  }

  RecordingSession session_;
  RowFile& table_;
  bool talks_;
  bool undone_ = false;
};

Expected<int> record(const Request& request) {
  const auto format = read_stream_format(request.format);
  if (!format) {
    return tl::unexpected(format.error());
  }
  const auto arm = read_arm_file(request.arm);
  if (!arm) {
    return tl::unexpected(arm.error());
  }
  std::vector<ReadingLabel> plan;
  if (!request.plan.empty()) {
    auto labels = labels_of(request.plan, arm->arm);
    if (!labels) {
      return tl::unexpected(labels.error());
    }
    plan = std::move(*labels);
  }
  const std::filesystem::path folder = std::filesystem::path(request.folder).lexically_normal();
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    return bad_input(fmt::format("the folder cannot be made: {}", error.message()), request.folder);
  }
  const RecordingSession empty(arm->arm, *format, plan);
  auto table = RowFile::open(folder / "readings.csv", empty.header());
  if (!table) {
    return tl::unexpected(table.error());
  }
  if (!std::filesystem::exists(folder / "recording.toml")) {
    if (auto written = write_file((folder / "recording.toml").string(), recording_text(request, folder)); !written) {
      return tl::unexpected(written.error());
    }
  }
  auto source = open_source(request.source, request.follow);
  if (!source) {
    return tl::unexpected(source.error());
  }
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
  const std::size_t before = table->rows();
  if (before > 0 && request.common.talks()) {
    fmt::print("goes on after {}\n", plural(before, "reading"));
  }
  Recorder recorder(RecordingSession(arm->arm, *format, std::move(plan), table->first_rows()), *table,
                    request.common.talks());
  if (auto done = recorder.run(**source); !done) {
    return tl::unexpected(done.error());
  }
  nlohmann::ordered_json passed_over = nlohmann::ordered_json::object();
  std::string text = fmt::format("{} in {}, {} of them new\n", plural(table->rows(), "reading"),
                                 (folder / "readings.csv").string(), table->rows() - std::min(before, table->rows()));
  for (const auto& [reason, count] : recorder.session().passed_over()) {
    passed_over[reason] = count;
    text += fmt::format("  passed over {}: {}\n", count, reason);
  }
  text += fmt::format("Look for mistakes with artcal inspect {0}, then artcal identify {0}.\n",
                      (folder / "recording.toml").string());
  const nlohmann::ordered_json json{{"readings", table->rows()}, {"passed_over", passed_over}};
  return request.common.tell(json, text);
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
  parser.add_option("--plan", request->plan, "a table of readings whose labels are those of the readings to come")
      ->type_name("FILE.csv");
  parser.add_option("--date", request->date, "of the measurement, such as 2026-03-10")->type_name("DATE");
  request->common.add_to(parser);
  parser.footer(
      "Lines !feature NAME, !placement NAME and !undo among the events set the labels.\n"
      "Example:\n  artcal record examples/streams/faro-json.toml --arm arm.toml --artefact bar.toml -o today");
  return [request] {
    const auto done = record(*request);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
