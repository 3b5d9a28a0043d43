#include "app/batch/batch_options.h"

#include <algorithm>

namespace artcal {

FileAccess BatchOptions::access_of(const std::filesystem::path& recording) const {
  if (anywhere) {
    return FileAccess::anywhere();
  }
  std::vector<std::filesystem::path> searched;
  for (const std::string& folder : folders) {
    if (FileAccess::below({folder}).allows(recording)) {
      searched.emplace_back(folder);
    }
  }
  // One that is in none of them has been named itself.
  return searched.empty() ? FileAccess::beside(recording) : FileAccess::below(searched);
}

}  // namespace artcal
