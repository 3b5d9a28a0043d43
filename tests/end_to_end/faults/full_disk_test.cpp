// Disks that are really full, and disks that can only be read: small ones in memory, mounted where no other process
// sees them (a mount namespace), gone when the script ends.
#include <sqlite3.h>

#include <gmock/gmock.h>

#include "tests/end_to_end/archive.h"

namespace artcal {
namespace {

using testing::count_of;
using testing::Ended;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class FullDisk : public testing::ArchiveTest {
 protected:
  void SetUp() override {
    std::filesystem::create_directory(file("disk"));
    const Ended ended =
        on_disk("4m", "touch disk/x && mount -o remount,size=8m disk && mount -o remount,ro disk && ! touch disk/y");
    if (ended.exit_code != 0) {
      GTEST_SKIP() << "NO DISK COULD BE MOUNTED HERE, nothing was tested on a full one: " << ended.err;
    }
  }
  // Runs a script of the shell with a disk of that size at disk/; artcal is the program. What it says of exit codes
  // with `code` is in the order of the calls.
  [[nodiscard]] Ended on_disk(const std::string& size, const std::string& script) const {
    const std::string beginning = "code() { \"$@\"; echo \"code $?\"; }\nartcal() { \"$0\" \"$@\"; }\n";
    return run_command({"unshare", "--map-root-user", "--mount", "sh", "-c",
                        beginning + "mount -t tmpfs -o size=" + size + " small disk && {\n" + script + "\n}",
                        ARTCAL_PROGRAM});
  }
};

TEST_F(FullDisk, AStoreKeepsWhatWasWrittenAndGoesOnWhenThereIsRoom) {
  file_away_quick_ones(150);
  ASSERT_EQ(batch({"--store", "whole.sqlite", "-q"}).exit_code, 0);
  // The second has room for the first 64 or 128 of the results.
  for (const char* size : {"4k", "420k", "700k"}) {
    std::filesystem::remove(file("grown.sqlite"));
    const Ended ended = on_disk(size,
                                "code artcal batch archive --store disk/s.sqlite -q\n"
                                "ls disk >listed; artcal store dump disk/s.sqlite >kept.dump 2>/dev/null\n"
                                "mount -o remount,size=64m disk\n"
                                "code artcal batch archive --store disk/s.sqlite --resume -q\n"
                                "cp disk/s.sqlite grown.sqlite");
    EXPECT_EQ(ended.out, "code 3\ncode 0\n") << size;
    EXPECT_EQ(ended.err, "artcal: disk/s.sqlite: the store cannot be written: the disk is full\n");
    EXPECT_EQ(text_of("listed"), "s.sqlite\n") << "nothing is left beside it";
    EXPECT_LT(count_of(text_of("kept.dump"), "[\"files\","), 150);
    EXPECT_EQ(count_of(text_of("kept.dump"), "[\"files\",") % 64, 0) << "whole transactions";
    EXPECT_EQ(dump("grown.sqlite"), dump("whole.sqlite"));
  }
}

TEST_F(FullDisk, WhatAKilledRunLeftIsUndoneWhereItCanBe) {
  file_away_quick_ones(60);
  ASSERT_EQ(batch({"--store", "s.sqlite", "-q"}).exit_code, 0);
  const std::string whole = dump("s.sqlite");
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file("s.sqlite").c_str(), &database), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(database,
                         "PRAGMA cache_size = 1; BEGIN; UPDATE parameters SET identified = 0; UPDATE inputs SET "
                         "path = path || 'somewhere else'",
                         nullptr, nullptr, nullptr),
            SQLITE_OK);
  // As they lie there where the process is killed now.
  for (const char* name : {"s.sqlite", "s.sqlite-journal"}) {
    std::filesystem::copy_file(file(name), file(std::string("killed-") + name));
  }
  sqlite3_close(database);
  const Ended ended = on_disk("8m",
                              "cp killed-s.sqlite disk/s.sqlite; cp killed-s.sqlite-journal disk/s.sqlite-journal\n"
                              "mount -o remount,ro disk; code artcal store dump disk/s.sqlite\n"
                              "mount -o remount,rw disk; artcal store dump disk/s.sqlite >undone.dump; ls disk");
  EXPECT_EQ(ended.out, "code 3\ns.sqlite\n");
  EXPECT_THAT(ended.err, HasSubstr("a run that was killed left s.sqlite-journal"));
  EXPECT_EQ(text_of("undone.dump"), whole);
}

TEST_F(FullDisk, AMergeLeavesTheStoreAsItWas) {
  file_away_quick_ones(150);
  ASSERT_EQ(batch({"--store", "all.sqlite", "-q"}).exit_code, 0);
  ASSERT_EQ(run({"batch", "archive/quick-000", "--store", "one.sqlite", "-q"}).exit_code, 0);
  const Ended ended = on_disk("300k",
                              "cp one.sqlite disk/s.sqlite\n"
                              "code artcal store merge disk/s.sqlite all.sqlite\n"
                              "cp disk/s.sqlite after.sqlite\n"
                              "mount -o remount,size=64m disk\n"
                              "code artcal store merge disk/s.sqlite all.sqlite -q\ncp disk/s.sqlite merged.sqlite");
  EXPECT_EQ(ended.out, "code 3\ncode 0\n");
  EXPECT_THAT(ended.err, HasSubstr("disk/s.sqlite: the store cannot be written: the disk is full"));
  EXPECT_EQ(dump("after.sqlite"), dump("one.sqlite"));
  EXPECT_EQ(dump("merged.sqlite"), dump("all.sqlite"));
}

