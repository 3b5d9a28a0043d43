#include "app/batch/report_pages.h"

#include <gmock/gmock.h>

namespace artcal {
namespace {

using ::testing::MatchesRegex;

std::string link(const std::string& path, const std::string& recording = "0123", const std::string& index = "a/n.html",
                 ReportPages::Kind kind = ReportPages::Kind::Shared) {
  return ReportPages(index, kind).link(path, recording);
}

TEST(ReportPages, AreNamedAfterTheFolderOrTheFile) {
  EXPECT_THAT(link("/archive/arm 17/recording.toml"), MatchesRegex("n-reports/arm-17-[0-9a-f]{16}\\.html"));
  EXPECT_THAT(link("/archive/monday.toml"), MatchesRegex("n-reports/monday-[0-9a-f]{16}\\.html"));
  EXPECT_THAT(link("/recording.toml"), MatchesRegex("n-reports/recording-[0-9a-f]{16}\\.html"));
}

TEST(ReportPages, NothingOfAHostileNameIsLeft) {
  EXPECT_THAT(link("/a/<script>\"#%3f?\n..\\&'\xc3\xa4\xff/recording.toml"),
              MatchesRegex("n-reports/script-3f-\\.\\.--[0-9a-f]{16}\\.html"));
  EXPECT_THAT(link("/a/../recording.toml"), MatchesRegex("n-reports/recording-[0-9a-f]{16}\\.html"));
  EXPECT_LT(link("/a/" + std::string(255, 'x') + "/recording.toml").size(), 100u);
}

TEST(ReportPages, TellResultsAndKindsApart) {
  EXPECT_EQ(link("/a/x/recording.toml", "0123"), link("/b/x/recording.toml", "0123")) << "the same result";
  EXPECT_NE(link("/a/x/recording.toml", "0123"), link("/b/x/recording.toml", "0124"));
  EXPECT_NE(link("/a/x/recording.toml"),
            link("/a/x/recording.toml", "0123", "a/n.html", ReportPages::Kind::SelfContained));
}

TEST(ReportPages, LieBesideTheIndex) {
  EXPECT_EQ(ReportPages("index.html", ReportPages::Kind::Shared).folder(), "index-reports");
  EXPECT_EQ(ReportPages("out/night", ReportPages::Kind::Shared).folder(), "out/night-reports");
  EXPECT_EQ(ReportPages("/v1.2/a.b.html", ReportPages::Kind::Shared).folder(), "/v1.2/a.b-reports");
}

}  // namespace
}  // namespace artcal
