// The store as databases see it: every question of docs/store.md, on SQLite and on PostgreSQL.
#include <arpa/inet.h>
#include <sqlite3.h>
#include <sys/socket.h>

#include <cstdio>
#include <sstream>

#include <gmock/gmock.h>

#include "tests/end_to_end/archive.h"
#include "tests/end_to_end/store/sqlite_rows.h"
#include "tests/support/postgresql_server.h"

namespace artcal {
namespace {

using testing::Ended;
using ::testing::HasSubstr;
using testing::sqlite_rows;

std::vector<std::string> documented_queries() {
  std::istringstream lines(testing::read_all(std::string(ARTCAL_SOURCE_DIR) + "/docs/store.md"));
  std::vector<std::string> queries;
  bool in_block = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("    SELECT")) {
      queries.emplace_back();
      in_block = true;
    }
    in_block = in_block && line.starts_with("    ");
    if (in_block) {
      queries.back() += line.substr(4) + "\n";
    }
  }
  return queries;
}

class StoreTest : public testing::ArchiveTest {
 protected:
  void file_away_some_of_each() const {
    file_away_quick_ones(3);
    file_away("two-socket-bar", "robot", "");
    for (int i = 0; i < 2; ++i) {
      const std::string name = fmt::format("test-{}", i);
      file_away("iso10360-12", name, fmt::format("date = 203{}-05-01\n", i));
      const std::string bar = "archive/" + name + "/bar.toml";
      write(bar, with_certificate(text_of(bar),
                                  "number = \"4711\"\nlaboratory = \"Example Laboratory\"\n"
                                  "date = 2026-03-02\nvalid_until = 2028-03-01\n"));
    }
    write("archive/broken/recording.toml", "");
  }
};

TEST_F(StoreTest, SqliteAnswersEveryDocumentedQuestion) {
  file_away_some_of_each();
  ASSERT_EQ(batch({"--store", "s.sqlite", "-q"}).exit_code, 3);
  const auto queries = documented_queries();
  EXPECT_GE(queries.size(), 11u);
  for (const std::string& query : queries) {
    EXPECT_GT(sqlite_rows(file("s.sqlite"), query), 0) << query;
  }
}

TEST_F(StoreTest, EveryTableIsDocumentedWithItsColumns) {
  file_away_quick_ones(1);
  ASSERT_EQ(batch({"--store", "s.sqlite", "-q"}).exit_code, 0);
  const std::string page = testing::read_all(std::string(ARTCAL_SOURCE_DIR) + "/docs/store.md");
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open_v2(file("s.sqlite").c_str(), &database, SQLITE_OPEN_READONLY, nullptr), SQLITE_OK);
  std::vector<std::string> columns;
  const auto take = [](void* all, int, char** values, char**) {
    static_cast<std::vector<std::string>*>(all)->push_back(std::string("`") + values[0] + "`");
    return 0;
  };
  sqlite3_exec(database,
               "SELECT name FROM sqlite_master WHERE type = 'table' UNION SELECT c.name FROM sqlite_master m, "
               "pragma_table_info(m.name) c WHERE m.type = 'table' AND m.name <> 'artcal_migrations'",
               take, &columns, nullptr);
  sqlite3_close(database);
  EXPECT_GT(columns.size(), 60u);
  for (const std::string& column : columns) {
    if (!column.starts_with("`u_")) {  // the parts of a budget are told by the first and the last
      EXPECT_THAT(page, HasSubstr(column));
    }
  }
}

// A store of the first schema, with an identification and a parameter.
void make_store_of_schema_1(const std::filesystem::path& store) {
  std::istringstream lines(testing::read_all(std::string(ARTCAL_SOURCE_DIR) + "/app/store/migrations/001-results.sql"));
  std::string sql;
  for (std::string line; std::getline(lines, line);) sql += line.starts_with("--") ? "" : line + "\n";
  sql +=
      "CREATE TABLE artcal_migrations (number INTEGER NOT NULL PRIMARY KEY, name TEXT NOT NULL);"
      "INSERT INTO artcal_migrations VALUES (1, '001-results');"
      "INSERT INTO arms VALUES ('old arm');"
      "INSERT INTO recordings VALUES ('r', 'artcal 0.0.1', '', 'old', '2020-01-01', 'old arm', 1, 0, NULL);"
      "INSERT INTO files VALUES ('/old', 'r', 0, NULL);"
      "INSERT INTO identifications VALUES ('r', 1, 0.01, 0, 5, 5, 1, 1, 2, 0.01, 0.02, NULL, 0, '[[1]]');"
      "INSERT INTO parameters VALUES ('r', 0, 'a1', 'mm', 'identified', 1, 1.5, 1);"
      "INSERT INTO parameters VALUES ('r', 1, 'a6', 'mm', 'held', 5, 5, NULL);"
      "INSERT INTO parameters VALUES ('r', 2, 'd1', 'mm', 'lost', 9, 9, NULL);";
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(store.c_str(), &database), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(database);
  sqlite3_close(database);
}