TEST_F(FullDisk, APageThatDoesNotFitIsMadeWhenThereIsRoom) {
  file_away_quick_ones(30);
  ASSERT_EQ(batch({"--store", "whole.sqlite", "-q", "--report", "whole.html"}).exit_code, 0);
  const Ended ended =
      on_disk("2300k",
              "code artcal batch archive --store s.sqlite --report disk/whole.html\n"
              "ls disk/whole-reports >listed\n"
              "mount -o remount,size=64m disk\n"
              "code artcal batch archive --store s.sqlite --resume --report disk/whole.html -q\n"
              "diff -r whole-reports disk/whole-reports && cmp whole.html disk/whole.html && echo same");
  EXPECT_THAT(ended.out, HasSubstr("reports not written"));
  EXPECT_THAT(ended.out, HasSubstr("No space left on device"));
  EXPECT_THAT(ended.out, ::testing::EndsWith("code 0\nsame\n"));
  EXPECT_EQ(dump("s.sqlite"), dump("whole.sqlite"));
  EXPECT_THAT(text_of("listed"), ::testing::MatchesRegex("(plots-[0-9a-f]+\\.js\n|quick-[^\n]*\\.html\n)+"));
}

TEST_F(FullDisk, ResultsReplaceOldOnesOrLeaveThem) {
  take("two-socket-bar");
  take("simulate");
  const Ended ended = on_disk("16k",
                              "for name in arm.toml r.json r.html; do echo old >disk/$name; done\n"
                              "i='identify two-socket-bar/recording.toml --no-leave-out -q'\n"
                              "code artcal $i -o disk/arm.toml --json disk/r.json\n"
                              "code artcal $i --json disk/r.json\n"
                              "code artcal $i --report disk/r.html\n"
                              "code artcal simulate simulate/plan.toml -o disk/made -q\n"
                              "ls disk; cat disk/r.json disk/r.html");
  EXPECT_EQ(count_of(ended.out, "code 3\n"), 4) << ended.out;
  EXPECT_THAT(ended.out, ::testing::EndsWith("arm.toml\nr.html\nr.json\nold\nold\n"));
  for (const char* name : {"disk/r.json", "disk/r.html"}) {
    EXPECT_THAT(ended.err, HasSubstr(std::string(name) + ": the file cannot be written: No space left on device"));
  }
}

TEST_F(FullDisk, WhatIsSaidIntoAFullDiskIsNotSaid) {
  file_away_quick_ones(150);
  ASSERT_EQ(batch({"--store", "s.sqlite", "-q"}).exit_code, 0);
  for (const char* call :
       {"store dump s.sqlite", "batch archive --store s.sqlite --resume", "identify archive/quick-001/recording.toml",
        "--help", "store --help", "history 'Gao 2013, Table 1' --store s.sqlite"}) {
    const Ended ended = on_disk("4k", std::string("artcal ") + call + " 2>err >/dev/full; echo code $?; cat err");
    EXPECT_EQ(ended.out, "code 3\nartcal: standard output cannot be written\n") << call;
  }
}

TEST_F(FullDisk, ADiskThatCanOnlyBeReadIsReadAndNotWritten) {
  file_away_quick_ones(3);
  ASSERT_EQ(batch({"--store", "whole.sqlite", "-q"}).exit_code, 0);
  const Ended ended = on_disk("4m",
                              "cp whole.sqlite disk/s.sqlite; mount -o remount,ro disk\n"
                              "artcal store dump disk/s.sqlite >read.dump\n"
                              "code artcal history 'Gao 2013, Table 1' --store disk/s.sqlite >/dev/null\n"
                              "code artcal batch archive --store disk/s.sqlite --resume -q\n"
                              "code artcal batch archive --store disk/s.sqlite -q\n"
                              "code artcal batch archive --store disk/new.sqlite -q\n"
                              "code artcal identify archive/quick-001/recording.toml -q -o disk/arm.toml\n"
                              "code artcal batch archive --store here.sqlite -q --report disk/index.html\n"
                              "ls disk");
  EXPECT_EQ(ended.out, "code 0\ncode 3\ncode 3\ncode 3\ncode 3\ns.sqlite\n");
  EXPECT_EQ(text_of("read.dump"), dump("whole.sqlite"));
  EXPECT_EQ(dump("here.sqlite"), dump("whole.sqlite"));
  EXPECT_THAT(ended.err,
              HasSubstr("disk/s.sqlite: the store cannot be written: the file, or the disk that it is on, can only "
                        "be read"));
  EXPECT_THAT(ended.err, HasSubstr("disk/new.sqlite: the store cannot be opened: "));
  EXPECT_EQ(count_of(ended.err, "Read-only file system"), 4) << ended.err;  // of the reports and their index
}

}  // namespace
}  // namespace artcal
