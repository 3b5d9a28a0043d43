#include "artefacts/constraints/read_constraints.h"

#include <functional>

#include <fmt/format.h>

#include "artefacts/artefact/artefact_file.h"
#include "artefacts/constraints/coincident_readings.h"
#include "artefacts/constraints/constraint.h"
#include "artefacts/scans/scan_readings.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

using ReadArtefact = std::function<Expected<ArtefactFile>(const std::filesystem::path&)>;

Expected<Constraints> read_with(Recording& recording, const ScanSelection& selection,
                                const ReadArtefact& read_artefact) {
  if (recording.artefact_paths.empty()) {
    return bad_input("the recording names no artefact, expected artefacts = [\"artefact.toml\"]",
                     recording.inputs.empty() ? "" : recording.inputs.front().path);
  }
  std::vector<Artefact> artefacts;
  for (const auto& path : recording.artefact_paths) {
    auto file = read_artefact(path);
    if (!file) {
      return tl::unexpected(file.error());
    }
    for (const auto& other : artefacts) {
      if (other.name == file->artefact.name) {
        return bad_input(fmt::format("two artefacts of this recording are called {}", in_quotes(other.name)), path);
      }
    }
    recording.inputs.push_back(file->input);
    if (file->certificate) {
      recording.inputs.push_back(*file->certificate);
    }
    artefacts.push_back(std::move(file->artefact));
  }
  if (auto read = read_scans(recording, artefacts, selection); !read) {
    return tl::unexpected(read.error());
  }
  drop_coincident_readings(recording, artefacts);
  return build_constraints(recording, std::move(artefacts));
}

}  // namespace

Expected<Constraints> read_constraints(Recording& recording) { return read_constraints(recording, ScanSelection{}); }

Expected<Constraints> read_constraints(Recording& recording, const ScanSelection& selection) {
  return read_with(recording, selection, [](const auto& path) { return read_artefact_file(path); });
}

Expected<Constraints> read_constraints(Recording& recording, const FileAccess& access, const ScanSelection& selection) {
  return read_with(recording, selection, [&](const auto& path) { return read_artefact_file(path, access); });
}

}  // namespace artcal
