#include "app/store/store.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/store/migrations.h"

namespace artcal {
namespace {

template <typename Work>
auto attempt(const Database& database, const char* what, Work work) -> Expected<decltype(work())> {
  try {
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      return {};
    } else {
      return work();
    }
  } catch (const DatabaseError& error) {
    return bad_input(fmt::format("the store cannot be {}: {}", what, error.what()), database.name());
  } catch (const std::bad_variant_access&) {
    return bad_input(
        fmt::format("the store cannot be {}: a column holds values of another kind than artcal batch writes "
                    "there; it is damaged",
                    what),
        database.name());
  }
}

std::vector<StoreTable> all_tables() {
  std::vector<StoreTable> tables;
  for (std::size_t i = 0; i < store_table_count; ++i) {
    tables.push_back(static_cast<StoreTable>(i));
  }
  return tables;
}

std::string listed(const std::vector<StoreColumn>& columns, std::size_t begin, std::size_t end, const char* format) {
  std::string text;
  for (std::size_t i = begin; i < end; ++i) {
    text += (i > begin ? ", " : "") + fmt::format(fmt::runtime(format), columns[i].name, i);
  }
  return text;
}

std::string insertion(StoreTable table, Known known) {
  const TableShape& shape = shape_of(table);
  const std::size_t count = shape.columns.size();
  const std::string update = known == Known::Replace && count > shape.keys
                                 ? "UPDATE SET " + listed(shape.columns, shape.keys, count, "{0} = excluded.{0}")
                                 : "NOTHING";
  return fmt::format("INSERT INTO {} ({}) VALUES ({}) ON CONFLICT ({}) DO {}", shape.name,
                     listed(shape.columns, 0, count, "{0}"), listed(shape.columns, 0, count, ":v{1}"),
                     listed(shape.columns, 0, shape.keys, "{0}"), update);
}

// The order of bytes, whatever the server's language.
std::string in_order(StoreTable table, bool is_postgresql) {
  const TableShape& shape = shape_of(table);
  std::string keys;
  for (std::size_t i = 0; i < shape.keys; ++i) {
    keys += (i > 0 ? ", " : "") + std::string(shape.columns[i].name) +
            (is_postgresql && shape.columns[i].kind == ColumnKind::Text ? " COLLATE \"C\"" : "");
  }
  return fmt::format("SELECT {} FROM {} ORDER BY {}", listed(shape.columns, 0, shape.columns.size(), "{0}"), shape.name,
                     keys);
}

std::string line_of(StoreTable table, const StoreRow& row) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array({shape_of(table).name});
  for (const StoreValue& value : row) {
    std::visit(
        [&](const auto& inner) {
          if constexpr (std::is_same_v<std::decay_t<decltype(inner)>, std::monostate>) {
            json.push_back(nullptr);
          } else {
            json.push_back(inner);
          }
        },
        value);
  }
  return json.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

const std::string& text_at(const StoreRow& row, std::size_t i) {
  static const std::string none;
  const auto* text = std::get_if<std::string>(&row.at(i));
  return text != nullptr ? *text : none;
}

int whole_at(const StoreRow& row, std::size_t i) { return static_cast<int>(std::get<long long>(row.at(i))); }

// A path that is not UTF-8 stands in the store in other characters (app/store/stored_text.h): nothing is known of it.
bool is_gone(const std::string& path) {
  std::error_code error;
  return path.find("\\x") == std::string::npos && !std::filesystem::exists(path, error) && !error;
}

constexpr std::array parts_of_a_result{
    StoreTable::Stored,     StoreTable::Remarks,         StoreTable::VerificationValues, StoreTable::Verifications,
    StoreTable::Parameters, StoreTable::Identifications, StoreTable::UsedCertificates,   StoreTable::Inputs};

}  // namespace

Expected<Store> Store::open(const std::string& where, Database::Access access, int lock_wait_seconds) {
  auto database = Database::open(where, access, lock_wait_seconds);
  if (!database) {
    return tl::unexpected(database.error());
  }
  const char* what = access == Database::Access::Write ? "written" : "read";
  auto fit = attempt(*database, what,
                     [&] { return access == Database::Access::Write ? migrate(*database) : check_schema(*database); });
  if (!fit || !*fit) {
    return tl::unexpected(fit ? fit->error() : fit.error());
  }
  return Store(std::move(*database));
}

