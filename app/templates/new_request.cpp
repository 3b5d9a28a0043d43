#include "app/templates/new_request.h"

#include <unistd.h>

#include <array>
#include <filesystem>
#include <iostream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/arm/arm_file.h"
#include "acquisition/recording/recording_file.h"
#include "app/output/output.h"
#include "app/templates/answers.h"
#include "artefacts/artefact/artefact_file.h"
#include "artefacts/simulation/plan/plan_file.h"

namespace artcal {
namespace {

namespace fs = std::filesystem;

struct NewKind {
  const char* name;
  const char* summary;
  const char* file;  // that is asked for on a terminal
  const char* next;  // what to do with it
};

constexpr std::array new_kinds{
    NewKind{"arm", "a nominal arm", "arm.toml", "Its numbers are an example: put those of your arm in their places."},
    NewKind{"artefact", "an artefact and its certified values", "artefact.toml",
            "Its values are made up: put those of the certificate in their places."},
    NewKind{"plan", "a plan of a simulation", "plan.toml", "artcal simulate makes a recording of it."},
    NewKind{"recording", "a recording that names arm, artefact and readings", "recording.toml",
            "artcal inspect looks for mistakes in it."}};

bool exists_already(const std::string& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

// What is named and not there, for a person who writes one file after the other.
std::string missing_text(const std::vector<std::string>& named) {
  std::vector<std::string> missing;
  for (const std::string& file : named) {
    if (!exists_already(file)) {
      missing.push_back(file);
    }
  }
  return missing.empty() ? "" : fmt::format("Not there yet: {}. ", fmt::join(missing, ", "));
}

template <typename T>
Expected<void> nothing(const Expected<T>& read) {
  return read ? Expected<void>{} : tl::unexpected(read.error());
}

// Whether the program reads what it wrote, as far as the files that it names are there.
Expected<void> read_back(std::string_view kind, const std::string& path, const std::vector<std::string>& named) {
  if (!missing_text(named).empty()) {
    return {};
  }
  return kind == "arm"        ? nothing(read_arm_file(path))
         : kind == "artefact" ? nothing(read_artefact_file(path))
         : kind == "plan"     ? nothing(read_plan_file(path))
                              : nothing(read_recording(path));
}

}  // namespace

void NewRequest::add_to(CLI::App& parser) {
  parser.require_subcommand(1);
  const std::array choices{arm_.choices(), artefact_.choices(), plan_.choices(), recording_.choices()};
  for (std::size_t i = 0; i < new_kinds.size(); ++i) {
    CLI::App* command = parser.add_subcommand(new_kinds[i].name, new_kinds[i].summary);
    add_choices(*command, choices[i]);
    command->add_option("-o,--output", output_, "file to write; printed where it is not given")->type_name("FILE.toml");
    command->add_flag("--quiet,-q", quiet_, "print nothing but errors");
    command->footer(fmt::format("Example:\n  artcal new {0} -o {1}", new_kinds[i].name, new_kinds[i].file));
    commands_.push_back(command);
  }
  parser.footer(
      "On a terminal and without options, questions are asked; an empty answer takes what stands in brackets.\n"
      "Examples:\n  artcal new arm --joints 6 -o arm.toml\n  artcal new artefact --type ball-bar -o artefact.toml\n"
      "  artcal new plan -o plan.toml\n  artcal new recording --readings monday.csv -o recording.toml");
}

Expected<int> NewRequest::run() {
  std::size_t chosen = 0;
  while (!commands_[chosen]->parsed()) {
    ++chosen;
  }
  const NewKind& kind = new_kinds[chosen];
  const std::array all{arm_.choices(), artefact_.choices(), plan_.choices(), recording_.choices()};
  const std::vector<Choice>& choices = all[chosen];
  const bool asks =
      ::isatty(STDIN_FILENO) == 1 && ::isatty(STDERR_FILENO) == 1 && !quiet_ && !any_given(*commands_[chosen], choices);
  if (asks) {
    std::vector<Choice> questions = choices;
    if (output_.empty()) {
      output_ = kind.file;
      questions.push_back({"--output", "FILE", "file to write", &output_, {}, is_path, "a path"});
    }
    if (auto answered = ask(questions, std::cin, std::cerr); !answered) {
      return tl::unexpected(answered.error());
    }
  }
  if (auto checked = check_choices(choices); !checked) {
    return tl::unexpected(checked.error());
  }
  const bool to_file = !output_.empty() && output_ != "-";
  if (to_file && exists_already(output_)) {
    return wrong_usage(fmt::format("{} is there already; give another file with -o", output_));
  }
  const std::string folder =
      to_file && fs::path(output_).has_parent_path() ? fs::path(output_).parent_path().string() : ".";
  const auto text = chosen == 0   ? Expected<std::string>(arm_.text())
                    : chosen == 1 ? artefact_.text()
                    : chosen == 2 ? Expected<std::string>(plan_.text(folder))
                                  : recording_.text(folder);
  if (!text) {
    return tl::unexpected(text.error());
  }
  if (!to_file) {
    fmt::print("{}", *text);
    return 0;
  }
  const std::vector<std::string> named = chosen == 2   ? std::vector<std::string>{plan_.arm, plan_.artefact}
                                         : chosen == 3 ? recording_.named_files()
                                                       : std::vector<std::string>{};
  if (auto done = write_file(output_, *text).and_then([&] { return read_back(kind.name, output_, named); }); !done) {
    return tl::unexpected(done.error());
  }
  if (!quiet_) {
    fmt::print("The {} is in {}. {}{}\n", kind.name, output_, missing_text(named), kind.next);
  }
  return 0;
}

}  // namespace artcal
