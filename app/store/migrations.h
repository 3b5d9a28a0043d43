#pragma once

#include <string>
#include <vector>

#include "app/store/database.h"

namespace artcal {

/// A step of the schema: app/store/migrations/NUMBER-NAME.sql, compiled in. One that has been released is never
/// changed; another is added.
struct Migration {
  std::string name;  ///< "001-results"
  std::string sql;
};

/// In their order; the first is number 1.
const std::vector<Migration>& store_migrations();

/// Brings the schema up to date, whole or not at all. Refused: a database of something else, a store that a later
/// version of artcal has written.
Expected<void> migrate(Database& database);

/// Refused: a database that is no store of this version's schema.
Expected<void> check_schema(Database& database);

}  // namespace artcal