Expected<std::optional<StoredFile>> Store::file(const std::string& path) {
  return attempt(database_, "read", [&]() -> std::optional<StoredFile> {
    const auto rows = database_.rows(
        "SELECT f.recording, f.exit_code, f.error, i.path, i.sha256, r.name FROM files f LEFT JOIN inputs i ON "
        "i.recording = f.recording LEFT JOIN recordings r ON r.recording = f.recording "
        "WHERE f.path = :v0 ORDER BY i.position",
        {path});
    if (rows.empty()) {
      return std::nullopt;
    }
    const StoreRow& first = rows.front();
    StoredFile file{text_at(first, 0), text_at(first, 5), {whole_at(first, 1), text_at(first, 2)}, {}};
    for (const StoreRow& row : rows) {
      file.inputs.push_back({text_at(row, 3), text_at(row, 4)});
    }
    return file;
  });
}

Expected<std::optional<StoredResult>> Store::result(const std::string& recording) {
  return attempt(database_, "read", [&]() -> std::optional<StoredResult> {
    const auto rows = database_.rows("SELECT exit_code, error FROM recordings WHERE recording = :v0", {recording});
    if (rows.empty()) {
      return std::nullopt;
    }
    return StoredResult{whole_at(rows.front(), 0), text_at(rows.front(), 1)};
  });
}

void Store::insert(StoreTable table, const std::vector<StoreRow>& rows, Known known) {
  if (!rows.empty()) {
    database_.run_for(insertion(table, known), shape_of(table).columns, rows);
  }
}

Expected<void> Store::write(const std::vector<StoreEntry>& entries, Known known) {
  return attempt(database_, "written", [&] {
    database_.in_transaction([&] {
      for (const StoreEntry& entry : entries) {
        if (known == Known::Replace && !entry[StoreTable::Recordings].empty()) {
          const StoreValue& recording = entry[StoreTable::Recordings].front().front();
          for (const StoreTable table : parts_of_a_result) {
            database_.run(fmt::format("DELETE FROM {} WHERE recording = :v0", shape_of(table).name), {recording});
          }
        }
      }
      for (const StoreTable table : all_tables()) {
        std::vector<StoreRow> rows;
        for (const StoreEntry& entry : entries) {
          rows.insert(rows.end(), entry[table].begin(), entry[table].end());
        }
        const bool is_replaced =
            table == StoreTable::Files || (table == StoreTable::Recordings && known == Known::Replace);
        insert(table, rows, is_replaced ? Known::Replace : Known::Keep);
      }
    });
  });
}

Expected<void> Store::forget_moved(const std::vector<StoreEntry>& entries) {
  std::vector<std::string> gone;
  const auto found = attempt(database_, "read", [&] {
    for (const StoreEntry& entry : entries) {
      for (const StoreRow& row : entry[StoreTable::Files]) {
        if (text_at(row, 1).empty()) {
          continue;
        }
        for (const StoreRow& other :
             database_.rows("SELECT path FROM files WHERE recording = :v0 AND path <> :v1", {row.at(1), row.at(0)})) {
          if (is_gone(text_at(other, 0))) {
            gone.push_back(text_at(other, 0));
          }
        }
      }
    }
  });
  return found && !gone.empty() ? forget(gone) : found;
}

Expected<void> Store::forget(const std::vector<std::string>& paths) {
  return attempt(database_, "written", [&] {
    database_.in_transaction([&] {
      for (const std::string& path : paths) {
        database_.run("DELETE FROM files WHERE path = :v0", {path});
      }
    });
  });
}

Expected<void> Store::merge(Store& other) {
  constexpr std::size_t at_once = 1000;
  const auto take = [&](StoreTable table) {
    std::vector<StoreRow> rows;
    const auto known = table == StoreTable::Files ? Known::Replace : Known::Keep;
    other.database_.query(in_order(table, other.database_.is_postgresql()), {}, [&](StoreRow row) {
      rows.push_back(std::move(row));
      if (rows.size() == at_once) {
        insert(table, rows, known);
        rows.clear();
      }
    });
    insert(table, rows, known);
  };
  return attempt(database_, "written", [&] {
    database_.in_transaction([&] {
      other.database_.in_snapshot([&] {
        for (const StoreTable table : all_tables()) {
          take(table);
        }
      });
    });
  });
}

Expected<void> Store::dump(const std::function<void(std::string_view)>& take) {
  return attempt(database_, "read", [&] {
    database_.in_snapshot([&] {
      for (const StoreTable table : all_tables()) {
        if (table != StoreTable::Stored) {
          database_.query(in_order(table, database_.is_postgresql()), {},
                          [&](const StoreRow& row) { take(line_of(table, row)); });
        }
      }
    });
  });
}

Expected<void> Store::in_snapshot(const std::function<void()>& read) {
  return attempt(database_, "read", [&] { database_.in_snapshot(read); });
}

Expected<std::vector<StoreRow>> Store::rows(const std::string& sql, const StoreRow& values) {
  return attempt(database_, "read", [&] { return database_.rows(sql, values); });
}

}  // namespace artcal
