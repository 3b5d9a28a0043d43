#include "app/store/prune.h"

#include <filesystem>
#include <map>

namespace artcal {
namespace {

bool is_there(const std::string& path) {
  std::error_code error;
  // A path that is not UTF-8 stands in the store in other characters (stored_text.h): nothing is known of it.
  return path.find("\\x") != std::string::npos || std::filesystem::exists(path, error) || error;
}

}  // namespace

Expected<std::vector<VanishedFile>> vanished_files(Store& store) {
  const auto rows = store.rows(
      "SELECT f.path, f.recording, r.name FROM files f LEFT JOIN recordings r ON r.recording = f.recording ORDER BY "
      "f.path");
  if (!rows) {
    return tl::unexpected(rows.error());
  }
  std::map<std::string, std::string> places;  // of a recording: a path that is there
  std::vector<const StoreRow*> gone;
  for (const StoreRow& row : *rows) {
    const std::string recording = text_or_empty(row[1]);
    if (!is_there(text_or_empty(row[0]))) {
      gone.push_back(&row);
    } else if (!recording.empty()) {
      places.emplace(recording, text_or_empty(row[0]));
    }
  }
  std::vector<VanishedFile> files;
  for (const StoreRow* row : gone) {
    const auto place = places.find(text_or_empty((*row)[1]));
    files.push_back({text_or_empty((*row)[0]), text_or_empty((*row)[2]), place == places.end() ? "" : place->second});
  }
  return files;
}

Expected<void> remove_files(Store& store, const std::vector<VanishedFile>& files) {
  std::vector<std::string> paths;
  for (const VanishedFile& file : files) {
    paths.push_back(file.path);
  }
  return store.forget(paths);
}

}  // namespace artcal
