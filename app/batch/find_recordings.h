#pragma once

#include <istream>
#include <string>
#include <vector>

#include "core/error.h"

namespace artcal {

/// What was found for the paths that a user named.
struct FoundRecordings {
  std::vector<std::string> files;    ///< absolute and normal, each once, in the order of their bytes
  std::vector<std::string> folders;  ///< that were searched
  std::vector<Error> unreadable;     ///< folders that could not be read; the others have been
};

/// A folder stands for all recordings below it: files called recording.toml or …-recording.toml, and other .toml files
/// that say "artcal-recording/" in their beginning. A pattern with *, ? or [ that is no file stands for what it
/// matches, "-" for the lines of `list`, and anything else for itself, whether it is there or not: that a file
/// cannot be read is found when it is. Refused: nothing at all.
Expected<FoundRecordings> find_recordings(const std::vector<std::string>& named, std::istream& list);

/// The part `shard` of `count` (from 0) of the files. By their names alone, so that it does not matter which other
/// files are there.
std::vector<std::string> part_of(const std::vector<std::string>& files, int shard, int count);

}  // namespace artcal
