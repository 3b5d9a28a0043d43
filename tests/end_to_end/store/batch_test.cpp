// artcal batch on whole archives: what is broken, killed, run twice, at once, and in parts.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/archive.h"
#include "tests/end_to_end/store/sqlite_rows.h"

namespace artcal {
namespace {

using testing::count_of;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using Json = nlohmann::json;

class Batch : public testing::ArchiveTest {
 protected:
  // Ten recordings that are broken in ten ways, and the words that name each.
  std::vector<std::pair<std::string, std::string>> file_away_broken_ones() const {
    for (int i = 0; i < 10; ++i) {
      file_away("gao2013", fmt::format("broken-{}", i), "");
    }
    const auto in = [](int i, const std::string& name) { return fmt::format("archive/broken-{}/{}", i, name); };
    write(in(0, "recording.toml"), "");
    write(in(1, "recording.toml"), "schema = \"artcal-recording/1\nname");
    change(in(2, "recording.toml"), "arm = \"table1.toml\"", "arm = \"gone.toml\"");
    change(in(3, "recording.toml"), "joint = \"deg\"", "joint = \"grad\"");
    change(in(4, "recording.toml"), "[\"readings.csv\"]", "[\"readings.csv\"]\ncomment = 1");
    write(in(5, "readings.csv"), text_of(in(5, "readings.csv")).substr(0, 700));
    write(in(6, "readings.csv"), std::string("\x7f"
                                             "ELF\0\1\2",
                                             7));
    write(in(7, "table1.toml"), text_of(in(7, "table1.toml")) + "\n[[joint]]\na = 1\n");
    change(in(8, "recording.toml"), "units", "[verify]\nstandard = \"iso10360-2\"\n[units]\n# ");
    std::filesystem::remove(file(in(9, "coordinates.toml")));
    return {{"broken-0", "empty"},          {"broken-1", "recording.toml:1"},
            {"broken-2", "gone.toml"},      {"broken-3", "grad"},
            {"broken-4", "comment"},        {"broken-5", "readings.csv"},
            {"broken-6", "readings.csv"},   {"broken-7", "table1.toml"},
            {"broken-8", "recording.toml"}, {"broken-9", "coordinates.toml"}};
  }
};

TEST_F(Batch, TwoHundredRecordingsOfWhichTenAreBroken) {
  file_away_quick_ones(184);
  file_away("two-socket-bar", "robot", "");
  file_away("ball-bar", "bar", "");
  file_away("sphere-plate", "plate", "");
  for (int i = 0; i < 2; ++i) {
    file_away("iso10360-12", fmt::format("test-{}", i), fmt::format("date = 2026-05-0{}\n", i + 1));
  }
  file_away("iso10360-12", "test-bumped", "");
  change("archive/test-bumped/recording.toml", "arm = \"arm.toml\"", "arm = \"bumped-arm.toml\"");
  const auto broken = file_away_broken_ones();
  const Ended ended = batch({"--store", "results.sqlite", "--json", "summary.json", "--report", "index.html"});
  EXPECT_EQ(ended.exit_code, 3);
  const std::string page = text_of("index.html");
  EXPECT_EQ(count_of(page, "/recording.toml"), 200);
  EXPECT_EQ(count_of(page, "<a href=\"index-reports/"), 190);
  const Json summary = Json::parse(text_of("summary.json"));
  EXPECT_EQ(summary["files"], 200);
  EXPECT_EQ(summary["identified"], 186);
  EXPECT_EQ(summary["verified"], 4);
  EXPECT_EQ(summary["not_shown"], 2);
  EXPECT_EQ(summary["failed"], 10);
  EXPECT_EQ(summary["reports"], 190);
  for (std::size_t i = 0; i < broken.size(); ++i) {
    EXPECT_THAT(summary["failures"][i]["path"].get<std::string>(), HasSubstr(broken[i].first));
    EXPECT_THAT(summary["failures"][i]["error"].get<std::string>(), HasSubstr(broken[i].second));
    EXPECT_EQ(summary["failures"][i]["exit_code"], 3);
    EXPECT_THAT(ended.out, HasSubstr(broken[i].first));
  }
  const std::string rows = dump("results.sqlite");
  EXPECT_EQ(count_of(rows, "[\"files\","), 200);
  EXPECT_EQ(count_of(rows, "[\"recordings\","), 190);
  EXPECT_EQ(count_of(rows, "[\"identifications\","), 186);
  EXPECT_EQ(count_of(rows, "\"conformity_shown\"]"), 2);
  EXPECT_EQ(count_of(rows, "\"non_conformity_shown\"]"), 2);
  // Table 4 of the paper, to 1e-8 mm on either side: a3 of the 184.
  const std::string a3 = ",\"a3\",\"mm\",\"identified\",0.0,";
  EXPECT_EQ(count_of(rows, a3 + "-0.11999999") + count_of(rows, a3 + "-0.12000000"), 184);
}

TEST_F(Batch, ResumeComputesWhatIsNewAndNothingTwice) {
  file_away_quick_ones(6);
  (void)file_away_broken_ones();
  ASSERT_EQ(batch({"--store", "s.sqlite", "--quiet"}).exit_code, 3);
  const std::string first = dump("s.sqlite");
  const auto summary = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--store", "s.sqlite", "--resume", "--json", "-"});
    return Json::parse(batch(more).out);
  };
  EXPECT_EQ(summary({})["known"], 6);
  EXPECT_EQ(dump("s.sqlite"), first);
  // Moved: known by content, computed no more; the broken ones are looked at again.
  std::filesystem::rename(file("archive/quick-001"), file("archive/moved"));
  const Json moved = summary({});
  EXPECT_EQ(moved["known"], 6);
  EXPECT_EQ(moved["identified"], 0);
  // Mended, and one whose arm changed.
  write("archive/broken-2/recording.toml", text_of("archive/quick-002/recording.toml"));
  std::filesystem::rename(file("archive/broken-2/table1.toml"), file("archive/broken-2/spare.toml"));
  std::filesystem::copy(file("archive/quick-002/table1.toml"), file("archive/broken-2/table1.toml"));
  change("archive/quick-003/table1.toml", "300", "300.5");
  const Json mended = summary({});
  EXPECT_EQ(mended["known"], 6) << "broken-2 now has the content of quick-002";
  EXPECT_EQ(mended["identified"], 1);
  EXPECT_EQ(mended["failed"], 9);
  // Other options are other results.
  EXPECT_EQ(summary({"--leave-out"})["identified"], 7);
}

TEST_F(Batch, TheStoreDoesNotDependOnTheNumberOfJobs) {
  file_away_quick_ones(20);
  file_away("iso10360-12", "test", "");
  (void)file_away_broken_ones();
  ASSERT_EQ(batch({"--store", "one.sqlite", "--jobs", "1", "-q"}).exit_code, 3);
  ASSERT_EQ(batch({"--store", "many.sqlite", "--jobs", "7", "-q"}).exit_code, 3);
  const std::string one = dump("one.sqlite");
  EXPECT_EQ(one, dump("many.sqlite"));
  ASSERT_EQ(batch({"--store", "many.sqlite", "-q"}).exit_code, 3) << "all again";
  EXPECT_EQ(one, dump("many.sqlite"));
}

TEST_F(Batch, ShardsMergeToTheSame) {
  file_away_quick_ones(20);
  (void)file_away_broken_ones();
  (void)batch({"--store", "all.sqlite", "-q"});
  std::vector<std::string> merge{"store", "merge", "merged.sqlite"};
  for (int i = 1; i <= 3; ++i) {
    const std::string store = fmt::format("shard-{}.sqlite", i);
    (void)batch({"--store", store, "--shard", fmt::format("{}/3", i), "-q"});
    merge.push_back(store);
  }
  EXPECT_EQ(run(merge).exit_code, 0);
  EXPECT_EQ(dump("merged.sqlite"), dump("all.sqlite"));
  EXPECT_EQ(run(merge).exit_code, 0);
  EXPECT_EQ(dump("merged.sqlite"), dump("all.sqlite"));
}

TEST_F(Batch, KilledAtAnyMomentARerunEndsTheSame) {
  file_away_quick_ones(30);
  (void)file_away_broken_ones();
  const auto before = std::chrono::steady_clock::now();
  (void)batch({"--store", "undisturbed.sqlite", "-q"});
  const auto whole = std::chrono::steady_clock::now() - before;
  const std::string undisturbed = dump("undisturbed.sqlite");
  const char* wanted = std::getenv("ARTCAL_TEST_KILLS");
  const int kills = wanted != nullptr ? std::atoi(wanted) : 20;
  int killed = 0;
  for (int i = 0; i < kills; ++i) {
    for (const char* name : {"s.sqlite", "s.sqlite-journal"}) {
      std::filesystem::remove(file(name));
    }
    const pid_t child = start({"batch", "archive", "--store", "s.sqlite", "-q"});
    std::this_thread::sleep_for(whole * (i + 1) / (kills + 1));
    ::kill(child, SIGKILL);
    killed += wait_for(child).signal == SIGKILL;
    ASSERT_EQ(run({"batch", "archive", "--store", "s.sqlite", "--resume", "-q"}).exit_code, 3);
    ASSERT_EQ(dump("s.sqlite"), undisturbed) << "after kill " << i;
  }
  EXPECT_GT(killed, kills / 4);
}

TEST_F(Batch, TwoBatchesOnOneStoreAtOnce) {
  file_away_quick_ones(60);
  (void)batch({"--store", "one.sqlite", "-q"});
  const pid_t first = start({"batch", "archive", "--store", "both.sqlite", "-q"});
  const pid_t second = start({"batch", "archive", "--store", "both.sqlite", "-q"});
  EXPECT_EQ(wait_for(first).exit_code, 0);
  EXPECT_EQ(wait_for(second).exit_code, 0);
  EXPECT_EQ(dump("both.sqlite"), dump("one.sqlite"));
}

TEST_F(Batch, AFullDiskLosesNothingThatWasWritten) {
  file_away_quick_ones(100);
  const Ended full = wait_for(start({"batch", "archive", "--store", "s.sqlite", "-q"}, 300000));
  EXPECT_EQ(full.exit_code, 3);
  EXPECT_THAT(full.err, HasSubstr("s.sqlite: the store cannot be written"));
  EXPECT_EQ(count_of(full.err, "\n"), 1) << full.err;
  const int kept = count_of(dump("s.sqlite"), "[\"files\",");
  EXPECT_LT(kept, 100);
  EXPECT_EQ(batch({"--store", "s.sqlite", "--resume", "-q"}).exit_code, 0);
  (void)batch({"--store", "all.sqlite", "-q"});
  EXPECT_EQ(dump("s.sqlite"), dump("all.sqlite"));
}

TEST_F(Batch, WhatIsNoStoreIsRefused) {
  file_away_quick_ones(1);
  write("text.sqlite", std::string(5000, 'x'));
  EXPECT_THAT(batch({"--store", "text.sqlite"}).err, HasSubstr("text.sqlite: the store cannot be opened"));
  EXPECT_EQ(text_of("text.sqlite"), std::string(5000, 'x'));
  EXPECT_THAT(batch({"--store", "archive/quick-000/readings.csv/s"}).err, HasSubstr("cannot be opened"));
  const Ended input = batch({"--store", "archive/quick-000/recording.toml"});
  EXPECT_EQ(input.exit_code, 2);
  EXPECT_THAT(input.err, HasSubstr("would be overwritten"));
  EXPECT_EQ(batch({"--store", "mysql://here"}).exit_code, 2);
  EXPECT_EQ(run({"store", "dump", "gone.sqlite"}).exit_code, 3);
  EXPECT_THAT(names(), ::testing::ElementsAre("archive", "text.sqlite"));
}

TEST_F(Batch, ListsPatternsAndSingleFiles) {
  file_away_quick_ones(5);
  std::filesystem::rename(file("archive/quick-000/recording.toml"), file("archive/quick-000/monday.toml"));
  const auto files = [&](const std::vector<std::string>& paths) {
    std::vector<std::string> call{"batch", "--store", "s.sqlite", "--json", "-"};
    call.insert(call.end(), paths.begin(), paths.end());
    const Ended ended = run(call);
    return ended.out.empty() ? -ended.exit_code : Json::parse(ended.out)["files"].get<int>();
  };
  EXPECT_EQ(files({"archive"}), 5) << "monday.toml says what it is";
  EXPECT_EQ(files({"archive/quick-00[1-3]"}), 3);
  EXPECT_EQ(files({"archive/*/recording.toml", "archive", "./archive/../archive/quick-001/recording.toml"}), 5);
  EXPECT_EQ(files({"archive/quick-001/recording.toml", "archive/gone.toml"}), 2);
  EXPECT_EQ(files({"archive/none-*"}), -3);
  std::filesystem::create_directory(file("nothing"));
  EXPECT_EQ(files({"nothing"}), -3);
}

TEST_F(Batch, WrongCallsAreRefused) {
  file_away_quick_ones(1);
  for (const char* shard : {"0/3", "4/3", "1", "a/b", "1/0", "1/3x"}) {
    EXPECT_EQ(batch({"--store", "s.sqlite", "--shard", shard}).exit_code, 2) << shard;
  }
  EXPECT_EQ(batch({}).exit_code, 2);
  EXPECT_EQ(batch({"--store", ""}).exit_code, 2);
  EXPECT_EQ(run({"store"}).exit_code, 2);
}

TEST_F(Batch, CountsAddUp) {
  file_away_quick_ones(3);
  file_away("iso10360-12", "test", "");
  file_away("gao2013", "broken", "");
  write("archive/broken/recording.toml", "");
  const auto expect_sum = [](const Json& json) {
    EXPECT_EQ(
        json["done"].get<int>() + json["known"].get<int>() + json["failed"].get<int>() + json["not_reached"].get<int>(),
        json["files"].get<int>())
        << json.dump();
  };
  const Ended first = batch({"--store", "s", "--json", "first.json"});
  const Json fresh = Json::parse(text_of("first.json"));
  expect_sum(fresh);
  EXPECT_EQ(fresh["done"], 4);
  EXPECT_THAT(first.out, HasSubstr("done now  4\n"));
  file_away("gao2013", "another", "date = 2027-01-01\n");
  (void)batch({"--store", "s", "--resume", "--json", "second.json"});
  const Json again = Json::parse(text_of("second.json"));
  expect_sum(again);
  EXPECT_EQ(again["known"], 4);
  EXPECT_EQ(again["done"], 1);
  EXPECT_EQ(again["failed"], 1);
}

TEST_F(Batch, CtrlCKeepsWhatIsDoneAndSaysHowToGoOn) {
  for (int i = 0; i < 30; ++i) {
    file_away("ball-bar", fmt::format("bar-{:02}", i), fmt::format("date = 2026-01-{:02}\n", i + 1));
  }
  const std::vector<std::string> command{"batch", "archive", "--store", "s", "--jobs", "1", "--resume"};
  const pid_t child = start(command);
  // In the middle, however fast the machine is: its first result is stored.
  for (int i = 0; i < 2000 && testing::sqlite_rows(file("s"), "SELECT * FROM identifications") < 1; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ::kill(child, SIGINT);
  const Ended ended = wait_for(child);
  ASSERT_EQ(ended.exit_code, 130) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("artcal: interrupted after "));
  EXPECT_THAT(ended.err, HasSubstr("of 30 recordings; their results are in s. The same command with --resume goes on"));
  EXPECT_THAT(ended.out, HasSubstr("not reached"));
  EXPECT_EQ(run(command).exit_code, 0);
  EXPECT_EQ(run({"batch", "archive", "--store", "fresh"}).exit_code, 0);
  EXPECT_EQ(dump("s"), dump("fresh")) << "as if it had not been interrupted";
}

TEST_F(Batch, PrunedPathsAreListedFirst) {
  file_away_quick_ones(3);
  ASSERT_EQ(batch({"--store", "s.sqlite"}).exit_code, 0);
  std::filesystem::remove_all(file("archive/quick-000"));
  EXPECT_EQ(run({"store", "prune", "s.sqlite"}).exit_code, 0);
  ASSERT_EQ(batch({"--store", "s.sqlite", "--resume"}).exit_code, 0);
  std::filesystem::remove_all(file("archive/quick-001"));
  std::filesystem::rename(file("archive/quick-002"), file("archive/moved"));
  const std::string before = dump("s.sqlite");
  const Ended dry = run({"store", "prune", "s.sqlite", "--dry-run"});
  EXPECT_EQ(dry.exit_code, 0) << dry.err;
  EXPECT_THAT(dry.out, HasSubstr("2 paths of s.sqlite at which no file is any more would be removed:"));
  EXPECT_THAT(dry.out, HasSubstr("archive/quick-001/recording.toml"));
  EXPECT_EQ(dump("s.sqlite"), before);
  const Ended pruned = run({"store", "prune", "s.sqlite"});
  EXPECT_THAT(pruned.out, HasSubstr("2 paths of s.sqlite at which no file is any more were removed"));
  EXPECT_THAT(dump("s.sqlite"), Not(HasSubstr("quick-001/recording.toml")));
  EXPECT_EQ(count_of(dump("s.sqlite"), "[\"recordings\""), 3) << "the results stay";
  EXPECT_THAT(run({"store", "prune", "s.sqlite"}).out, HasSubstr("0 paths"));
  EXPECT_EQ(run({"store", "prune", "gone.sqlite", "--dry-run"}).exit_code, 3);
}

}  // namespace
}  // namespace artcal
