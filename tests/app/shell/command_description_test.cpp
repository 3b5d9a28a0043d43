// Help, manual page and completion of a parser made for the test: what one states, the others state as well.
#include "app/shell/command_description.h"

#include <gmock/gmock.h>

#include "app/shell/completion.h"
#include "app/shell/help_text.h"
#include "app/shell/manual_page.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class Described : public ::testing::Test {
 protected:
  Described() {
    parser_.formatter(std::make_shared<HelpFormatter>());
    parser_.option_defaults()->always_capture_default();
    CLI::App* probe = parser_.add_subcommand("probe", "touch a ball");
    probe->add_option("recording", recording_, "what was read")->required()->type_name("RECORDING");
    probe->add_option("-o,--output", output_, "where to; .dots and back\\slashes")->type_name("FILE.html");
    probe->add_option("--times", times_, "how often")->check(CLI::Range(1, 9));
    probe->add_option("--side", side_, "which side")->check(CLI::IsMember({"in", "out"}));
    probe->add_flag("--quiet", quiet_, "say nothing");
    probe->footer("Prose of it.\nExample:\n  artcal probe x.toml");
  }
  [[nodiscard]] CommandDescription probe() const { return describe(parser_).commands.front(); }

  CLI::App parser_{"a program", "artcal"};
  std::string recording_, output_, side_ = "in";
  int times_ = 3;
  bool quiet_ = false;
};

TEST_F(Described, TheParserIsTheSource) {
  EXPECT_EQ(probe().usage(), "artcal probe [OPTIONS] RECORDING");
  const auto& options = probe().options;
  EXPECT_EQ(heading(options[1]), "-o, --output FILE.html");
  EXPECT_EQ(heading(options[2]), "--times N");
  EXPECT_EQ(options[2].full_text(), "how often (1 to 9; default 3)");
  EXPECT_EQ(options[2].rule.expected(), "a whole number from 1 to 9");
  EXPECT_EQ(options[3].full_text(), "which side (in or out; default in)");
  EXPECT_EQ(heading(options[4]), "--quiet");
}

TEST_F(Described, HelpStatesTheSame) {
  const std::string text = help_text(probe());
  EXPECT_THAT(text, HasSubstr("  --times N                 how often (1 to 9; default 3)\n"));
  EXPECT_THAT(text, HasSubstr("\nProse of it.\n\nExample:\n  artcal probe x.toml\n"));
  EXPECT_EQ(parser_.get_subcommand("probe")->help(), text);
}

TEST_F(Described, AManualPageEscapesWhatRoffObeys) {
  const std::string page = manual_page(probe(), "1.2.3");
  EXPECT_THAT(page, HasSubstr(".TH ARTCAL-PROBE 1 \"\" \"artcal 1.2.3\""));
  EXPECT_THAT(page, HasSubstr("where to; .dots and back\\eslashes"));
  EXPECT_THAT(page, HasSubstr(".B \\-o, \\-\\-output FILE.html"));
  EXPECT_THAT(page, HasSubstr(".SH DESCRIPTION\nProse of it.\n"));
  EXPECT_THAT(page, HasSubstr(".nf\nartcal probe x.toml\n.fi"));
}

TEST_F(Described, FilesCompleteByKind) {
  EXPECT_THAT(file_kind("RECORDING").endings, ElementsAre("toml"));
  EXPECT_THAT(file_kind("ARM|RECORDING").endings, ElementsAre("toml"));
  EXPECT_EQ(file_kind("FOLDER").kind, FileKind::Kind::Folders);
  EXPECT_EQ(file_kind("N").kind, FileKind::Kind::None);
  EXPECT_EQ(file_kind("NEW-KIND").kind, FileKind::Kind::Files);  // any file, until the table knows better
  EXPECT_THAT(file_kind("NEW-KIND").endings, ElementsAre());
  const std::string script = bash_completion(describe(parser_));
  EXPECT_THAT(script, HasSubstr("'artcal probe after --side '*) _artcal_words 'in out' ;;"));
  EXPECT_THAT(script, HasSubstr("'artcal probe after '*) _artcal_files toml ;;"));
  EXPECT_THAT(script, Not(HasSubstr("after --quiet ")));
}

TEST(Paragraph, LinesCountCharactersNotBytes) {
  const std::string line(40, 'x');
  CLI::App parser{line + " ………………………………………………………………………………………………………… " + line + " " + line, "artcal"};
  std::istringstream lines(help_text(describe(parser)));
  std::string first;
  std::getline(lines, first);
  EXPECT_EQ(first, line + " …………………………………………………………………………………………………………");
}

}  // namespace
}  // namespace artcal
