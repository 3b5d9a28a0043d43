// Reports as a reader meets them: in a browser and on paper.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "app/report/batch_index.h"
#include "tests/end_to_end/browser.h"

namespace artcal {
namespace {

using Json = nlohmann::json;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::Opened;
using ::testing::SizeIs;

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t found = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + what.size())) {
    ++found;
  }
  return found;
}

class Report : public testing::BrowserTest {
 protected:
  void identify(const std::string& example, const std::vector<std::string>& more = {}) const {
    take(example);
    std::vector<std::string> command{"identify", example + "/recording.toml", "--json", "result.json", "--quiet"};
    command.insert(command.end(), more.begin(), more.end());
    const Ended ended = run(command);
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
  }
  void report() const {
    const Ended ended = run({"report", "result.json", "-o", "report.html"});
    ASSERT_EQ(ended.exit_code, 0) << ended.err;
  }
};

TEST_F(Report, OfAnIdentificationOpensWithoutComplaintAndDrawsEveryFigure) {
  identify("ball-bar");
  report();
  EXPECT_LT(text_of("report.html").size(), 6u << 20);
  const Opened opened = open("report.html");
  EXPECT_THAT(opened.complaints, IsEmpty());
  EXPECT_THAT(opened.document, HasSubstr("data-drawn=\"all\""));
  EXPECT_GE(count(opened.document, "class=\"main-svg\""), 5u);
  EXPECT_EQ(count(opened.document, "<figcaption"), 5u);
  EXPECT_EQ(count(opened.document, "role=\"img\" aria-label=\""), 5u);
}

TEST_F(Report, DrawsNoFigureBeforeItComesIntoView) {
  identify("ball-bar");
  report();
  const Opened opened = open("report.html", {"--window-size=900,400"});
  EXPECT_THAT(opened.complaints, IsEmpty());
  EXPECT_THAT(opened.document, HasSubstr("data-drawn=\"in view\""));
  EXPECT_EQ(count(opened.document, "class=\"main-svg\""), 0u);
}

TEST_F(Report, WithoutWebGlIsDrawnFlat) {
  identify("two-socket-bar", {"--no-leave-out"});
  report();
  const Opened opened = open("report.html", {"--disable-3d-apis"});
  EXPECT_THAT(opened.complaints, IsEmpty());
  EXPECT_THAT(opened.document, HasSubstr("data-drawn=\"all\""));
  EXPECT_THAT(opened.document, HasSubstr(">x, mm; from the side</text>"));
}

TEST_F(Report, HasTheNumbersOfTheResult) {
  identify("ball-bar");
  report();
  const Json result = Json::parse(text_of("result.json"));
  const std::string page = text_of("report.html");
  const auto shows = [&](const Json& value, const char* format) {
    EXPECT_THAT(page, HasSubstr(fmt::format(fmt::runtime(format), value.get<double>())));
  };
  shows(result["before"]["overall"]["rms_mm"], ">{:.4f}<");
  shows(result["after"]["overall"]["rms_mm"], ">{:.4f}<");
  shows(result["after"]["overall"]["maximum_mm"], ">{:.4f}<");
  for (const Json& length : result["after"]["lengths"]) {
    shows(length["error_mm"], ">{:+.4f}<");
  }
  for (const Json& parameter : result["parameters"]) {
    if (parameter["unit"] == "mm") {
      shows(parameter["identified"], ">{:.5f}<");
    }
  }
  for (const Json& unidentifiable : result["coupling"]["unidentifiable"]) {
    EXPECT_THAT(page, HasSubstr(unidentifiable["text"].get<std::string>()));
  }
  for (const Json& input : result["inputs"]) {
    EXPECT_THAT(page, HasSubstr(input["sha256"].get<std::string>()));
  }
}

TEST_F(Report, PrintsOnA4) {
  identify("two-socket-bar");
  report();
  const std::string about = print("report.html");
  EXPECT_THAT(about, HasSubstr("(A4)"));
  std::smatch pages;
  ASSERT_TRUE(std::regex_search(about, pages, std::regex("Pages: +(\\d+)"))) << about;
  EXPECT_GE(std::stoi(pages[1]), 5);
  EXPECT_LE(std::stoi(pages[1]), 10);
  const std::string text = printed_text();
  EXPECT_THAT(text, HasSubstr("Identified, with reservations"));
  EXPECT_THAT(text, HasSubstr("lz + d7 is identifiable, d7 alone is not; d7 is fixed"));
  EXPECT_THAT(text, HasSubstr("1/" + pages[1].str()));
  EXPECT_THAT(text, HasSubstr("q7, °")) << "an axis of a figure that was never in view";
  EXPECT_THAT(run_command({"pdfimages", "-list", file("printed.pdf").string()}).out, HasSubstr("image"))
      << "what stands in space";
}

