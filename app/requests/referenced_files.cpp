#include "app/requests/referenced_files.h"

#include <algorithm>

#include "artefacts/artefact/artefact_file.h"

namespace artcal {

std::vector<InputFile> referenced_files(const Recording& recording, const FileAccess& access) {
  std::vector<InputFile> files = recording.inputs;
  const auto has = [&](const std::string& path) {
    return std::any_of(files.begin(), files.end(), [&](const InputFile& file) { return file.path == path; });
  };
  for (const RecordedScan& scan : recording.scans) {
    files.push_back({scan.path, ""});
  }
  if (!recording.specification_path.empty()) {
    files.push_back({recording.specification_path, ""});
  }
  for (const std::string& path : recording.artefact_paths) {
    if (has(path)) {
      continue;  // and so is its certificate
    }
    files.push_back({path, ""});
    // An artefact that cannot be read is no error here: this command may not need it.
    if (const auto artefact = read_artefact_file(path, access); artefact && artefact->certificate) {
      files.push_back(*artefact->certificate);
    }
  }
  return files;
}

}  // namespace artcal
