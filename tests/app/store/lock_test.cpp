// A writer that stands still must not keep the others waiting for ever.
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include <gmock/gmock.h>

#include "app/store/store.h"
#include "tests/support/postgresql_server.h"
#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;

StoreEntry result(const std::string& recording) {
  StoreEntry entry;
  entry[StoreTable::Arms] = {{std::string("arm")}};
  entry[StoreTable::Recordings] = {
      {recording, std::string("1"), std::string(), std::string("name"), {}, std::string("arm"), 1LL, 0LL, {}}};
  return entry;
}

// A process that begins to write and is stopped in the middle of it, as by kill -STOP, or by Slurm that suspends it.
pid_t stopped_writer(const std::string& where) {
  const pid_t child = ::fork();
  if (child == 0) {
    auto database = Database::open(where, Database::Access::Write);
    if (database) {
      database->in_transaction([] { ::raise(SIGSTOP); });
    }
    ::_exit(database ? 0 : 1);
  }
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, WUNTRACED), child);
  EXPECT_TRUE(WIFSTOPPED(status));
  return child;
}

void write_beside_a_stopped_writer(const std::string& where) {
  ASSERT_TRUE(Store::open(where, Database::Access::Write)) << "made before anybody waits";
  const pid_t child = stopped_writer(where);
  Store store = Store::open(where, Database::Access::Write, 1).value();
  const auto written = store.write({result("0001")}, Known::Keep);
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().text(), HasSubstr("another process has kept it locked for 1 s"));
  EXPECT_THAT(written.error().text(), HasSubstr("or end it if it was stopped"));
  ::kill(child, SIGCONT);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_TRUE(store.write({result("0001")}, Known::Keep)) << "the store is as good as before";
}

TEST(StoreLock, OfAStoppedWriterOnSqlite) {
  const testing::TemporaryFolder folder;
  write_beside_a_stopped_writer((folder.path() / "s.sqlite").string());
}

class StoreLockOnPostgresql : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!server_.is_installed()) {
      GTEST_SKIP() << "PostgreSQL IS NOT INSTALLED: nothing was tested on it (apt-get install postgresql)";
    }
    ASSERT_TRUE(server_.runs());
  }
  testing::PostgresqlServer server_;
};

TEST_F(StoreLockOnPostgresql, OfAStoppedWriter) { write_beside_a_stopped_writer(server_.url()); }

TEST_F(StoreLockOnPostgresql, NoStatementAndNoPauseOfAWriterLastsForEver) {
  auto writer = Database::open(server_.url(), Database::Access::Write).value();
  for (const auto& [setting, limit] : {std::pair{"lock_timeout", "1min"},
                                       {"statement_timeout", "10min"},
                                       {"idle_in_transaction_session_timeout", "5min"}}) {
    EXPECT_EQ(std::get<std::string>(writer.rows(std::string("SHOW ") + setting).at(0).at(0)), limit);
  }
  auto reader = Database::open(server_.url(), Database::Access::Read).value();
  EXPECT_EQ(std::get<std::string>(reader.rows("SHOW idle_in_transaction_session_timeout").at(0).at(0)), "0");
}

TEST_F(StoreLockOnPostgresql, AWriterThatStoodStillIsToldWhy) {
  auto writer = Database::open(server_.url(), Database::Access::Write).value();
  writer.run("SET idle_in_transaction_session_timeout TO '100 ms'");
  std::string told;
  try {
    writer.in_transaction([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(600));
      writer.run("SELECT 1");
    });
  } catch (const DatabaseError& error) {
    told = error.what();
  }
  EXPECT_THAT(told, HasSubstr("stood still"));
}

}  // namespace
}  // namespace artcal
