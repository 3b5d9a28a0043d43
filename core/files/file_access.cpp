#include "core/files/file_access.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/files/size_limits.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

namespace fs = std::filesystem;

// Absolute, without links, "." and "..", as far as the path exists.
fs::path resolved(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path.empty() ? fs::path(".") : path, error);
  const fs::path found = fs::weakly_canonical(absolute, error);
  const fs::path normal = (error ? absolute : found).lexically_normal();
  return normal.has_filename() ? normal : normal.parent_path();
}

bool is_below(const fs::path& file, const fs::path& folder) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end == folder.end();
}

}  // namespace

FileAccess FileAccess::anywhere() {
  FileAccess access;
  access.anywhere_ = true;
  return access;
}

FileAccess FileAccess::beside(const fs::path& file) {
  const fs::path folder = resolved(file.parent_path());
  const fs::path parent = folder.parent_path();
  return below({parent.has_relative_path() ? parent : folder});
}

FileAccess FileAccess::below(const std::vector<fs::path>& folders) {
  FileAccess access;
  std::transform(folders.begin(), folders.end(), std::back_inserter(access.folders_), resolved);
  return access;
}

bool FileAccess::allows(const fs::path& file) const {
  return anywhere_ || std::any_of(folders_.begin(), folders_.end(), [target = resolved(file)](const fs::path& folder) {
           return is_below(target, folder);
         });
}

Expected<fs::path> FileAccess::resolve(const fs::path& folder, std::string_view name, const std::string& where) const {
  if (name.size() > largest::path || name.find('\0') != std::string_view::npos) {
    return bad_input(fmt::format("{} is no name that a file can have", in_quotes(name)), where);
  }
  fs::path file = folder / name;
  if (!allows(file)) {
    return bad_input(
        fmt::format("the file {} is neither in the folder of the file that names it nor beside that folder; "
                    "copy it there, or add --allow-outside if you trust the file that names it",
                    in_quotes(name)),
        where);
  }
  return file;
}

}  // namespace artcal
