#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "acquisition/arm/arm_file.h"
#include "acquisition/point_cloud/pcd/pcd_text.h"
#include "acquisition/recording/recording_text.h"
#include "acquisition/recording/tip_centres.h"
#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/output/output_folder.h"
#include "app/output/table.h"
#include "app/requests/access_option.h"
#include "app/results/planning/simulation_json.h"
#include "app/stream/planted_mistake.h"
#include "app/stream/virtual_events.h"
#include "app/version.h"
#include "artefacts/simulation/pattern.h"
#include "artefacts/simulation/plan/plan_file.h"
#include "artefacts/simulation/simulate.h"
#include "artefacts/verification/point_uncertainty.h"
#include "core/files/text_file.h"
#include "core/text/in_quotes.h"
#include "core/toml/toml_text.h"
#include "core/units.h"

namespace artcal {
namespace {

struct SimulateArguments {
  CommonOptions common;
  AccessOption access;
  std::string plan;
  std::string folder;
  bool force = false;
  std::optional<std::uint64_t> seed;
  int threads = 0;
  bool stream = false;
  double rate = 0.0;  // readings a second; 0: as fast as it goes
  std::vector<std::string> mistakes;
};

// Files that are made, not copied.
std::vector<std::string> made_names(const SimulationPlan& plan) {
  std::vector<std::string> names{"recording.toml", "readings.csv", "truth-arm.toml", "truth.json"};
  for (int i = 1; i <= planned_scans(plan); ++i) {
    names.push_back(fmt::format("scan-{}.pcd", i));
  }
  return names;
}

/// What is copied beside the recording, and under which names.
struct Copies {
  RecordingFiles names;
  FolderFiles files;
};

// Artefacts keep their names: where a file states no name for the artefact, the file's own is it.
Expected<std::string> free_name(const std::filesystem::path& path, const char* what, std::vector<std::string>& taken) {
  std::string name = path.filename().string();
  if (std::find(taken.begin(), taken.end(), name) != taken.end()) {
    return bad_input(fmt::format("the {} is called {}, as another file of the recording will be; give it another name",
                                 what, in_quotes(name)),
                     path.string());
  }
  taken.push_back(name);
  return name;
}

// A certificate lies beside the copy of its artefact, wherever it lay.
Expected<std::string> with_certificate_beside(std::string artefact, const std::filesystem::path& path,
                                              const std::string& named, const std::string& name) {
  if (named == name) {
    return artefact;
  }
  const std::size_t key = artefact.find("dcc");
  for (const char quote : {'"', '\''}) {
    const std::string value = quote + named + quote;
    if (const std::size_t at = artefact.find(value, key); key != std::string::npos && at != std::string::npos) {
      return artefact.replace(at, value.size(), toml_text(name));
    }
  }
  return bad_input(
      "the certificate named in `dcc` cannot be copied; put it into the artefact's folder and name it there",
      path.string());
}

Expected<Copies> copies_of(const PlanFile& file) {
  Copies copies{{"arm.toml", {}, "readings.csv"}, {}};
  std::vector<std::string> taken = made_names(file.plan);
  taken.push_back(copies.names.arm);
  std::map<std::string, std::string> certificates;  // path and name
  std::vector<std::pair<std::string, std::filesystem::path>> sources{{copies.names.arm, file.arm}};
  for (const auto& path : file.artefacts) {
    auto name = free_name(path, "artefact's file", taken);
    if (!name) {
      return tl::unexpected(name.error());
    }
    copies.names.artefacts.push_back(*name);
    sources.emplace_back(*name, path);
  }
  for (const auto& certificate : file.certificates) {
    if (const std::string path = certificate.path.string(); !path.empty() && !certificates.contains(path)) {
      auto name = free_name(certificate.path, "artefact's certificate", taken);
      if (!name) {
        return tl::unexpected(name.error());
      }
      certificates[path] = *name;
      sources.emplace_back(*name, certificate.path);
    }
  }
  for (std::size_t i = 0; i < sources.size(); ++i) {
    auto text = read_text_file(sources[i].second).map([](TextFile&& read) { return std::move(read.text); });
    const std::size_t artefact = i - 1;  // the arm comes first
    if (text && i > 0 && artefact < file.certificates.size() && !file.certificates[artefact].path.empty()) {
      const PlanFile::CertificateFile& certificate = file.certificates[artefact];
      text = with_certificate_beside(std::move(*text), sources[i].second, certificate.name,
                                     certificates.at(certificate.path.string()));
    }
    if (!text) {
      return tl::unexpected(text.error());
    }
    copies.files.emplace_back(sources[i].first, std::move(*text));
  }
  return copies;
}

Expected<FolderFiles> scan_files(const Simulation& simulation) {
  FolderFiles files;
  const Recording& recording = simulation.recording;
  const auto tips = tip_centres(recording, recording.arm);  // as the arm's own software would have them
  if (!tips) {
    return tl::unexpected(tips.error());
  }
  for (const SimulatedScan& scan : simulation.scans) {
    files.emplace_back(scan.file, pcd_file_text(tips->in_base(Eigen::all, scan.readings),
                                                recording.joints(Eigen::all, scan.readings)));
  }
  return files;
}

FolderFiles made_files(const PlanFile& file, const Simulation& simulation, const RecordingFiles& names,
                       const nlohmann::ordered_json& truth) {
  std::vector<std::string> comment{
      fmt::format("Simulated by artcal {}, seed {}; the true values are in truth-arm.toml and truth.json.",
                  program_version, file.plan.seed)};
  const Noise& noise = simulation.recording.noise;
  if (!noise.is_given()) {
    comment.emplace_back("The noise is not the same for all joints, or zero: identify estimates it.");
  }
  const Recording written = recording_with_scans(simulation);
  FolderFiles files{{"recording.toml", recording_file_text(written, names, comment)},
                    {"truth-arm.toml", arm_file_text(simulation.arm.arm, std::nullopt)},
                    {"truth.json", json_text(truth)}};
  if (!written.readings.empty()) {
    files.emplace_back("readings.csv", readings_file_text(written));
  }
  return files;
}

// Of each probing of balls whose points lie on so small a part that verification shows nothing by them.
std::string dilution_text(const SimulationPlan& plan) {
  std::string text;
  for (const PlannedProbing& probing : plan.probings) {
    const auto& features = plan.artefacts[static_cast<std::size_t>(probing.artefact)].certified.features;
    const bool on_balls = std::any_of(probing.features.begin(), probing.features.end(), [&](int feature) {
      return features[static_cast<std::size_t>(feature)].kind == FeatureKind::Sphere;
    });
    if (!on_balls || probing.scan) {
      continue;
    }
    RandomStream random(plan.seed, "dilution of a pattern");
    if (const double dilution = centre_dilution(directions_on_ball(probing, random)); dilution > max_dilution) {
      text += fmt::format(
          "\nWarning: {} points within {:.0f} degrees of the pole determine a ball's centre with {} the scatter of one "
          "touch; spread them farther\n",
          probing.points, probing.cap / units::degree,
          std::isfinite(dilution) ? fmt::format("{:.1f} times", dilution) : "no bound beside");
    }
  }
  return text;
}

std::string summary(const PlanFile& file, const Simulation& simulation, const SimulateArguments& arguments) {
  const SimulationPlan& plan = file.plan;
  std::string text = fmt::format("{}\narm \"{}\": {} simulated readings, {} placements, seed {}\n\n",
                                 truncated(200, plan.name), truncated(80, plan.nominal.name),
                                 simulation.recording.readings.size(), simulation.placements.size(), plan.seed);
  Table table({"placement", "readings", "x mm", "y mm", "z mm", "degC"});
  constexpr std::size_t max_rows = 20;
  for (const RealPlacement& placement : simulation.placements) {
    const Eigen::Vector3d& at = placement.base_from_artefact.translation;
    table.add({truncated(40, placement.name), fmt::format("{}", placement.readings), fmt::format("{:.1f}", at.x()),
               fmt::format("{:.1f}", at.y()), fmt::format("{:.1f}", at.z()),
               fmt::format("{:.2f}", placement.temperature)});
    if (&placement - simulation.placements.data() + 1 == max_rows && simulation.placements.size() > max_rows) {
      table.add({fmt::format("… {} more", simulation.placements.size() - max_rows)});
      break;
    }
  }
  const std::string folder = arguments.folder.ends_with('/') ? arguments.folder : arguments.folder + "/";
  return text + table.text() + dilution_text(plan) +
         fmt::format("\nThe recording is {}recording.toml; the truth is in truth-arm.toml and truth.json beside it.\n",
                     folder);
}

Expected<int> simulate_and_write(const SimulateArguments& arguments) {
  auto file = read_plan_file(arguments.plan, arguments.access.of(arguments.plan));
  if (!file) {
    return tl::unexpected(file.error());
  }
  file->plan.seed = arguments.seed.value_or(file->plan.seed);
  auto copies = copies_of(*file);
  if (!copies) {
    return tl::unexpected(copies.error());
  }
  FolderFiles& files = copies->files;
  if (auto checked = check_outputs({arguments.common.json}, file->inputs); !checked) {
    return tl::unexpected(checked.error());
  }
  FolderFiles all = files;
  for (const std::string& name : made_names(file->plan)) {
    all.emplace_back(name, "");
  }
  if (auto checked = check_folder(arguments.folder, all, arguments.force); !checked) {
    return tl::unexpected(checked.error());
  }
  for (const auto& [name, text] : all) {
    if (auto checked = check_outputs({arguments.folder + "/" + name}, file->inputs); !checked) {
      return tl::unexpected(checked.error());
    }
  }
  const auto simulation = simulate(file->plan, arguments.threads);
  if (!simulation) {
    return tl::unexpected(simulation.error());
  }
  const auto truth = to_json(*file, *simulation);
  const auto scans = scan_files(*simulation);
  if (!scans) {
    return tl::unexpected(scans.error());
  }
  for (const FolderFiles& made : {made_files(*file, *simulation, copies->names, truth), *scans}) {
    files.insert(files.end(), made.begin(), made.end());
  }
  if (auto written = write_folder(arguments.folder, files, arguments.force); !written) {
    return tl::unexpected(written.error());
  }
  return arguments.common.tell(truth, summary(*file, *simulation, arguments));
}

// Sends the readings to standard output, as an arm would.
Expected<int> simulate_and_send(const SimulateArguments& arguments) {
  if (!arguments.folder.empty() || !arguments.common.json.empty()) {
    return wrong_usage("--stream writes events to standard output and nothing else; leave -o and --json out");
  }
  auto file = read_plan_file(arguments.plan, arguments.access.of(arguments.plan));
  if (!file) {
    return tl::unexpected(file.error());
  }
  file->plan.seed = arguments.seed.value_or(file->plan.seed);
  std::vector<PlantedMistake> mistakes;
  for (const std::string& text : arguments.mistakes) {
    auto mistake = parse_mistake(text, static_cast<int>(file->plan.nominal.joints.size()));
    if (!mistake) {
      return tl::unexpected(mistake.error());
    }
    mistakes.push_back(*mistake);
  }
  auto simulation = simulate(file->plan, arguments.threads);
  if (!simulation) {
    return tl::unexpected(simulation.error());
  }
  for (const PlantedMistake& mistake : mistakes) {
    if (auto planted = plant(mistake, file->plan, *simulation); !planted) {
      return tl::unexpected(planted.error());
    }
  }
  const double period = 1.0 / (arguments.rate > 0.0 ? arguments.rate : 1.0);
  return send_events(*simulation, mistakes, period,
                     [&](const std::string& lines) {
                       const bool sent = std::fwrite(lines.data(), 1, lines.size(), stdout) == lines.size() &&
                                         std::fflush(stdout) == 0;
                       if (arguments.rate > 0.0) {
                         std::this_thread::sleep_for(std::chrono::duration<double>(period));
                       }
                       return sent;
                     })
      .map([] { return 0; });
}

Expected<int> simulate_as_asked(const SimulateArguments& arguments) {
  if (arguments.stream) {
    return simulate_and_send(arguments);
  }
  if (arguments.folder.empty()) {
    return wrong_usage("--output is missing, expected -o FOLDER, or --stream for events on standard output");
  }
  if (!arguments.mistakes.empty() || arguments.rate > 0.0) {
    return wrong_usage("--mistake and --rate are of --stream, which is missing");
  }
  return simulate_and_write(arguments);
}

}  // namespace

Run set_up_simulate(CLI::App& parser) {
  auto arguments = std::make_shared<SimulateArguments>();
  parser.add_option("plan", arguments->plan, "plan.toml")->required()->type_name("PLAN");
  parser.add_option("-o,--output", arguments->folder, "folder to write: a recording, and the truth beside it")
      ->type_name("FOLDER");
  parser.add_flag("--force", arguments->force, "replace a folder that an earlier simulation has written");
  parser.add_option("--seed", arguments->seed, "instead of the plan's")->check(CLI::Range(0L, 9007199254740992L));
  parser
      .add_option("--threads", arguments->threads, "0: as many as the machine has; the readings are the same with any")
      ->check(CLI::Range(0, 256));
  parser.add_flag("--stream", arguments->stream,
                  "send the readings to standard output instead, as events of an arm for artcal record");
  parser.add_option("--rate", arguments->rate, "of --stream, readings a second; by default as fast as it goes")
      ->check(CLI::Range(0.001, 1e6))
      ->type_name("NUMBER");
  parser
      .add_option("--mistake", arguments->mistakes,
                  "of --stream: a mistake to plant; joints:2,3 or sign:3 or slip:4,30 (deg) or moved:12 (mm) or "
                  "wrong-feature")
      ->allow_extra_args(false)
      ->type_name("KIND");
  arguments->access.add_to(parser);
  arguments->common.add_to(parser);
  parser.footer(
      "Examples:\n  artcal simulate examples/simulate/plan.toml -o simulated\n"
      "  artcal simulate examples/simulate/plan.toml --stream --rate 2");
  return [arguments] {
    const auto done = simulate_as_asked(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