TEST_F(StoreTest, AnOlderStoreIsBroughtUpToDateAndKeepsItsRows) {
  file_away_quick_ones(1);
  make_store_of_schema_1(file("s.sqlite"));
  ASSERT_EQ(batch({"--store", "s.sqlite", "-q"}).exit_code, 0);
  EXPECT_EQ(sqlite_rows(file("s.sqlite"), "SELECT * FROM artcal_migrations"), 4);
  EXPECT_EQ(sqlite_rows(file("s.sqlite"), "SELECT * FROM parameters WHERE recording = 'r' AND identified = 1.5"), 1);
  EXPECT_EQ(sqlite_rows(file("s.sqlite"), "SELECT * FROM identifications WHERE rms_before_mm = 1"), 1);
  EXPECT_EQ(sqlite_rows(file("s.sqlite"),
                        "SELECT * FROM parameters WHERE recording = 'r' AND name = 'a6' AND state = 'fixed'"),
            1);
  EXPECT_EQ(sqlite_rows(file("s.sqlite"),
                        "SELECT * FROM parameters WHERE recording = 'r' AND name = 'd1' AND state = 'unidentifiable'"),
            1);
  EXPECT_EQ(sqlite_rows(file("s.sqlite"), "SELECT * FROM identifications WHERE recording = 'r' AND scale_factor = 1"),
            1);
  EXPECT_EQ(sqlite_rows(file("s.sqlite"), "PRAGMA foreign_key_check"), 0);
  EXPECT_GT(sqlite_rows(file("s.sqlite"), "SELECT * FROM parameters WHERE coverage_factor >= 2"), 0);
  const Ended history = run({"history", "old arm", "--store", "s.sqlite"});
  EXPECT_EQ(history.exit_code, 0) << history.err;
  EXPECT_THAT(history.out, HasSubstr("1.0000"));
}

class OnPostgresql : public StoreTest {
 protected:
  void SetUp() override {
    if (!server_.is_installed()) {
      GTEST_SKIP() << "PostgreSQL IS NOT INSTALLED: nothing was tested on it (apt-get install postgresql)";
    }
    ASSERT_TRUE(server_.runs());
  }
  testing::PostgresqlServer server_;
};

TEST_F(OnPostgresql, TheSameRowsAndAnswersAsOnSqlite) {
  file_away_some_of_each();
  const std::string url = server_.url();
  ASSERT_EQ(batch({"--store", "s.sqlite", "-q"}).exit_code, 3);
  const Ended ended = batch({"--store", url, "-q"});
  ASSERT_EQ(ended.exit_code, 3) << ended.err;
  EXPECT_EQ(dump(url), dump("s.sqlite"));
  for (const std::string& query : documented_queries()) {
    write("query.sql", query + ";");
    std::filesystem::permissions(folder("work"), std::filesystem::perms::all);
    EXPECT_EQ(server_.rows("postgres", file("query.sql").string()), sqlite_rows(file("s.sqlite"), query)) << query;
  }
  EXPECT_THAT(batch({"--store", url, "--resume"}).out, HasSubstr("known before, left alone  6"));
  EXPECT_EQ(dump(url), dump("s.sqlite"));
}

TEST_F(OnPostgresql, ManyWritersAndMerging) {
  file_away_quick_ones(40);
  (void)batch({"--store", "all.sqlite", "-q"});
  const std::string url = server_.url();
  std::vector<pid_t> writers;
  for (int i = 0; i < 3; ++i) {
    writers.push_back(start({"batch", "archive", "--store", url, "-q"}));
  }
  for (const pid_t writer : writers) {
    EXPECT_EQ(wait_for(writer).exit_code, 0);
  }
  EXPECT_EQ(dump(url), dump("all.sqlite"));
  EXPECT_EQ(run({"store", "merge", "back.sqlite", url, url}).exit_code, 0);
  EXPECT_EQ(dump("back.sqlite"), dump("all.sqlite"));
  ASSERT_TRUE(server_.make_database("other"));
  EXPECT_EQ(run({"store", "merge", server_.url("other"), "back.sqlite"}).exit_code, 0);
  EXPECT_EQ(dump(server_.url("other")), dump("all.sqlite"));
}

