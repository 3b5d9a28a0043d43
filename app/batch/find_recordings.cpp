#include "app/batch/find_recordings.h"

#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "app/store/postgresql_url.h"
#include "core/files/hash.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

namespace fs = std::filesystem;

std::string normal(const fs::path& path) {
  std::error_code ignored;
  return fs::absolute(path, ignored).lexically_normal().string();
}

bool says_recording(const fs::path& path) {
  constexpr std::size_t beginning = 64 * 1024;
  std::string text(beginning, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  return text.find("artcal-recording/") != std::string::npos;
}

bool is_recording(const fs::path& path) {
  const std::string name = path.filename().string();
  return name == "recording.toml" || name.ends_with("-recording.toml") ||
         (path.extension() == ".toml" && says_recording(path));
}

// Every folder below is tried, whatever becomes of the others. Links to folders are not followed: they may lead back.
void search(const fs::path& top, FoundRecordings& found) {
  std::vector<fs::path> folders{top};
  while (!folders.empty()) {
    const fs::path folder = std::move(folders.back());
    folders.pop_back();
    std::error_code error;
    for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator(); at.increment(error)) {
      std::error_code ignored;
      if (fs::is_directory(at->symlink_status(ignored))) {
        folders.push_back(at->path());
      } else if (at->is_regular_file(ignored) && is_recording(at->path())) {
        found.files.push_back(normal(at->path()));
      }
    }
    if (error) {
      found.unreadable.push_back(
          {ErrorCode::BadInput, "the folder cannot be read: " + error.message(), normal(folder)});
    }
  }
}

std::vector<std::string> matches_of(const std::string& pattern) {
  glob_t matches{};
  std::vector<std::string> paths;
  if (::glob(pattern.c_str(), 0, nullptr, &matches) == 0) {
    paths.assign(matches.gl_pathv, matches.gl_pathv + matches.gl_pathc);
  }
  ::globfree(&matches);
  return paths;
}

Expected<void> take(const std::string& named, FoundRecordings& found) {
  std::error_code ignored;
  if (is_postgresql_url(named)) {
    return wrong_usage("the address of a server was given as a path; a store is named with --store");
  }
  if (fs::is_directory(named, ignored)) {
    found.folders.push_back(normal(named));
    search(named, found);
    return {};
  }
  if (!fs::exists(named, ignored) && named.find_first_of("*?[") != std::string::npos) {
    const auto matches = matches_of(named);
    if (matches.empty()) {
      return bad_input("nothing matches this pattern", in_quotes(named));
    }
    for (const std::string& match : matches) {
      if (auto taken = take(match, found); !taken) {
        return taken;
      }
    }
    return {};
  }
  found.files.push_back(normal(named));
  return {};
}

}  // namespace

Expected<FoundRecordings> find_recordings(const std::vector<std::string>& named, std::istream& list) {
  std::vector<std::string> all;
  for (const std::string& name : named) {
    if (name != "-") {
      all.push_back(name);
      continue;
    }
    for (std::string line; std::getline(list, line);) {
      if (!line.empty()) {
        all.push_back(line);
      }
    }
  }
  FoundRecordings found;
  for (const std::string& name : all) {
    if (auto taken = take(name, found); !taken) {
      return tl::unexpected(taken.error());
    }
  }
  std::sort(found.files.begin(), found.files.end());
  found.files.erase(std::unique(found.files.begin(), found.files.end()), found.files.end());
  std::sort(found.unreadable.begin(), found.unreadable.end(),
            [](const Error& a, const Error& b) { return a.where < b.where; });
  if (found.files.empty()) {
    return found.unreadable.empty()
               ? bad_input(
                     "no recording was found; a folder's recordings are the files in it called recording.toml, and "
                     "other .toml files with schema = \"artcal-recording/1\"")
               : bad_input("no recording was found, and " + found.unreadable.front().message,
                           found.unreadable.front().where);
  }
  return found;
}

std::vector<std::string> part_of(const std::vector<std::string>& files, int shard, int count) {
  std::vector<std::string> part;
  for (const std::string& file : files) {
    const unsigned long place = std::stoul(sha256(file).substr(0, 8), nullptr, 16);
    if (place % static_cast<unsigned long>(count) == static_cast<unsigned long>(shard)) {
      part.push_back(file);
    }
  }
  return part;
}

}  // namespace artcal
