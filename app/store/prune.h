#pragma once

#include <string>
#include <vector>

#include "app/store/store.h"

namespace artcal {

/// A recording's path in a store at which no file is any more.
struct VanishedFile {
  std::string path, name;  ///< the name that the recording stated; empty where it could not be read
  std::string now_at;      ///< another path of the same content; empty: the recording vanished
};

/// Paths of the store at which no file is, in order. A path whose folder's file system is not reachable counts as well:
/// a person looks at the list before anything is removed.
Expected<std::vector<VanishedFile>> vanished_files(Store& store);

/// Removes their rows of `files`, in one transaction. The results stay: what rested on a certificate can still be
/// asked.
Expected<void> remove_files(Store& store, const std::vector<VanishedFile>& files);

}  // namespace artcal
