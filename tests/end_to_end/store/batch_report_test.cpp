// The page of a batch that lists its recordings, and the page of each that it leads to.
#include <map>
#include <set>

#include <gmock/gmock.h>

#include "tests/end_to_end/archive.h"
#include "tests/end_to_end/browser.h"

namespace artcal {
namespace {

namespace fs = std::filesystem;
using testing::count_of;
using testing::Ended;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using testing::Opened;
using ::testing::SizeIs;
using Json = nlohmann::json;

// As a browser reads the path of a URL.
std::string decoded(const std::string& url) {
  std::string path;
  for (std::size_t i = 0; i < url.size(); ++i) {
    if (url[i] == '%') {
      path += static_cast<char>(std::stoi(url.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      path += url[i];
    }
  }
  return path;
}

class BatchReport : public testing::Browsing<testing::ArchiveTest> {
 protected:
  static std::vector<std::string> links_of(const std::string& page) {
    std::vector<std::string> links;
    const std::regex link("<a href=\"([^\"]*)\">");
    for (auto at = std::sregex_iterator(page.begin(), page.end(), link); at != std::sregex_iterator(); ++at) {
      links.push_back((*at)[1]);
    }
    return links;
  }
  // By name, what the folder holds.
  [[nodiscard]] std::map<std::string, std::string> pages_in(const std::string& folder) const {
    std::map<std::string, std::string> pages;
    for (const auto& entry : fs::directory_iterator(file(folder))) {
      if (entry.path().extension() == ".html") {
        pages[entry.path().filename()] = testing::read_all(entry.path());
      }
    }
    return pages;
  }
  [[nodiscard]] Json summary(std::vector<std::string> more) const {
    more.insert(more.end(), {"--json", "-"});
    return Json::parse(batch(more).out);
  }
};

TEST_F(BatchReport, EveryRowLeadsToItsReportWhateverItsName) {
  const std::vector<std::string> names{
      "<script>alert(1)<b>", "50% #1? \"a\" 'b' & c", "ünï ∞", "a\nb", "x/same", "y/same", "javascript:alert(2)"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    fs::create_directories(file("archive/" + names[i]).parent_path());
    file_away("gao2013", names[i], fmt::format("date = 2026-03-{:02}\n", i + 1));
  }
  file_away("gao2013", "broken", "");
  change("archive/broken/recording.toml", "\"deg\"", "\"<img src=x onerror=alert(3)>\"");
  const std::string index = "out #1 50%/night <b> %41.html";
  fs::create_directory(file("out #1 50%"));
  EXPECT_EQ(batch({"--store", "s", "-q", "--report", index}).exit_code, 3);
  const std::string page = text_of(index);
  const auto links = links_of(page);
  ASSERT_THAT(links, SizeIs(names.size()));
  EXPECT_EQ(std::set<std::string>(links.begin(), links.end()).size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string date = fmt::format("2026-03-{:02}", i + 1);
    const std::size_t row = page.find(">" + date + "<");
    const std::size_t link = page.rfind("<a href=\"", row) + 9;
    const std::string href = page.substr(link, page.find('"', link) - link);
    EXPECT_THAT(text_of("out #1 50%/" + decoded(href)), HasSubstr("<dd>" + date + "</dd>")) << href;
  }
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">broken/recording.toml</th>"));
  EXPECT_THAT(page, HasSubstr("&lt;img src=x onerror=alert(3)&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  // As a browser goes there: beside the page's own address.
  const std::string here = "file://" + file("").string() + "out%20%231%2050%25/";
  const Opened opened = open_url(here + "night%20%3Cb%3E%20%2541.html");
  EXPECT_THAT(opened.complaints, IsEmpty());
  EXPECT_THAT(opened.document, HasSubstr(links[0]));
  const Opened report = open_url(here + links[0]);
  EXPECT_THAT(report.complaints, IsEmpty());
  EXPECT_THAT(report.document, HasSubstr("data-drawn=\"all\""));
}

TEST_F(BatchReport, APageOfBothTasksHasBoth) {
  file_away("iso10360-12", "test", "");
  write("archive/test/recording.toml", text_of("archive/test/recording.toml") + "\n[identify]\n");
  const Ended ended = batch({"--store", "s", "-q", "--report", "index.html"});
  const auto pages = pages_in("index-reports");
  ASSERT_THAT(pages, SizeIs(1)) << ended.err;
  EXPECT_THAT(pages.begin()->second, HasSubstr("<h2>Identification: "));
  EXPECT_THAT(pages.begin()->second, HasSubstr("<h2>Verification: "));
  EXPECT_THAT(pages.begin()->second, Not(HasSubstr(file("archive").string()))) << "wherever it lies, the same page";
}

TEST_F(BatchReport, AResumedRunHasEveryPageAndMakesNoneTwice) {
  file_away_quick_ones(5);
  ASSERT_EQ(batch({"--store", "whole", "-q", "--report", "whole.html"}).exit_code, 0);
  ASSERT_EQ(batch({"--store", "s", "-q"}).exit_code, 0);
  const std::string before = dump("s");
  EXPECT_EQ(summary({"--store", "s", "--resume", "--report", "whole-too.html"})["reports"], 5) << "none were there";
  EXPECT_EQ(pages_in("whole-too-reports"), pages_in("whole-reports"));
  EXPECT_EQ(dump("s"), before);
  const Json again = summary({"--store", "s", "--resume", "--report", "whole-too.html"});
  EXPECT_EQ(again["known"], 5);
  EXPECT_EQ(again["reports"], 0);
  EXPECT_THAT(links_of(text_of("whole-too.html")), SizeIs(5));
  fs::remove(file("whole-too-reports") / pages_in("whole-reports").begin()->first);
  fs::rename(file("archive/quick-003"), file("archive/moved"));
  const Json mended = summary({"--store", "s", "--resume", "--report", "whole-too.html"});
  EXPECT_EQ(mended["known"], 3) << "one page was gone, one recording has another name";
  EXPECT_EQ(mended["reports"], 2);
  EXPECT_EQ(summary({"--store", "s", "--resume", "--report", "whole-too.html", "--report-pages", "none"})["known"], 5);
}

TEST_F(BatchReport, KilledAtAnyMomentARerunHasEveryPage) {
  file_away_quick_ones(30);
  const auto start_time = std::chrono::steady_clock::now();
  ASSERT_EQ(batch({"--store", "whole", "-q", "--report", "whole.html"}).exit_code, 0);
  const auto took = std::chrono::steady_clock::now() - start_time;
  const auto whole = pages_in("whole-reports");
  ASSERT_THAT(whole, SizeIs(30));
  int killed = 0;
  for (int i = 0; i < 8; ++i) {
    fs::remove_all(file("index-reports"));
    fs::remove(file("s"));
    fs::remove(file("s-journal"));
    const pid_t child = start({"batch", "archive", "--store", "s", "-q", "--report", "index.html"});
    std::this_thread::sleep_for(took * (i + 1) / 9);
    ::kill(child, SIGKILL);
    killed += wait_for(child).signal == SIGKILL;
    if (fs::exists(file("index-reports"))) {
      for (const auto& [name, page] : pages_in("index-reports")) {
        ASSERT_EQ(page, whole.at(name)) << "half a page";
      }
    }
    ASSERT_EQ(batch({"--store", "s", "--resume", "-q", "--report", "index.html"}).exit_code, 0);
    ASSERT_EQ(pages_in("index-reports"), whole) << "after kill " << i;
  }
  EXPECT_GT(killed, 2);
}

TEST_F(BatchReport, ManyPagesAtOnceLeaveTheUmaskAlone) {
  file_away_quick_ones(40);
  const Ended ended = run_command(
      {"sh", "-c", "umask 027; exec \"$0\" batch archive --store s -q --jobs 8 --report i.html", ARTCAL_PROGRAM});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  for (const auto& entry : fs::directory_iterator(file("i-reports"))) {
    EXPECT_EQ(entry.status().permissions(), fs::perms(0640)) << entry.path();
  }
}

TEST_F(BatchReport, TheListPrintsOnItsSide) {
  file_away_quick_ones(3);
  ASSERT_EQ(batch({"--store", "s", "-q", "--report", "i.html"}).exit_code, 0);
  EXPECT_THAT(print("i.html"), ::testing::ContainsRegex("Page size: +841\\.[0-9]+ x 59[45]"));
}

TEST_F(BatchReport, APageThatCannotBeWrittenStopsNothing) {
  file_away_quick_ones(4);
  ASSERT_EQ(batch({"--store", "s", "-q", "--report", "index.html"}).exit_code, 0);
  const std::string first = pages_in("index-reports").begin()->first;
  fs::remove_all(file("index-reports"));
  fs::create_directories(file("index-reports") / first);
  const Ended ended = batch({"--store", "t", "--report", "index.html"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.out, HasSubstr("reports not written"));
  EXPECT_THAT(ended.out, HasSubstr(first + ": this is a folder"));
  EXPECT_EQ(dump("t"), dump("s"));
  const std::string page = text_of("index.html");
  EXPECT_THAT(links_of(page), SizeIs(3));
  EXPECT_THAT(page, HasSubstr("no report: index-"));
  EXPECT_THAT(page, HasSubstr("this is a folder"));
  // A folder that is not there is not made: its name may be a mistake.
  EXPECT_EQ(batch({"--store", "v", "-q", "--report", "gone/index.html"}).exit_code, 3);
  EXPECT_FALSE(fs::exists(file("gone")));
  EXPECT_EQ(dump("v"), dump("s"));
  // A folder that cannot be made.
  write("other-reports", "");
  const Ended none = batch({"--store", "u", "-q", "--report", "other.html"});
  EXPECT_EQ(none.exit_code, 3);
  EXPECT_EQ(dump("u"), dump("s"));
  EXPECT_EQ(count_of(text_of("other.html"), "no report: other-reports: the folder of the reports cannot be made"), 4);
}

TEST_F(BatchReport, APageAloneSaysWhatItLacksAndASelfContainedOneLacksNothing) {
  file_away_quick_ones(2);
  ASSERT_EQ(batch({"--store", "s", "-q", "--report", "index.html"}).exit_code, 0);
  EXPECT_LT(pages_in("index-reports").begin()->second.size(), 100'000u);
  write("alone.html", pages_in("index-reports").begin()->second);
  const Opened alone = open("alone.html");
  EXPECT_THAT(alone.document, HasSubstr("This picture needs the file plots-"));
  ASSERT_EQ(batch({"--store", "s", "-q", "--report", "big.html", "--report-pages", "self-contained"}).exit_code, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(file("big-reports")), {}), 2) << "no plots beside them";
  write("alone.html", pages_in("big-reports").begin()->second);
  const Opened whole = open("alone.html");
  EXPECT_THAT(whole.complaints, IsEmpty());
  EXPECT_THAT(whole.document, HasSubstr("data-drawn=\"all\""));
  EXPECT_EQ(batch({"--store", "s", "--report-pages", "shared"}).exit_code, 2);
}

}  // namespace
}  // namespace artcal
