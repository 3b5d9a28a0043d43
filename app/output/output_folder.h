#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/error.h"

namespace artcal {

/// A folder's files: names without separators, and their text.
using FolderFiles = std::vector<std::pair<std::string, std::string>>;

/// Whether write_folder() would refuse, said before the work is done.
Expected<void> check_folder(const std::string& path, const FolderFiles& files, bool overwrite);

/// Writes a folder with these files whole or not at all: under a temporary name beside it, flushed to disk,
/// then renamed. A folder that is there already is refused, unless it is empty or `overwrite` is set. Then the
/// two change places in one step and the old one goes; but one that holds anything beside files of these
/// names is refused all the same: what is not ours is not ours to remove.
Expected<void> write_folder(const std::string& path, const FolderFiles& files, bool overwrite);

}  // namespace artcal
