#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/store/shape.h"
#include "core/error.h"

namespace artcal {

/// A connection to SQLite or PostgreSQL, and nothing of what is in it. What goes wrong after opening is thrown as
/// DatabaseError; the store makes an Error of it.
class Database {
 public:
  enum class Access {
    Read,   ///< what is not there is not made
    Write,  ///< a file that is not there is made
  };
  /// How long a writer waits for another one, in seconds.
  static constexpr int lock_wait = 60;

  /// `where` is postgresql://… or the path of a file. Refused: a file that is no database, a server that does not
  /// answer. On PostgreSQL no statement of a writer takes longer than ten minutes, and a transaction in which nothing
  /// happens for five minutes, because its process was stopped, is ended by the server.
  static Expected<Database> open(const std::string& where, Access access, int lock_wait_seconds = lock_wait);

  Database(Database&&) noexcept;
  Database& operator=(Database&&) noexcept;
  ~Database();

  [[nodiscard]] bool is_postgresql() const;
  /// The name that messages give it; of a URL without its password.
  [[nodiscard]] const std::string& name() const;

  void run(const std::string& sql, const StoreRow& values = {});
  /// Runs the statement once for each row; ":v0", ":v1", … stand for its values, which are of these kinds or NULL.
  void run_for(const std::string& sql, const std::vector<StoreColumn>& columns, const std::vector<StoreRow>& rows);
  /// Hands over the rows of a query one by one.
  void query(const std::string& sql, const StoreRow& values, const std::function<void(StoreRow)>& take);
  std::vector<StoreRow> rows(const std::string& sql, const StoreRow& values = {});

  /// Begins a transaction that may write, does the work, commits; rolls back if the work throws. Waits for others
  /// that write to the same store, for `lock_wait_seconds`.
  void in_transaction(const std::function<void()>& work);
  /// What the work reads is the content of one moment, whoever writes meanwhile. On SQLite others cannot commit until
  /// it is done.
  void in_snapshot(const std::function<void()>& work);

 private:
  void between(const char* begin, const std::function<void()>& work);
  struct Connection;
  explicit Database(std::unique_ptr<Connection> connection);
  std::unique_ptr<Connection> connection_;
};

struct DatabaseError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace artcal
