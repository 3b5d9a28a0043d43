// What is read of a store is of one moment.
#include <sqlite3.h>

#include <gtest/gtest.h>

#include "app/store/store.h"
#include "tests/support/postgresql_server.h"
#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

StoreEntry result(const std::string& recording, const std::string& arm) {
  StoreEntry entry;
  entry[StoreTable::Arms] = {{arm}};
  entry[StoreTable::Recordings] = {
      {recording, std::string("1"), std::string(), std::string("name"), {}, arm, 1LL, 0LL, {}}};
  entry[StoreTable::Files] = {{"/" + recording, recording, 0LL, {}}};
  return entry;
}

std::string dumped(Store& store, const std::function<void()>& meanwhile = {}) {
  std::string text;
  bool is_first = true;
  EXPECT_TRUE(store.dump([&](std::string_view line) {
    if (is_first && meanwhile) {
      meanwhile();
    }
    is_first = false;
    text += line;
  }));
  return text;
}

// A second result arrives when the first row has been read.
void dump_while_another_writes(const std::string& where) {
  Store reader = Store::open(where, Database::Access::Write).value();
  ASSERT_TRUE(reader.write({result("0001", "arm 1")}, Known::Keep));
  const std::string before = dumped(reader);
  ASSERT_NE(before.find("0001"), std::string::npos);
  const std::string during = dumped(reader, [&] {
    Store writer = Store::open(where, Database::Access::Write).value();
    ASSERT_TRUE(writer.write({result("0002", "arm 2")}, Known::Keep));
  });
  EXPECT_EQ(during, before);
  EXPECT_NE(dumped(reader).find("0002"), std::string::npos);
}

TEST(StoreSnapshot, OfSqlite) {
  const testing::TemporaryFolder folder;
  const std::string file = (folder.path() / "s.sqlite").string();
  // In this mode of SQLite writers do not wait for readers.
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(database, "PRAGMA journal_mode = WAL", nullptr, nullptr, nullptr), SQLITE_OK);
  sqlite3_close(database);
  dump_while_another_writes(file);
}

TEST(StoreSnapshot, OfPostgresql) {
  testing::PostgresqlServer server;
  if (!server.is_installed()) {
    GTEST_SKIP() << "PostgreSQL IS NOT INSTALLED: nothing was tested on it (apt-get install postgresql)";
  }
  ASSERT_TRUE(server.runs());
  dump_while_another_writes(server.url());
}

}  // namespace
}  // namespace artcal
