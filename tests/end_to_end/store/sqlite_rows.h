#pragma once

#include <sqlite3.h>

#include <filesystem>
#include <string>

namespace artcal::testing {

/// Rows that a query gives, by SQLite itself; -1 where it is refused.
inline int sqlite_rows(const std::filesystem::path& store, const std::string& sql) {
  sqlite3* database = nullptr;
  int rows = -1;
  if (sqlite3_open_v2(store.c_str(), &database, SQLITE_OPEN_READONLY, nullptr) == SQLITE_OK) {
    rows = 0;
    const auto count = [](void* counted, int, char**, char**) { return ++*static_cast<int*>(counted), 0; };
    rows = sqlite3_exec(database, sql.c_str(), count, &rows, nullptr) == SQLITE_OK ? rows : -1;
  }
  sqlite3_close(database);
  return rows;
}

}  // namespace artcal::testing
