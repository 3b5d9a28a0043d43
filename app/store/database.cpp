#include "app/store/database.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fmt/format.h>
#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "app/store/postgresql_backend.h"
#include "app/store/stored_text.h"
#include "app/store/where.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// Far longer than any statement of a batch, and than a batch pauses within a transaction.
constexpr int statement_minutes = 10;
constexpr int idle_minutes = 5;
constexpr std::string_view kept_locked = "another process has kept it locked";

/// What SOCI binds a row's values from; their places must not move.
class Buffers {
 public:
  explicit Buffers(std::vector<StoreColumn> columns)
      : columns_(std::move(columns)),
        texts_(columns_.size()),
        wholes_(columns_.size()),
        reals_(columns_.size()),
        indicators_(columns_.size(), soci::i_null) {}

  void bind_to(soci::statement& statement) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const std::string name = fmt::format("v{}", i);
      switch (columns_[i].kind) {
        case ColumnKind::Text: statement.exchange(soci::use(texts_[i], indicators_[i], name)); break;
        case ColumnKind::Whole: statement.exchange(soci::use(wholes_[i], indicators_[i], name)); break;
        case ColumnKind::Real: statement.exchange(soci::use(reals_[i], indicators_[i], name)); break;
      }
    }
  }

  void fill(const StoreRow& row) {
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      indicators_[i] = std::holds_alternative<std::monostate>(row.at(i)) ? soci::i_null : soci::i_ok;
      if (indicators_[i] == soci::i_null) {
        continue;
      }
      switch (columns_[i].kind) {
        case ColumnKind::Text: texts_[i] = valid_utf8(std::get<std::string>(row[i])); break;
        case ColumnKind::Whole: wholes_[i] = std::get<long long>(row[i]); break;
        case ColumnKind::Real: reals_[i] = std::get<double>(row[i]); break;
      }
    }
  }

 private:
  std::vector<StoreColumn> columns_;
  std::vector<std::string> texts_;
  std::vector<long long> wholes_;
  std::vector<double> reals_;
  std::vector<soci::indicator> indicators_;
};

std::vector<StoreColumn> columns_of(const StoreRow& values) {
  std::vector<StoreColumn> columns;
  for (const StoreValue& value : values) {
    columns.push_back({"", std::holds_alternative<double>(value)      ? ColumnKind::Real
                           : std::holds_alternative<long long>(value) ? ColumnKind::Whole
                                                                      : ColumnKind::Text});
  }
  return columns;
}

StoreValue value_at(const soci::row& row, std::size_t i) {
  if (row.get_indicator(i) == soci::i_null) {
    return {};
  }
  switch (row.get_properties(i).get_data_type()) {
    case soci::dt_double: return row.get<double>(i);
    case soci::dt_integer: return static_cast<long long>(row.get<int>(i));
    case soci::dt_long_long: return row.get<long long>(i);
    case soci::dt_string: return row.get<std::string>(i);
    default:
      throw DatabaseError(fmt::format("column {} is of a kind that no store has", row.get_properties(i).get_name()));
  }
}

bool holds(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

// What to do about a message of SQLite or PostgreSQL; the message itself where there is nothing to add.
std::string explained(const std::string& text, int lock_wait_seconds) {
  if (holds(text, "database is locked") || holds(text, "lock timeout")) {
    return fmt::format("{} for {} s: wait for it, or end it if it was stopped, and run this again", kept_locked,
                       lock_wait_seconds);
  }
  if (holds(text, "statement timeout")) {
    return fmt::format("the server did not finish a statement in {} minutes; look at its load and run this again",
                       statement_minutes);
  }
  if (holds(text, "idle-in-transaction") || holds(text, "server closed the connection")) {
    return fmt::format(
        "the server ended the connection: it was stopped, or this process stood still for {} minutes in the middle of "
        "its work; run this again",
        idle_minutes);
  }
  return holds(text, "disk is full")        ? "the disk is full"
         : holds(text, "readonly database") ? "the file, or the disk that it is on, can only be read"
                                            : text;
}

// One line of what the database says.
std::string reason_of(const std::exception& error, int lock_wait_seconds) {
  const auto* of_soci = dynamic_cast<const soci::soci_error*>(&error);
  std::string text = of_soci != nullptr ? of_soci->get_error_message() : error.what();
  for (const std::string_view prefix :
       {"sqlite3_statement_backend::loadOne: ", "Cannot establish connection to the database. ",
        "sqlite3_statement_backend::prepare: "}) {
    if (text.starts_with(prefix)) {
      text.erase(0, prefix.size());
    }
  }
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) {
    text.pop_back();
  }
  return in_one_line(explained(text, lock_wait_seconds));
}

bool is_locked(const std::string& reason) { return reason.starts_with(kept_locked); }

// Everything that SOCI throws leaves as DatabaseError.
template <typename Work>
auto translated(int lock_wait_seconds, Work work) {
  try {
    return work();
  } catch (const soci::soci_error& error) {
    throw DatabaseError(reason_of(error, lock_wait_seconds));
  }
}

// A writer must not keep the others out for ever; what only reads keeps nobody out.
void limit_waiting(soci::session& session, int lock_wait_seconds) {
  session << fmt::format("SET lock_timeout TO '{} s'", lock_wait_seconds);
  session << fmt::format("SET statement_timeout TO '{} min'", statement_minutes);
  session << fmt::format("SET idle_in_transaction_session_timeout TO '{} min'", idle_minutes);
}

