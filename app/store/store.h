#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/store/database.h"
#include "core/files/input_file.h"

namespace artcal {

/// What one recording file brings to a store: its rows of every table. StoreTable::Files has one row; the others are
/// empty where the recording could not be read, or where the store has its result already.
using StoreEntry = StoreRows;

/// What a recording came to.
struct StoredResult {
  int exit_code = 0;
  std::string error;  ///< empty where it was done
};

/// A file as the store knows it.
struct StoredFile {
  std::string recording;  ///< the result's key; empty where the file could not be read
  std::string name;       ///< that the recording states
  StoredResult result;
  std::vector<InputFile> inputs;  ///< of the result, paths from the recording's folder
};

/// What becomes of results that a store has already.
enum class Known { Keep, Replace };

/// Results of many recordings in a database. Everything written is written whole or not at all, whoever else
/// writes. docs/store.md describes the tables.
class Store {
 public:
  /// Makes or brings up to date what is to be written to.
  static Expected<Store> open(const std::string& where, Database::Access access,
                              int lock_wait_seconds = Database::lock_wait);

  /// Nothing where the store does not know the path.
  Expected<std::optional<StoredFile>> file(const std::string& path);
  Expected<std::optional<StoredResult>> result(const std::string& recording);

  /// In one transaction.
  Expected<void> write(const std::vector<StoreEntry>& entries, Known known);

  /// Removes the paths of results in `entries` at which no file is any more, beside the one in the entry itself: the
  /// recording was moved. For the store of this computer's files.
  Expected<void> forget_moved(const std::vector<StoreEntry>& entries);

  /// Removes the rows of these paths, in one transaction; the results stay.
  Expected<void> forget(const std::vector<std::string>& paths);

  /// Adds everything that another store holds. What is in both stays as it is, files take what the other says.
  /// The same again changes nothing.
  Expected<void> merge(Store& other);

  /// Every row but of `stored`, one a line as JSON, in an order that depends on the content alone: the same results
  /// give the same bytes, whatever wrote them in whatever order to whatever database. The content of one moment; on
  /// SQLite others cannot write until it is done.
  Expected<void> dump(const std::function<void(std::string_view)>& take);

  /// What `read` asks of this store is all answered as of one moment.
  Expected<void> in_snapshot(const std::function<void()>& read);
  Expected<std::vector<StoreRow>> rows(const std::string& sql, const StoreRow& values = {});
  [[nodiscard]] const std::string& name() const { return database_.name(); }

 private:
  explicit Store(Database database) : database_(std::move(database)) {}
  void insert(StoreTable table, const std::vector<StoreRow>& rows, Known known);

  Database database_;
};

}  // namespace artcal
