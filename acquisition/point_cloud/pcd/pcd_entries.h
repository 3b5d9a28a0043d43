#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace artcal {

/// What stands behind one keyword of a PCD header, and where.
struct PcdEntry {
  std::vector<std::string_view> values;
  std::string where;  ///< "file:line"
};

/// The lines of a PCD header by their keyword, up to and with DATA; their meaning is not looked at.
struct PcdEntries {
  std::map<std::string_view, PcdEntry> by_keyword;
  std::size_t body = 0;  ///< offset of the first byte after the DATA line
  int lines = 0;         ///< up to and with the DATA line

  [[nodiscard]] bool contains(std::string_view keyword) const { return by_keyword.contains(keyword); }
  /// REQUIRES: contains(keyword).
  [[nodiscard]] const PcdEntry& at(std::string_view keyword) const { return by_keyword.at(keyword); }
};

/// Whether the bytes begin as a PCD does.
bool looks_like_pcd(std::string_view bytes);

/// Refused: a keyword that PCD does not have, or twice; SIZE, TYPE, DATA or the fields' names missing. The
/// bytes must outlive the entries.
Expected<PcdEntries> read_pcd_entries(std::string_view bytes, const std::string& path);

}  // namespace artcal