TEST_F(Report, OfHostileNamesShowsThemAsText) {
  take("ball-bar");
  const std::string evil = "</script><script>document.title='owned'</script><img src=x onerror=alert(1)>";
  for (const char* name : {"recording.toml", "arm.toml", "bar.toml"}) {
    const std::string path = std::string("ball-bar/") + name;
    const std::string text = text_of(path);
    write(path, std::regex_replace(text, std::regex("(^|\n)name = \"[^\"]*\""), "$1name = \"" + evil + "\"",
                                   std::regex_constants::format_first_only));
  }
  write("ball-bar/readings.csv",
        std::regex_replace(text_of("ball-bar/readings.csv"), std::regex("\n0,"), "\n<b>0</b>,"));
  const Ended ended = run({"identify", "ball-bar/recording.toml", "--json", "result.json", "--quiet"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  report();
  EXPECT_THAT(text_of("report.html"), Not(HasSubstr("<script>document.title")));
  const Opened opened = open("report.html");
  EXPECT_THAT(opened.complaints, IsEmpty());
  EXPECT_THAT(opened.document, Not(HasSubstr("<img src=\"x\"")));
  EXPECT_THAT(opened.document, Not(HasSubstr("<title>owned")));
  EXPECT_THAT(opened.document, HasSubstr("&lt;/script&gt;&lt;script&gt;document.title"));
  EXPECT_THAT(opened.document, HasSubstr(">&lt;b&gt;0&lt;/b&gt;</text>"));  // Plotly has markup of its own
}

TEST_F(Report, OfAVerificationShowsVerdictAndValues) {
  take("sphere-plate");
  const Ended ended = run({"verify", "sphere-plate/recording.toml", "--standard", "sphere-plate", "--json",
                           "result.json", "--report", "report.html", "--quiet"});
  EXPECT_EQ(ended.exit_code, 1) << ended.err;
  const std::string page = text_of("report.html");
  EXPECT_THAT(page, HasSubstr("Non-conformity proven"));
  EXPECT_THAT(page, HasSubstr("600 values, conformity proven of 566, non-conformity of 4, neither of 30."));
  EXPECT_EQ(count(page, "outlier</td>"), 2u);  // the ball that is 10 um off, in both placements
  for (const Json& value : Json::parse(text_of("result.json"))["values"]) {
    if (value["verdict"] == "does_not_conform") {
      EXPECT_THAT(page, HasSubstr(fmt::format(">{:+.1f}<", 1000.0 * value["value_mm"].get<double>())));
    }
  }
  const Opened opened = open("report.html");
  EXPECT_THAT(opened.complaints, IsEmpty());
  EXPECT_THAT(opened.document, HasSubstr("data-drawn=\"all\""));
  EXPECT_EQ(count(opened.document, "role=\"img\" aria-label=\""), 2u);
  EXPECT_THAT(opened.document, HasSubstr(">limit of E_Uni</text>"));
}

TEST_F(Report, OnAPhoneShowsEveryValueAndVerdictAndBreaksNoWord) {
  take("iso10360-12");
  ASSERT_EQ(run({"verify", "iso10360-12/recording.toml", "--standard", "iso10360-12", "--arm",
                 "iso10360-12/bumped-arm.toml", "--report", "report.html", "--quiet"})
                .exit_code,
            1);
  const Json answers = layout("report.html", ".answer", 390);
  EXPECT_GE(answers["shown"], 2 * (4 + 111)) << "value and verdict of each value, and of the worst of four quantities";
  EXPECT_EQ(answers["beyond"], 0);
  EXPECT_EQ(answers["wider"], false);
  for (const int width : {390, 900, 1200}) {
    const Json cells = layout("report.html", ".table td, .table tbody th", width);
    EXPECT_GT(cells["shown"], 500);
    // Known: on a telephone six long words of what is missing break, and at 1200 px the last columns of the table of
    // lengths are reached by scrolling it.
    EXPECT_LE(cells["broken"], width == 390 ? 6 : 0) << width;
    EXPECT_EQ(cells["beyond"], width == 900 ? 0 : cells["beyond"].get<int>()) << width;
  }
}

TEST_F(Report, NamesTheArmOnEveryPageOfPaper) {
  take("iso10360-12");
  ASSERT_LE(run({"verify", "iso10360-12/recording.toml", "--standard", "iso10360-12", "--report", "report.html", "-q"})
                .exit_code,
            1)
      << "shown or not, it is a page";
  std::smatch pages;
  const std::string about = print("report.html");
  ASSERT_TRUE(std::regex_search(about, pages, std::regex("Pages: +(\\d+)"))) << about;
  EXPECT_GE(count(printed_text(), "Calibration report: simulated arm after Gao 2013"), std::stoul(pages[1]));
}

TEST_F(Report, OfAMonteCarloIsWritten) {
  take("two-socket-bar");
  ASSERT_EQ(run({"uncertainty", "two-socket-bar/recording.toml", "--monte-carlo", "--trials", "20", "--json",
                 "result.json", "--quiet"})
                .exit_code,
            0);
  report();
  const Json result = Json::parse(text_of("result.json"));
  const std::string page = text_of("report.html");
  EXPECT_THAT(page, HasSubstr("Identified 20 times from readings and certificates drawn anew."));
  std::size_t parameters = 0;
  for (const Json& quantity : result["quantities"]) {
    parameters += quantity["kind"] == "parameter" ? 1 : 0;
    EXPECT_TRUE(quantity["kind"] != "parameter" ||
                page.find(">" + quantity["name"].get<std::string>() + "<") != std::string::npos)
        << quantity["name"];
  }
  EXPECT_GT(parameters, 20u);
  EXPECT_THAT(open("report.html").complaints, IsEmpty());
}

TEST_F(Report, IsTheSameFromTheProgramAndFromItsResult) {
  take("iso10360-12");
  ASSERT_EQ(run({"verify", "iso10360-12/recording.toml", "--standard", "iso10360-12", "--json", "result.json",
                 "--report", "at-once.html", "--quiet"})
                .exit_code,
            0);
  report();
  EXPECT_TRUE(text_of("at-once.html") == text_of("report.html"));
}

TEST_F(Report, OfSeveralResultsShowsTheMapAndWhatChanged) {
  identify("ball-bar", {"-o", "arm.toml", "--report", "at-once.html"});
  ASSERT_EQ(run({"uncertainty", "arm.toml", "--json", "map.json", "--quiet"}).exit_code, 0);
  ASSERT_EQ(run({"report", "result.json", "result.json", "map.json", "-o", "report.html"}).exit_code, 0);
  const Opened opened = open("report.html");
  EXPECT_THAT(opened.complaints, IsEmpty());
  EXPECT_THAT(opened.document, HasSubstr("data-drawn=\"all\""));
  EXPECT_THAT(opened.document, HasSubstr("Standard uncertainty of a point over the working volume"));
  EXPECT_THAT(opened.document, HasSubstr("Drift of the parameters"));
  EXPECT_THAT(opened.document, HasSubstr("are of the same recording"));
  // The page that identify itself writes has the map too.
  EXPECT_THAT(text_of("at-once.html"), HasSubstr("Standard uncertainty of a point over the working volume"));
}

TEST_F(Report, OfABatchIsSortedByAClick) {
  std::vector<IndexRow> rows(3);
  rows[0].recording = "ten", rows[0].rms_after = 10.0;
  rows[1].recording = "nine", rows[1].rms_after = 9.5;
  rows[2].recording = "none";
  const std::string page = index_html("Night", rows);
  write("index.html", page);
  EXPECT_THAT(open("index.html").complaints, IsEmpty());
  // The page's policy runs no script of ours: here it is taken out, and a click is put in.
  std::string clicked = std::regex_replace(page, std::regex("<meta http-equiv[^>]*>"), "");
  clicked.insert(clicked.find("</body>"), "<script>document.querySelectorAll('th button')[6].click()</script>");
  write("clicked.html", clicked);
  const std::string document = open("clicked.html").document;
  EXPECT_THAT(document, HasSubstr("aria-sort=\"ascending\""));
  EXPECT_LT(document.find(">nine<"), document.find(">ten<"));
  EXPECT_LT(document.find(">ten<"), document.find(">none<"));
}

TEST_F(Report, WithoutReadingsSaysSo) {
  identify("two-socket-bar", {"--no-residuals", "--no-leave-out"});
  report();
  EXPECT_THAT(text_of("report.html"), HasSubstr("its readings cannot be drawn"));
}

TEST_F(Report, RefusesWhatIsNoResult) {
  const auto refusal = [&](const std::string& text) {
    write("result.json", text);
    const Ended ended = run({"report", "result.json", "-o", "report.html"});
    EXPECT_EQ(ended.exit_code, 3);
    EXPECT_FALSE(std::filesystem::exists(file("report.html")));
    return ended.err;
  };
  EXPECT_THAT(refusal("<html>"), HasSubstr("result.json: this is no result of artcal"));
  EXPECT_THAT(refusal("[1, 2"), HasSubstr("no result of artcal"));
  EXPECT_THAT(refusal("{\"kind\": \"fit\", \"schema_version\": 1}"), HasSubstr("a result of kind \"fit\""));
  EXPECT_THAT(refusal("{\"kind\": \"identification\", \"schema_version\": 3}"), HasSubstr("schema_version"));
  EXPECT_THAT(refusal("{\"kind\": \"identification\", \"schema_version\": 1}"),
              HasSubstr("result.json: this result is not as --json wrote it: program is missing, expected an object"));
  EXPECT_THAT(refusal("{\"kind\": \"identification\", \"schema_version\": 1, \"arm\": 7, \"program\": {}}"),
              HasSubstr("arm is 7, expected a text"));
}

TEST_F(Report, NeverOverwritesTheResult) {
  identify("two-socket-bar", {"--no-leave-out"});
  EXPECT_EQ(run({"report", "result.json", "-o", "result.json"}).exit_code, 2);
}

}  // namespace
}  // namespace artcal
