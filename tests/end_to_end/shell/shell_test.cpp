// What the program says of its commands, walked from the list that it prints itself: a new command is in it.
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include "core/text/in_quotes.h"
#include "tests/end_to_end/program.h"

namespace artcal {
namespace {

using ::testing::AnyOf;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

using Words = std::vector<std::string>;

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

Words lines_of(const std::string& text) {
  Words lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

// The entries of a section of a help text: what stands in its first column.
Words entries(const std::string& help, const std::string& section) {
  Words found;
  bool inside = false;
  for (const std::string& line : lines_of(help)) {
    if (!line.starts_with(' ')) {
      inside = line == section + ":";
    } else if (inside && !line.starts_with("   ")) {
      const std::string entry = line.substr(2);
      found.push_back(entry.substr(0, entry.find("  ")));
    }
  }
  return found;
}

std::string long_name(const std::string& entry) {
  const std::size_t at = entry.find("--");
  return entry.substr(at, entry.find_first_of(" …", at) - at);
}

class Shell : public testing::ProgramTest {
 protected:
  /// The paths of all commands, such as {"store", "merge"}; the first is the program's own.
  [[nodiscard]] std::vector<Words> commands(const Words& path = {}) const {
    std::vector<Words> all{path};
    for (const std::string& name : entries(run(with(path, {"--help"})).out, "Commands")) {
      for (const Words& inside : commands(with(path, {name}))) {
        all.push_back(inside);
      }
    }
    return all;
  }

  void expect_own_words(const Ended& ended, const std::string& what) const {
    EXPECT_EQ(ended.exit_code, 2) << what << "\n" << ended.err;
    EXPECT_THAT(ended.out, IsEmpty()) << what;
    EXPECT_THAT(ended.err, StartsWith("artcal: ")) << what;
    EXPECT_EQ(lines_of(ended.err).size(), 1u) << ended.err;
    EXPECT_THAT(ended.err, HasSubstr("see artcal")) << what;
    for (const char* foreign : {"FAILED", "Could not", "not in range", "Run with", "is required", "following argument",
                                "Expected", "not understood"}) {
      EXPECT_THAT(ended.err, Not(HasSubstr(foreign))) << what;
    }
  }

  [[nodiscard]] Ended bash(const std::string& script) const {
    return run_command({"bash", "-c", script, ARTCAL_PROGRAM});
  }

  /// What bash offers for the last of the words.
  [[nodiscard]] std::string completed(const Words& words) const {
    std::string script = "source <(\"$0\" completion bash); COMP_WORDS=(artcal";
    for (const std::string& word : words) {
      script += " '" + word + "'";
    }
    return bash(script + fmt::format("); COMP_CWORD={}; _artcal; echo \"${{COMPREPLY[*]}}\"", words.size())).out;
  }
};

TEST_F(Shell, EveryHelpHasLinesOfAHundredColumns) {
  const auto all = commands();
  EXPECT_GE(all.size(), 17u);
  for (const Words& command : all) {
    const Ended help = run(with(command, {"--help"}));
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_EQ(run(with({"help"}, command)).out, help.out);
    for (const std::string& line : lines_of(help.out)) {
      EXPECT_LE(character_count(line), 100u) << line;
      for (const char* foreign : {"REQUIRED", " INT", " UINT", " FLOAT", ":{", "TEXT:", "[default", "default []"}) {
        EXPECT_THAT(line, Not(HasSubstr(foreign)));
      }
    }
  }
  EXPECT_THAT(run({"help", "plan"}).out, HasSubstr("(mean or worst; default worst)"));
  EXPECT_THAT(run({"help", "plan"}).out, HasSubstr("(1 to 1000; default 4)"));
}

TEST_F(Shell, WrongUsageIsSaidInItsOwnWordsByEveryCommand) {
  int numbers = 0;
  for (const Words& command : commands()) {
    const std::string help = run(with(command, {"--help"})).out;
    expect_own_words(run(with(command, {"--no-such-option-at-all"})), "an unknown option");
    for (const std::string& entry : entries(help, "Options")) {
      if (entry.find("--") == std::string::npos || !entry.ends_with(" N")) {
        continue;
      }
      const Ended ended = run(with(command, {long_name(entry), "lots"}));
      expect_own_words(ended, entry);
      EXPECT_THAT(ended.err, HasSubstr(long_name(entry) + " is \"lots\", expected ")) << ended.err;
      expect_own_words(run(with(command, {long_name(entry)})), entry);
      ++numbers;
    }
  }
  EXPECT_GT(numbers, 10);
}

TEST_F(Shell, WhatWasMeantIsNamed) {
  EXPECT_EQ(run({"identfy"}).err,
            "artcal: there is no command \"identfy\"; did you mean identify? See artcal --help\n");
  EXPECT_EQ(run({"store", "merg", "x"}).err,
            "artcal: there is no command \"merg\"; did you mean merge? See artcal store --help\n");
  EXPECT_EQ(run({"identify", "x", "--jsn", "y"}).err,
            "artcal: there is no option \"--jsn\"; did you mean --json? See artcal identify --help\n");
  EXPECT_THAT(run({"plan", "x", "--goal", "wurst"}).err,
              HasSubstr("--goal is \"wurst\", expected mean or worst; did you mean worst?"));
  EXPECT_THAT(run({"identify"}).err, HasSubstr("RECORDING is missing, expected artcal identify [OPTIONS] RECORDING;"));
  EXPECT_THAT(run({"identify", "a", "b"}).err, HasSubstr("\"b\" is one argument too many"));
  EXPECT_THAT(run({"identify", "a", "--json", "b", "--json", "c"}).err, HasSubstr("--json is given 2 times"));
  EXPECT_THAT(run({"identify", "a", "--max-memory", "5q"}).err, HasSubstr("--max-memory is \"5q\", expected SIZE: "));
  EXPECT_THAT(run({"uncertainty", "a", "--trials", "9"}).err, HasSubstr("only together with --monte-carlo"));
  EXPECT_THAT(run({"uncertainty", "a", "--monte-carlo", "--rings", "9"}).err, HasSubstr("exclude each other"));
}

TEST_F(Shell, APathThatTheCommandLineNamesIsNamedAsSuch) {
  EXPECT_THAT(run({"identify", "gone.toml"}).err,
              StartsWith("artcal: gone.toml: there is no such file, named on the command line as RECORDING; "));
  take("iso10360-12");
  EXPECT_THAT(run({"verify", "iso10360-12/recording.toml", "--arm", "gone.toml"}).err,
              HasSubstr("gone.toml: there is no such file, named on the command line as --arm; "));
  write("r.toml", "schema = \"artcal-recording/1\"\nname = \"r\"\narm = \"lost.toml\"\nreadings = \"q.csv\"\n");
  EXPECT_THAT(run({"identify", "r.toml"}).err, Not(HasSubstr("command line")));
}

TEST_F(Shell, EveryCommandHasAManualPageWithAllItsOptions) {
  for (const Words& command : commands()) {
    if (command.size() > 1) {
      continue;  // a section of its command's page
    }
    write("page.1", run(with({"help", "--man"}, command)).out);
    const Ended shown = run_command({"groff", "-man", "-ww", "-K", "utf8", "-T", "utf8", "-P", "-cbou", "page.1"});
    EXPECT_EQ(shown.exit_code, 0);
    EXPECT_THAT(shown.err, IsEmpty());
    EXPECT_THAT(shown.out, AnyOf(HasSubstr("OPTIONS"), HasSubstr("COMMANDS")));
    for (const std::string& entry : entries(run(with(command, {"--help"})).out, "Options")) {
      EXPECT_THAT(shown.out, HasSubstr(entry));
    }
  }
}

TEST_F(Shell, BashCompletesCommandsOptionsValuesAndFilesByKind) {
  for (const char* name : {"arm.toml", "notes.txt", "page.html", "sub/inside.toml"}) {
    write(name, "");
  }
  EXPECT_EQ(completed({"ident"}), "identify\n");
  EXPECT_EQ(completed({"store", "me"}), "merge\n");
  EXPECT_EQ(completed({"identify", "--js"}), "--json\n");
  EXPECT_EQ(completed({"verify", "--standard", "b8"}), "b89.4.22\n");
  EXPECT_EQ(completed({"identify", ""}), "sub arm.toml\n");
  EXPECT_EQ(completed({"identify", "--report", ""}), "sub page.html\n");
  EXPECT_EQ(completed({"simulate", "-o", ""}), "sub\n");
  EXPECT_EQ(completed({"identify", "--threads", ""}), "\n");
  // Every option of every command, in one shell.
  std::string script = "source <(\"$0\" completion bash)\n";
  Words wanted;
  for (const Words& command : commands()) {
    for (const std::string& entry : entries(run(with(command, {"--help"})).out, "Options")) {
      if (entry.find("--") != std::string::npos) {
        script += fmt::format("COMP_WORDS=(artcal {} {}); COMP_CWORD={}; _artcal; echo \"${{COMPREPLY[*]}}\"\n",
                              fmt::join(command, " "), long_name(entry), command.size() + 1);
        wanted.push_back(long_name(entry));
      }
    }
  }
  const Words offered = lines_of(bash(script).out);
  ASSERT_EQ(offered.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    EXPECT_THAT(offered[i], StartsWith(wanted[i]));
  }
}

TEST_F(Shell, ZshAndFishCompleteTheSame) {
  write("_artcal", run({"completion", "zsh"}).out);
  write("arm.toml", "");
  // An interactive zsh on a terminal of its own; -r -m waits for what is to appear.
  write("session.zsh",
        "zmodload zsh/zpty\n"
        "zpty z zsh -f -i\n"
        "zpty -w z 'PS1=; fpath=($PWD $fpath); autoload -Uz compinit; compinit -u -D; echo READY$((1))'\n"
        "zpty -r -m z out '*READY1*'\n"
        "zpty -w -n z $'artcal ident\\t'; zpty -r -m z out '*artcal identify*' && print command\n"
        "zpty -w -n z $'--repo\\t'; zpty -r -m z out '*--report*' && print option\n"
        "zpty -w -n z $'x.html ar\\t'; zpty -r -m z out '*m.toml*' && print file\n"
        "zpty -d z\n");
  const Ended zsh = run_command({"timeout", "60", "zsh", "-f", "session.zsh"});
  EXPECT_EQ(zsh.out, "command\noption\nfile\n") << zsh.err;
  write("artcal.fish", run({"completion", "fish"}).out);
  write("notes.txt", "");
  const auto fish = [&](const std::string& line) {
    return run_command({"fish", "--no-config", "-c", "source artcal.fish; complete -C '" + line + "'"});
  };
  EXPECT_THAT(fish("artcal ident").out, StartsWith("identify\tidentify an arm"));
  EXPECT_THAT(fish("artcal identify --js").out, StartsWith("--json\t"));
  EXPECT_THAT(fish("artcal verify --standard b").out, StartsWith("b89.4.22"));
  EXPECT_THAT(fish("artcal identify ").out, HasSubstr("arm.toml"));
  EXPECT_THAT(fish("artcal store ").out, HasSubstr("merge"));
}

}  // namespace
}  // namespace artcal
