// Stores that somebody has changed: refused or shown, never read or written beyond what is there.
#include <sqlite3.h>

#include <gmock/gmock.h>

#include "tests/end_to_end/archive.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using testing::Ended;
using ::testing::HasSubstr;

class DamagedStore : public testing::ArchiveTest {
 protected:
  void SetUp() override {
    file_away("gao2013", "one", "date = 2026-05-01\n");
    file_away("gao2013", "two", "date = 2026-06-01\n");
    ASSERT_EQ(batch({"--store", "good.sqlite", "-q"}).exit_code, 0);
    ASSERT_EQ(history().exit_code, 0);
  }
  Ended history(const std::string& store = "good.sqlite") {
    return run({"history", "Gao 2013, Table 1", "--store", store});
  }
  // A copy of the store after a statement that its tables do not forbid.
  Ended history_after(const std::string& sql) {
    std::filesystem::copy_file(file("good.sqlite"), file("s.sqlite"),
                               std::filesystem::copy_options::overwrite_existing);
    sqlite3* database = nullptr;
    EXPECT_EQ(sqlite3_open(file("s.sqlite").c_str(), &database), SQLITE_OK);
    char* error = nullptr;
    EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, &error), SQLITE_OK) << sql << (error ? error : "");
    sqlite3_close(database);
    return history("s.sqlite");
  }
};

TEST_F(DamagedStore, ACovarianceThatIsNotThatOfItsParametersIsRefused) {
  for (const char* sql :
       {"UPDATE identifications SET covariance = replace(covariance, '[[', '[s[')",
        "DELETE FROM parameters WHERE position < 5", "UPDATE identifications SET covariance = '[[1]]'",
        "UPDATE identifications SET covariance = '[[null]]'", "UPDATE identifications SET covariance = '[]'",
        "UPDATE identifications SET covariance = '{}'", "UPDATE identifications SET covariance = ''",
        "UPDATE identifications SET covariance = covariance || 'x'",
        "UPDATE identifications SET covariance = '[' || covariance || ']'",
        "UPDATE identifications SET covariance = replace(covariance, '],[', ',0],[')",
        "UPDATE identifications SET covariance = replace(covariance, '[[', '[[-')"}) {
    const Ended ended = history_after(sql);
    EXPECT_EQ(ended.exit_code, 3) << sql << ended.out;
    EXPECT_THAT(ended.err, AllOf(HasSubstr("s.sqlite: the store is damaged: of the result "), HasSubstr("covariance")))
        << sql;
  }
}

TEST_F(DamagedStore, NumbersThatAreNoneAreRefused) {
  for (const char* sql : {"UPDATE parameters SET identified = 9e999", "UPDATE parameters SET u = NULL",
                          "UPDATE identifications SET rms_after_mm = -9e999", "UPDATE parameters SET state = 'x'"}) {
    const Ended ended = history_after(sql);
    EXPECT_EQ(ended.exit_code, 3) << sql << ended.out;
    EXPECT_THAT(ended.err, HasSubstr("the store is damaged")) << sql;
  }
}

TEST_F(DamagedStore, ColumnsOfAnotherKindAreRefused) {
  const std::string other =
      "PRAGMA foreign_keys = OFF; PRAGMA legacy_alter_table = ON; ALTER TABLE files RENAME TO old; CREATE TABLE files "
      "(path INTEGER, recording TEXT, exit_code TEXT, error TEXT); INSERT INTO files SELECT 1, recording, 'x', error "
      "FROM old; DROP TABLE old";
  (void)history_after(other);
  for (const auto& arguments : std::vector<std::vector<std::string>>{
           {"store", "merge", "into.sqlite", "s.sqlite"},
           {"batch", "archive", "--store", "s.sqlite", "--report", "i.html", "-q", "--resume"}}) {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.exit_code, 3) << arguments[0];
    EXPECT_THAT(ended.err, ::testing::Not(HasSubstr("internal error"))) << arguments[0];
  }
}

}  // namespace
}  // namespace artcal
