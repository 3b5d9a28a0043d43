#include "app/requests/recording_request.h"

#include <utility>

#include "acquisition/recording/recording_file.h"
#include "app/output/output.h"
#include "app/requests/referenced_files.h"

namespace artcal {

void RecordingRequest::add_path_to(CLI::App& parser) {
  parser.add_option("recording", path, "recording.toml")->required()->type_name("RECORDING");
}

Expected<Recording> RecordingRequest::read() const { return read_recording(path, access()); }

Expected<BoundRecording> RecordingRequest::bind(Recording recording) const {
  return bind_recording(std::move(recording), access(), options.scans());
}

Expected<BoundRecording> RecordingRequest::read_bound() const {
  return read().and_then([&](Recording&& recording) { return bind(std::move(recording)); });
}

Expected<void> RecordingRequest::check_outputs(const std::vector<std::string>& outputs,
                                               const Recording& recording) const {
  return artcal::check_outputs(outputs, referenced_files(recording, access()));
}

}  // namespace artcal
