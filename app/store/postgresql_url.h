#pragma once

#include <string>

#include "core/error.h"

namespace artcal {

/// A store on a PostgreSQL server.
struct PostgresqlPlace {
  /// For libpq: every part as a parameter, percent-encoded, as postgresql:///?host=…&user=…
  std::string connection;
  /// For messages: the URL without what is secret in it.
  std::string shown;
};

/// Whether the text begins with postgresql:// or postgres://, in whatever letters.
bool is_postgresql_url(const std::string& where);

/// Takes a URL of libpq's form apart (PostgreSQL 15, 34.1.1.2):
///
///     postgresql://[user[:password]@][host[:port]][,…][/database][?name=value[&…]]
///
/// with %XX for any character, and IPv6 addresses in square brackets. Refused as wrong usage, without a word of the URL
/// in the message, for where its password begins and ends is not certain then: a second @, one behind the first /, a
/// port that is no number, a % without two hexadecimal digits, a bracket that is not closed, a parameter without =.
/// REQUIRES: is_postgresql_url(url).
Expected<PostgresqlPlace> parse_postgresql_url(const std::string& url);

}  // namespace artcal
