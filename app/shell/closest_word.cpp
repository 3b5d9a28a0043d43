#include "app/shell/closest_word.h"

#include <algorithm>

#include <fmt/format.h>

namespace artcal {
namespace {

constexpr std::size_t max_length = 64;  // a longer word is none of ours

std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

}  // namespace

std::optional<std::string> closest_word(std::string_view typed, const std::vector<std::string>& words) {
  if (typed.empty() || typed.size() > max_length) {
    return std::nullopt;
  }
  const std::string* best = nullptr;
  std::size_t least = 0;
  for (const std::string& word : words) {
    const std::size_t changes = distance(typed, word);
    if (changes <= std::max<std::size_t>(1, word.size() / 3) && (best == nullptr || changes < least)) {
      best = &word;
      least = changes;
    }
  }
  if (best != nullptr) {
    return *best;
  }
  const auto begins = [&](const std::string& word) { return word.starts_with(typed); };
  return std::count_if(words.begin(), words.end(), begins) == 1
             ? std::optional(*std::find_if(words.begin(), words.end(), begins))
             : std::nullopt;
}

std::string did_you_mean(std::string_view typed, const std::vector<std::string>& words) {
  const auto word = closest_word(typed, words);
  return word ? fmt::format("; did you mean {}?", *word) : "";
}

}  // namespace artcal
