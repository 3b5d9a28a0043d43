// artcal: a table of commands. Exit codes: 0 done, 1 done and a verification failed, 2 wrong usage,
// 3 bad input, 4 no solution.
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>
#include <sstream>
#include <string_view>

#include <fmt/format.h>
#include <glog/logging.h>

#include "app/commands/command.h"
#include "app/output/phrases.h"
#include "app/store/where.h"
#include "app/version.h"
#include "core/text/decimal_comma.h"
#include "core/text/in_quotes.h"

namespace {

constexpr std::array commands{
    artcal::Command{"fit", "fit one feature to a file of points", artcal::set_up_fit},
    artcal::Command{"identify", "identify an arm's parameters from its readings on artefacts", artcal::set_up_identify},
    artcal::Command{"coupling", "identifiability analysis: which parameters readings determine",
                    artcal::set_up_coupling},
    artcal::Command{"segment", "find an artefact's spheres and planes in a scan", artcal::set_up_segment},
    artcal::Command{"uncertainty", "measurement uncertainty of an identified arm: points, lengths, volume",
                    artcal::set_up_uncertainty},
    artcal::Command{"verify", "verify an arm: ISO 10360-12, ASME B89.4.22, sphere plate", artcal::set_up_verify},
    artcal::Command{"points", "coordinates from joint angles", artcal::set_up_points},
    artcal::Command{"plan", "propose placements and postures of the next readings", artcal::set_up_plan},
    artcal::Command{"simulate", "a recording made by a virtual arm, with its true values", artcal::set_up_simulate},
    artcal::Command{"report", "report of results (HTML, prints on A4)", artcal::set_up_report},
    artcal::Command{"batch", "identify and verify many recordings, results into a store", artcal::set_up_batch},
    artcal::Command{"history", "changes of an arm over time; results that rest on a certificate",
                    artcal::set_up_history},
    artcal::Command{"store", "merge or print stores", artcal::set_up_store},
};

constexpr int wrong_usage = 2;
constexpr int bad_input = 3;

int not_all_said() {
  fmt::print(stderr, "artcal: standard output cannot be written\n");
  return bad_input;
}

// A full disk or a closed pipe shows only when the last of the output is flushed.
int said_all(int exit_code) {
  std::cout.flush();  // CLI11 tells its help there
  return std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0 ? exit_code : not_all_said();
}

// Of a word that is a number with a decimal comma, a line that asks about it.
std::string comma_remark(const char* word) {
  const std::string question = artcal::decimal_comma_question(word);
  return question.empty() ? question : fmt::format("{}{}\n", artcal::in_quotes(word), question);
}

int run(int argc, char** argv) {
  CLI::App parser{"artcal: artefact-based calibration of articulated-arm coordinate measuring machines", "artcal"};
  parser.set_version_flag("--version", fmt::format("artcal {}", artcal::program_version));
  parser.require_subcommand(1);
  parser.footer("`artcal COMMAND --help` says more, with an example.");
  std::array<artcal::Run, commands.size()> runs;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    runs[i] = commands[i].set_up(*parser.add_subcommand(commands[i].name, commands[i].summary));
  }
  const std::string_view first = argc > 1 ? argv[1] : "-";
  if (!first.starts_with('-') &&
      std::none_of(commands.begin(), commands.end(), [&](const auto& command) { return command.name == first; })) {
    fmt::print(stderr, "artcal: there is no command {}; artcal --help lists them\n", artcal::in_quotes(first));
    return wrong_usage;
  }
  try {
    parser.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    std::ostringstream said;
    const int exit_code = parser.exit(error, std::cout, said);
    for (int i = 1; exit_code != 0 && i < argc; ++i) {
      said << comma_remark(argv[i]);
    }
    std::cerr << artcal::without_passwords(said.str());
    return said_all(exit_code == 0 ? 0 : wrong_usage);
  }
  artcal::hide_passwords(argc, argv);
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (parser.got_subcommand(commands[i].name)) {
      return said_all(runs[i]());
    }
  }
  return wrong_usage;
}

}  // namespace

int main(int argc, char** argv) {
  // Beyond the largest file allowed (ulimit -f), writing is an error like any other, told and cleaned up after.
  ::signal(SIGXFSZ, SIG_IGN);
  // Ceres logs matrices where numbers break down; what a person needs to know of it is in the error's sentence.
  FLAGS_minloglevel = google::GLOG_FATAL;
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "artcal: there is not enough memory for this input\n");
  } catch (const std::exception& error) {
    if (std::ferror(stdout) != 0) {  // fmt throws where a long text cannot be written
      return not_all_said();
    }
    fmt::print(stderr, "artcal: {}\n", artcal::text_of_exception(error));
  }
  return bad_input;
}
