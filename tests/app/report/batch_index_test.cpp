#include "app/report/batch_index.h"

#include <gmock/gmock.h>

namespace artcal {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

IndexRow row(const std::string& recording, IndexOutcome outcome) {
  IndexRow made;
  made.recording = recording;
  made.outcome = outcome;
  return made;
}

TEST(BatchIndex, WhatFailedComesFirst) {
  const std::string page = index_html("Night", {row("good", IndexOutcome::Done), row("bad", IndexOutcome::Failed),
                                                row("unclear", IndexOutcome::NotShown)});
  EXPECT_LT(page.find(">bad<"), page.find(">unclear<"));
  EXPECT_LT(page.find(">unclear<"), page.find(">good<"));
  EXPECT_THAT(page, HasSubstr("3 recordings: 1 done, 1 with conformity not shown, 1 failed."));
}

TEST(BatchIndex, LinksLeadToFilesAndNowhereElse) {
  IndexRow hostile = row("a", IndexOutcome::Done);
  hostile.report = "javascript:alert(1)";
  IndexRow odd = row("b", IndexOutcome::Done);
  odd.report = "reports/50% \"off\"#1?.html";
  const std::string page = index_html("Night", {hostile, odd});
  EXPECT_THAT(page, HasSubstr("href=\"./javascript%3Aalert%281%29\""));
  EXPECT_THAT(page, HasSubstr("href=\"reports/50%25%20%22off%22%231%3F.html\""));
}

TEST(BatchIndex, TheFolderOfAllIsSaidOnce) {
  const std::string page = index_html("Night", {row("/data/<a>/arms/17/recording.toml", IndexOutcome::Done),
                                                row("/data/<a>/arms/1/x", IndexOutcome::Done)});
  EXPECT_THAT(page, HasSubstr("Recordings in /data/&lt;a&gt;/arms/<"));
  EXPECT_THAT(page, HasSubstr(">17/recording.toml<"));
  EXPECT_THAT(page, HasSubstr(">1/x<"));
  EXPECT_THAT(index_html("Night", {row("/data/one/recording.toml", IndexOutcome::Done)}),
              HasSubstr(">recording.toml<"));
}

TEST(BatchIndex, NamesStayText) {
  IndexRow hostile = row("<script>alert(1)</script>", IndexOutcome::Failed);
  hostile.arm = hostile.date = hostile.task = hostile.message = "\"><img src=x onerror=alert(2)>";
  const std::string page = index_html("<script>alert(3)</script>", {hostile, row("other", IndexOutcome::Done)});
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(page, Not(HasSubstr("<img")));
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(1)&lt;/script&gt;"));
}

TEST(BatchIndex, IsSmallAndHasNoPlots) { EXPECT_LT(index_html("Night", std::vector<IndexRow>(100)).size(), 60'000u); }

}  // namespace
}  // namespace artcal
