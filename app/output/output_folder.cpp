#include "app/output/output_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include <fmt/format.h>

#include "app/output/file_mode.h"
#include "app/output/output.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> cannot_write_folder(const std::string& path) {
  return bad_input(fmt::format("the folder cannot be written: {}", std::strerror(errno)), path);
}

// "out/" means "out": what is renamed has no slash at its end.
std::string without_slash(std::string path) {
  while (path.size() > 1 && path.ends_with('/')) {
    path.pop_back();
  }
  return path;
}

Expected<void> fill(const std::string& folder, const FolderFiles& files) {
  for (const auto& [name, text] : files) {
    if (auto written = write_file(folder + "/" + name, text); !written) {
      return written;
    }
  }
  return {};
}

// Renames, in one step, also where a folder is there to be replaced; the old one is then under the first name.
bool put_in_place(const std::string& temporary, const std::string& target) {
  if (fs::exists(target)) {
    return ::renameat2(AT_FDCWD, temporary.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) == 0;
  }
  return std::rename(temporary.c_str(), target.c_str()) == 0;
}

}  // namespace

Expected<void> check_folder(const std::string& path, const FolderFiles& files, bool overwrite) {
  std::error_code error;
  const auto status = fs::symlink_status(without_slash(path), error);
  if (!fs::exists(status)) {
    const fs::path parent = fs::absolute(without_slash(path), error).parent_path();
    return fs::is_directory(parent, error)
               ? Expected<void>()
               : bad_input(fmt::format("there is no folder {} to write this folder in", in_quotes(parent.string())),
                           path);
  }
  if (!fs::is_directory(status)) {
    return bad_input("this is there and no folder, expected the name of a folder to write", path);
  }
  for (fs::directory_iterator entry(path, error); !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const bool ours = std::any_of(files.begin(), files.end(), [&](const auto& file) { return file.first == name; });
    if (!overwrite || !ours || entry->is_directory(error)) {
      return bad_input(overwrite ? fmt::format("the folder holds {}, which is none of the files to be written; name "
                                               "another folder, or clear this one",
                                               in_quotes(name))
                                 : std::string("the folder is there already; name another one, or add --force to "
                                               "replace it"),
                       path);
    }
  }
  if (error) {
    return bad_input(fmt::format("the folder cannot be read: {}", error.message()), path);
  }
  return {};
}

Expected<void> write_folder(const std::string& path, const FolderFiles& files, bool overwrite) {
  if (auto checked = check_folder(path, files, overwrite); !checked) {
    return checked;
  }
  const std::string target = without_slash(path);
  std::string temporary = target + ".XXXXXX";
  if (::mkdtemp(temporary.data()) == nullptr) {
    return cannot_write_folder(path);
  }
  std::error_code ignored;
  auto written = fill(temporary, files);
  if (written && (::chmod(temporary.c_str(), file_mode(0777)) != 0 || !put_in_place(temporary, target))) {
    written = cannot_write_folder(path);
  }
  fs::remove_all(temporary, ignored);
  return written;
}

}  // namespace artcal
