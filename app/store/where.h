#pragma once

#include <string>

#include "core/error.h"

namespace artcal {

/// What the name of a store means.
struct StorePlace {
  bool is_postgresql = false;
  std::string file;        ///< absolute; empty for PostgreSQL
  std::string name;        ///< for messages: the path as given, or the URL without its password
  std::string connection;  ///< for libpq; empty for a file
};

/// "postgresql://…" and "postgres://…" are servers; "sqlite:PATH" and anything else is a file. Refused as wrong
/// usage: an empty name, another URL, parameters of libpq that are no URL, a path that SQLite's driver cannot be
/// determined. No message shows what may be a password.
Expected<StorePlace> parse_store(const std::string& where);

/// The file that a store is in, which nothing else may be written over; empty for a server and what is no store.
std::string file_of_store(const std::string& where);

/// The text with every URL of a PostgreSQL server in it, up to a blank or a quote, as messages show it: without its
/// password, and as "postgresql://***" where it is not certain what of it is the password.
std::string without_passwords(const std::string& text);

/// Overwrites passwords in the arguments of this process, which everybody on this computer can list. The arguments must
/// have been read before.
void hide_passwords(int argc, char** argv);

}  // namespace artcal
