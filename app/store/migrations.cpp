#include "app/store/migrations.h"

#include <optional>
#include <sstream>

#include <fmt/format.h>

namespace artcal {
namespace {

// How many migrations the database has; nothing where it is no store.
std::optional<long long> applied(Database& database) {
  const std::string find =
      database.is_postgresql()
          ? "SELECT tablename FROM pg_tables WHERE tablename = 'artcal_migrations' AND schemaname = current_schema()"
          : "SELECT name FROM sqlite_master WHERE type = 'table' AND name = 'artcal_migrations'";
  if (database.rows(find).empty()) {
    return std::nullopt;
  }
  return static_cast<long long>(database.rows("SELECT number FROM artcal_migrations").size());
}

bool holds_something(Database& database) {
  return !database.is_postgresql() && !database.rows("SELECT name FROM sqlite_master").empty();
}

// Statements end with a semicolon at a line's end; lines of comment are left out.
std::vector<std::string> statements_of(const std::string& sql) {
  std::vector<std::string> statements;
  std::istringstream lines(sql);
  std::string statement;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("--") || line.empty()) {
      continue;
    }
    statement += line + "\n";
    if (line.ends_with(';')) {
      statement.resize(statement.size() - 2);
      statements.push_back(std::move(statement));
      statement.clear();
    }
  }
  return statements;
}

Expected<void> later_than_this(const Database& database, long long number) {
  return bad_input(fmt::format("the store has schema {}, this version of artcal knows {}; a later version has written "
                               "it and is needed to use it",
                               number, store_migrations().size()),
                   database.name());
}

Expected<void> no_store(const Database& database) {
  return bad_input("this database is no store of artcal; give a store, or the name of a file that is not there",
                   database.name());
}

}  // namespace

Expected<void> migrate(Database& database) {
  const auto known = static_cast<long long>(store_migrations().size());
  if (applied(database) == known) {
    return {};
  }
  Expected<void> done;
  database.in_transaction([&] {
    const auto number = applied(database);
    if (!number && holds_something(database)) {
      done = no_store(database);
      return;
    }
    if (number.value_or(0) > known) {
      done = later_than_this(database, *number);
      return;
    }
    if (!number) {
      database.run("CREATE TABLE artcal_migrations (number INTEGER NOT NULL PRIMARY KEY, name TEXT NOT NULL)");
    }
    for (long long i = number.value_or(0); i < known; ++i) {
      const Migration& migration = store_migrations()[static_cast<std::size_t>(i)];
      for (const std::string& statement : statements_of(migration.sql)) {
        database.run(statement);
      }
      database.run("INSERT INTO artcal_migrations (number, name) VALUES (:v0, :v1)", {i + 1, migration.name});
    }
  });
  return done;
}

Expected<void> check_schema(Database& database) {
  const auto known = static_cast<long long>(store_migrations().size());
  const auto number = applied(database);
  if (!number) {
    return no_store(database);
  }
  if (*number > known) {
    return later_than_this(database, *number);
  }
  if (*number < known) {
    return bad_input(fmt::format("the store has schema {}, this version of artcal needs {}; `artcal batch` on it, even "
                                 "without new recordings, brings it up to date",
                                 *number, known),
                     database.name());
  }
  return {};
}

}  // namespace artcal
