#include "core/text/name_list.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::size_t max_listed = 12;
constexpr std::size_t farthest = 2;
constexpr std::size_t longest = 80;  // of names that are compared

// Levenshtein's distance, row by row.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t exchanged = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, exchanged}));
    }
  }
  return row.back();
}

}  // namespace

std::string listed_names(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(max_listed, names.size()); ++i) {
    text += (i > 0 ? ", " : "") + in_quotes(names[i]);
  }
  return names.empty()                ? "none"
         : names.size() <= max_listed ? text
                                      : fmt::format("{} and {} more", text, names.size() - max_listed);
}

std::string nearest_name(std::string_view misspelt, const std::vector<std::string>& names) {
  std::string nearest;
  std::size_t least = farthest + 1;
  for (const std::string& name : names) {
    if (std::max(name.size(), misspelt.size()) > longest) {
      continue;
    }
    const std::size_t off = distance(misspelt, name);
    if (off < least && 2 * off < std::max(misspelt.size(), name.size())) {
      least = off;
      nearest = name;
    }
  }
  return nearest;
}

}  // namespace artcal
