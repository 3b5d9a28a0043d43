#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace artcal {

/// A value of a row; the first is NULL.
using StoreValue = std::variant<std::monostate, long long, double, std::string>;
using StoreRow = std::vector<StoreValue>;

/// Empty for a value that is no text.
std::string text_or_empty(const StoreValue& value);

enum class ColumnKind { Text, Whole, Real };

struct StoreColumn {
  const char* name;
  ColumnKind kind;
};

/// The tables of a store, those that others refer to first. docs/store.md says what they hold.
enum class StoreTable {
  Arms,
  Artefacts,
  Certificates,
  Recordings,
  Inputs,
  UsedCertificates,
  Identifications,
  Parameters,
  Verifications,
  VerificationValues,
  Remarks,
  Files,
  Stored,
};
inline constexpr std::size_t store_table_count = 13;

struct TableShape {
  const char* name;
  std::vector<StoreColumn> columns;  ///< as in the migrations
  std::size_t keys;                  ///< the first so many columns are the primary key
};
const TableShape& shape_of(StoreTable table);

/// Rows by StoreTable.
struct StoreRows {
  std::array<std::vector<StoreRow>, store_table_count> tables;

  std::vector<StoreRow>& operator[](StoreTable table) { return tables[static_cast<std::size_t>(table)]; }
  const std::vector<StoreRow>& operator[](StoreTable table) const { return tables[static_cast<std::size_t>(table)]; }
};

}  // namespace artcal
