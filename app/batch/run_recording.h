#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/batch/batch_options.h"
#include "app/report/result_file.h"
#include "app/store/store.h"

namespace artcal {

/// What became of a recording file.
struct RecordingOutcome {
  std::string path;
  int exit_code = 0;  ///< as of `artcal identify` and `artcal verify` on it
  std::string error;  ///< one sentence, paths from the recording's folder; empty where it was done
  bool identified = false, verified = false;
  bool was_known = false;  ///< the store has the result already
  StoreEntry entry;
  std::vector<ReportedResult> results;  ///< for a report, where asked for: without a trace of where the recording lies
  std::string page_error;               ///< why its report could not be written; empty where none was asked for
};

/// Whether the results themselves are wanted beside their rows.
enum class Keep { Rows, RowsAndResults };

/// What a store knows of a result of this name, if it has one.
using FindResult = std::function<std::optional<StoredResult>(const std::string& recording)>;

/// Reads a recording and does what it asks for. Never fails: what goes wrong is an outcome. `find` is asked before
/// anything is computed; an empty one is not.
/// A file that changes from the first look at it to the last is refused: the result may be of half a file.
RecordingOutcome run_recording(const std::string& path, const BatchOptions& options, const FindResult& find,
                               Keep keep = Keep::Rows);

/// The outcome of a file whose result the store has, with the inputs it has now; nothing where they differ.
std::optional<RecordingOutcome> known_outcome(const std::string& path, const StoredFile& file,
                                              const BatchOptions& options);

}  // namespace artcal
