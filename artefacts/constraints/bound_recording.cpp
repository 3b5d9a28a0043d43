#include "artefacts/constraints/bound_recording.h"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "artefacts/artefact/artefact_file.h"
#include "artefacts/constraints/coincident_readings.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// Notes the files as inputs of the recording.
Expected<std::vector<Artefact>> read_artefacts(Recording& recording, const FileAccess& access) {
  if (recording.artefact_paths.empty()) {
    return bad_input("the recording names no artefact, expected artefacts = [\"artefact.toml\"]",
                     recording.inputs.empty() ? "" : recording.inputs.front().path);
  }
  std::vector<Artefact> artefacts;
  for (const auto& path : recording.artefact_paths) {
    auto file = read_artefact_file(path, access);
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
  return artefacts;
}

Expected<Constraints> bind(Recording& recording, const FileAccess& access, const ScanSelection& selection) {
  auto artefacts = read_artefacts(recording, access);
  if (!artefacts) {
    return tl::unexpected(artefacts.error());
  }
  if (auto read = read_scans(recording, *artefacts, selection); !read) {
    return tl::unexpected(read.error());
  }
  drop_coincident_readings(recording, *artefacts);
  return build_constraints(recording, std::move(*artefacts));
}

}  // namespace

Expected<BoundRecording> bind_recording(Recording recording, const ScanSelection& selection) {
  return bind_recording(std::move(recording), FileAccess::anywhere(), selection);
}

Expected<BoundRecording> bind_recording(Recording recording, const FileAccess& access, const ScanSelection& selection) {
  auto constraints = bind(recording, access, selection);
  if (!constraints) {
    return tl::unexpected(with_warnings(std::move(constraints.error()), recording.warnings));
  }
  return BoundRecording{std::move(recording), std::move(*constraints)};
}

}  // namespace artcal
