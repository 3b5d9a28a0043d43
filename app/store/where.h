#pragma once

#include <string>

#include "core/error.h"

namespace artcal {

/// What the name of a store means.
struct StorePlace {
  bool is_postgresql = false;
  std::string file;  ///< absolute; empty for PostgreSQL
  std::string name;  ///< for messages: the path as given, or the URL without its password
};

/// "postgresql://…" and "postgres://…" are servers; "sqlite:PATH" and anything else is a file. Refused as wrong
/// usage: an empty name, another URL, a path that SQLite's driver cannot be told.
Expected<StorePlace> understand_store(const std::string& where);

/// The file that a store is in, which nothing else may be written over; empty for a server and what is no store.
std::string file_of_store(const std::string& where);

}  // namespace artcal
