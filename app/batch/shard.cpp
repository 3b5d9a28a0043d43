#include "app/batch/shard.h"

#include <charconv>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr int max_shards = 1'000'000;

std::optional<int> parsed_whole(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

Expected<Shard> of_slurm(const std::function<const char*(const char*)>& variable) {
  const auto number = [&](const char* name) {
    const char* text = variable(name);
    return text != nullptr ? parsed_whole(text) : std::nullopt;
  };
  if (variable("SLURM_ARRAY_TASK_ID") == nullptr) {
    return Shard{};
  }
  const auto id = number("SLURM_ARRAY_TASK_ID");
  const auto count = number("SLURM_ARRAY_TASK_COUNT");
  const int first = number("SLURM_ARRAY_TASK_MIN").value_or(0);
  if (!id || !count || *count < 1 || *id < first || *id - first >= *count) {
    return wrong_usage(
        "this is a task of a Slurm job array, but SLURM_ARRAY_TASK_ID, _MIN and _COUNT do not say which of how many; "
        "use an array without gaps, such as --array=0-7, or say --shard 3/8");
  }
  return Shard{*id - first, *count};
}

}  // namespace

Expected<Shard> parse_shard(const std::string& text, const std::function<const char*(const char*)>& variable) {
  if (text.empty()) {
    return of_slurm(variable);
  }
  const std::size_t slash = text.find('/');
  const std::string_view after = slash == std::string::npos ? "" : std::string_view(text).substr(slash + 1);
  const int index = parsed_whole(std::string_view(text).substr(0, slash)).value_or(0);
  const int count = parsed_whole(after).value_or(0);
  if (index < 1 || count < index || count > max_shards) {
    return wrong_usage(fmt::format("{} is no shard, expected such as 3/8: the third of eight", in_quotes(text)));
  }
  return Shard{index - 1, count};
}

}  // namespace artcal
