#include "app/batch/shard.h"

#include <algorithm>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "app/batch/find_recordings.h"

namespace artcal {
namespace {

using Variables = std::map<std::string, std::string>;

std::string shard_of(const std::string& text, const Variables& variables = {}) {
  const auto shard = parse_shard(text, [&](const char* name) -> const char* {
    const auto found = variables.find(name);
    return found == variables.end() ? nullptr : found->second.c_str();
  });
  return shard ? std::to_string(shard->index) + " of " + std::to_string(shard->count) : "refused";
}

TEST(Shard, CountsFromOneToPeople) {
  EXPECT_EQ(shard_of(""), "0 of 1");
  EXPECT_EQ(shard_of("1/8"), "0 of 8");
  EXPECT_EQ(shard_of("8/8"), "7 of 8");
  for (const char* text : {"0/8", "9/8", "8", "/8", "8/", "-1/8", "1/8/2", "1.0/8", "1/99999999"}) {
    EXPECT_EQ(shard_of(text), "refused") << text;
  }
}

TEST(Shard, IsTakenFromASlurmArray) {
  const auto array = [](const char* id, const char* first, const char* count) {
    return Variables{{"SLURM_ARRAY_TASK_ID", id}, {"SLURM_ARRAY_TASK_MIN", first}, {"SLURM_ARRAY_TASK_COUNT", count}};
  };
  EXPECT_EQ(shard_of("", array("0", "0", "8")), "0 of 8");
  EXPECT_EQ(shard_of("", array("8", "1", "8")), "7 of 8");
  EXPECT_EQ(shard_of("", array("14", "0", "8")), "refused") << "an array in steps of two";
  EXPECT_EQ(shard_of("", array("x", "0", "8")), "refused");
  EXPECT_EQ(shard_of("", {{"SLURM_ARRAY_TASK_ID", "3"}}), "refused") << "of how many?";
  EXPECT_EQ(shard_of("2/3", array("0", "0", "8")), "1 of 3") << "what is said goes before";
}

TEST(Shard, TogetherTheyAreAllAndApartTheyShareNothing) {
  std::vector<std::string> files;
  for (int i = 0; i < 1000; ++i) {
    files.push_back("/archive/" + std::to_string(i) + "/recording.toml");
  }
  std::map<std::string, int> seen;
  for (int i = 0; i < 8; ++i) {
    const auto part = part_of(files, i, 8);
    EXPECT_GT(part.size(), 80u);
    EXPECT_LT(part.size(), 170u);
    for (const std::string& file : part) {
      ++seen[file];
    }
  }
  EXPECT_EQ(seen.size(), files.size());
  // Which part a file is in does not depend on the others.
  EXPECT_EQ(part_of({files[7]}, 3, 8).size(),
            static_cast<std::size_t>(std::ranges::count(part_of(files, 3, 8), files[7])));
}

TEST(FindRecordings, AListNamesEachOnceInOrder) {
  std::istringstream list("/b/recording.toml\n\n/a/recording.toml\n/b/./recording.toml\n");
  const auto found = find_recordings({"-"}, list);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->files, (std::vector<std::string>{"/a/recording.toml", "/b/recording.toml"}));
}

}  // namespace
}  // namespace artcal
