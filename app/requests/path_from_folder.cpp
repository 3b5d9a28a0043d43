#include "app/requests/path_from_folder.h"

#include <filesystem>

namespace artcal {

std::string path_from_folder(const std::string& path, const std::string& folder) {
  namespace fs = std::filesystem;
  if (fs::path(path).is_absolute()) {
    return path;
  }
  std::error_code ignored;
  const fs::path relative = fs::relative(path, fs::absolute(folder, ignored), ignored);
  return relative.empty() ? fs::absolute(path, ignored).string() : relative.string();
}

}  // namespace artcal