TEST_F(OnPostgresql, EveryDocumentedFormOfUrlIsTheSameStore) {
  file_away_quick_ones(1);
  ASSERT_TRUE(server_.make_database("lab"));
  ASSERT_EQ(batch({"--store", server_.url("lab"), "-q"}).exit_code, 0);
  const std::string stored = dump(server_.url("lab"));
  std::string host;
  for (const char c : server_.socket_folder()) {
    host += c == '/' ? "%2F" : std::string(1, c);
  }
  for (const std::string& url :
       {"postgresql://artcal@" + host + "/lab", "postgres://artcal:a%20secret%27%5C@" + host + ":5432/lab",
        "postgresql://artcal@/lab?host=" + host, "postgresql:///?host=" + host + "&user=artcal&dbname=lab",
        "postgresql://artcal:secret@" + host + ":5432," + host + ":1/lab?application_name=two%20words",
        "POSTGRESQL://artcal@" + host + "/%6cab?connect_timeout=5"}) {
    const Ended ended = run({"store", "dump", url});
    EXPECT_EQ(ended.exit_code, 0) << url << ended.err;
    EXPECT_EQ(ended.out, stored) << url;
    EXPECT_EQ(batch({"--store", url, "--resume", "-q"}).exit_code, 0) << url;
  }
}

TEST_F(StoreTest, APasswordIsInNoMessageWhateverTheUrl) {
  file_away_quick_ones(1);
  ASSERT_EQ(batch({"--store", "s.sqlite", "-q"}).exit_code, 0);
  const auto expect_no_secret = [&](const std::vector<std::string>& arguments) {
    const Ended ended = run(arguments);
    EXPECT_THAT(ended.exit_code, ::testing::AnyOf(2, 3)) << arguments.back();
    for (const std::string& text : {ended.out, ended.err}) {
      EXPECT_THAT(text, ::testing::Not(HasSubstr("secret"))) << arguments.back();
    }
  };
  for (const char* url :
       {"postgresql://u:p@secret@127.0.0.1:1/a?x", "postgresql://u:100%secret@127.0.0.1:1/a?connect_timeout=1",
        "postgresql://u:sec/secret@127.0.0.1:1/a?connect_timeout=1",
        "postgresql://u@127.0.0.1:1/a?sslpassword=secret&password=secret",
        "postgresql://u:secret@[::1/a?connect_timeout=1", "Postgresql://u:secret@127.0.0.1:1/a",
        "postgresql://u:secret@127.0.0.1:1/a?wrong=1", "mysql://u:secret@h/a", "host=h password=secret"}) {
    expect_no_secret({"batch", "archive", "--store", url});
  }
  const std::string url = "postgresql://u:secret@127.0.0.1:1/a";
  expect_no_secret({"history", "arm", "--store", url});
  expect_no_secret({"store", "dump", url});
  expect_no_secret({"store", "merge", "s.sqlite", url});
  expect_no_secret({"identify", url});
  expect_no_secret({"batch", "archive", "--stor", url});
  expect_no_secret({"batch", "--store", "s.sqlite", url});
  EXPECT_THAT(dump("s.sqlite"), ::testing::Not(HasSubstr("secret")));
}

// A server that takes connections and says nothing.
TEST_F(StoreTest, APasswordIsNotInTheListOfProcesses) {
  const int server = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  ASSERT_EQ(::bind(server, reinterpret_cast<const sockaddr*>(&address), size), 0);
  ASSERT_EQ(::listen(server, 1), 0);
  ASSERT_EQ(::getsockname(server, reinterpret_cast<sockaddr*>(&address), &size), 0);
  file_away_quick_ones(1);
  const pid_t program = start(
      {"batch", "archive", "--store", fmt::format("postgresql://u:secret@127.0.0.1:{}/a", ntohs(address.sin_port))});
  std::string listed;
  for (int i = 0; i < 200 && listed.find("u:***@") == std::string::npos; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    listed = testing::read_all(fmt::format("/proc/{}/cmdline", program));
  }
  EXPECT_THAT(listed, HasSubstr("postgresql://u:***@127.0.0.1:"));
  EXPECT_THAT(listed, ::testing::Not(HasSubstr("secret")));
  ::kill(program, SIGKILL);
  (void)wait_for(program);
  ::close(server);
}

TEST_F(OnPostgresql, AServerThatDoesNotAnswerIsToldOfWithoutThePassword) {
  file_away_quick_ones(1);
  const Ended ended = batch({"--store", "postgresql://me:secret@127.0.0.1:1/none"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.err, HasSubstr("postgresql://me:***@127.0.0.1:1/none: the store cannot be opened"));
  EXPECT_THAT(ended.err, ::testing::Not(HasSubstr("secret")));
  EXPECT_EQ(testing::count_of(ended.err, "\n"), 1) << ended.err;
}

}  // namespace
}  // namespace artcal