// Why a file cannot be made, which SQLite does not tell; empty where it is there, or could be.
std::string why_no_file(const std::string& file) {
  std::error_code ignored;
  const auto folder = std::filesystem::path(file).parent_path();
  if (std::filesystem::exists(file, ignored) || ::access(folder.c_str(), W_OK) == 0) {
    return {};
  }
  return fmt::format("{}: {}", folder.string(), std::strerror(errno));
}

std::string to_be_undone(const std::string& file) {
  std::error_code ignored;
  const std::string journal = file + "-journal";
  return !file.empty() && std::filesystem::exists(journal, ignored)
             ? fmt::format(
                   "; a run that was killed left {}, which must be beside it and which the next run undoes, where "
                   "both can be written",
                   std::filesystem::path(journal).filename().string())
             : "";
}

}  // namespace

struct Database::Connection {
  soci::session session;
  bool is_postgresql = false;
  std::string name;
  int lock_wait_seconds = lock_wait;
};

Database::Database(std::unique_ptr<Connection> connection) : connection_(std::move(connection)) {}
Database::Database(Database&&) noexcept = default;
Database& Database::operator=(Database&&) noexcept = default;
Database::~Database() = default;

bool Database::is_postgresql() const { return connection_->is_postgresql; }
const std::string& Database::name() const { return connection_->name; }

Expected<Database> Database::open(const std::string& where, Access access, int lock_wait_seconds) {
  auto place = parse_store(where);
  if (!place) {
    return tl::unexpected(place.error());
  }
  auto connection = std::make_unique<Connection>();
  connection->is_postgresql = place->is_postgresql;
  connection->name = place->name;
  connection->lock_wait_seconds = lock_wait_seconds;
  std::error_code ignored;
  if (!place->is_postgresql && access == Access::Read && !std::filesystem::exists(place->file, ignored)) {
    return bad_input("there is no such store; artcal batch --store makes one", place->name);
  }
  try {
    if (place->is_postgresql) {
      connection->session.open(postgresql_backend(), place->connection);
      connection->session << "SET client_min_messages TO warning";
      if (access == Access::Write) {
        limit_waiting(connection->session, lock_wait_seconds);
      }
    } else {
      connection->session.open(*soci::factory_sqlite3(),
                               fmt::format("dbname=\"{}\" timeout={}", place->file, lock_wait_seconds));
      connection->session << "PRAGMA foreign_keys = ON";
      // Reads the first page: what is no database is found now.
      connection->session << "PRAGMA user_version";
    }
  } catch (const std::exception& error) {
    const std::string reason = place->is_postgresql ? "" : why_no_file(place->file);
    const std::string told = reason.empty() ? reason_of(error, lock_wait_seconds) : reason;
    // The journal of one that is still writing is its own.
    return bad_input(
        fmt::format("the store cannot be opened: {}{}", told, is_locked(told) ? "" : to_be_undone(place->file)),
        place->name);
  }
  return Database(std::move(connection));
}

void Database::run(const std::string& sql, const StoreRow& values) { run_for(sql, columns_of(values), {values}); }

void Database::run_for(const std::string& sql, const std::vector<StoreColumn>& columns,
                       const std::vector<StoreRow>& rows) {
  translated(connection_->lock_wait_seconds, [&] {
    Buffers buffers(columns);
    soci::statement statement(connection_->session);
    buffers.bind_to(statement);
    statement.alloc();
    statement.prepare(sql);
    statement.define_and_bind();
    for (const StoreRow& row : rows) {
      buffers.fill(row);
      statement.execute(true);
    }
  });
}

void Database::query(const std::string& sql, const StoreRow& values, const std::function<void(StoreRow)>& take) {
  translated(connection_->lock_wait_seconds, [&] {
    Buffers buffers(columns_of(values));
    buffers.fill(values);
    soci::row found;
    soci::statement statement(connection_->session);
    buffers.bind_to(statement);
    statement.exchange(soci::into(found));
    statement.alloc();
    statement.prepare(sql);
    statement.define_and_bind();
    statement.execute();
    while (statement.fetch()) {
      StoreRow row;
      for (std::size_t i = 0; i < found.size(); ++i) {
        row.push_back(value_at(found, i));
      }
      take(std::move(row));
    }
  });
}

std::vector<StoreRow> Database::rows(const std::string& sql, const StoreRow& values) {
  std::vector<StoreRow> all;
  query(sql, values, [&](StoreRow row) { all.push_back(std::move(row)); });
  return all;
}

void Database::between(const char* begin, const std::function<void()>& work) {
  run(begin);
  try {
    work();
    run("COMMIT");
  } catch (...) {
    try {
      run("ROLLBACK");
    } catch (const DatabaseError&) {  // a full disk has rolled back already
    }
    try {
      // Where it could not, SQLite does so before it reads again; else its journal would be left to whoever comes next.
      rows(is_postgresql() ? "SELECT 1" : "PRAGMA schema_version");
    } catch (const DatabaseError&) {
    }
    throw;
  }
}

void Database::in_transaction(const std::function<void()>& work) {
  between(is_postgresql() ? "BEGIN" : "BEGIN IMMEDIATE", [&] {
    if (is_postgresql()) {
      // One writer at a time, so that none finds rows that another is about to write. The number is this program's.
      rows("SELECT 1 FROM (SELECT pg_advisory_xact_lock(6172746361)) AS waited");
    }
    work();
  });
}

void Database::in_snapshot(const std::function<void()>& work) {
  between(is_postgresql() ? "BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY" : "BEGIN", work);
}

}  // namespace artcal
