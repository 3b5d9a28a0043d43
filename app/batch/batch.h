#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/batch/report_pages.h"
#include "app/batch/run_recording.h"
#include "app/store/store.h"

namespace artcal {

struct BatchRequest {
  BatchOptions options;
  bool resume = false;                      ///< leave alone what the store has a result of
  const ReportPages* pages = nullptr;       ///< where every result has a page written; null: nowhere
  const std::atomic<bool>* stop = nullptr;  ///< set: begin no more recordings, and write what is done; or null
  int jobs = 0;  ///< at once; 0: as many as the machine has cores. The store does not depend on it
};

/// What became of a batch.
struct BatchSummary {
  std::size_t files = 0;                     ///< = done + known + failed + not_reached
  std::size_t done = 0;                      ///< now, and not failed
  std::size_t identified = 0, verified = 0;  ///< of these
  std::size_t known = 0;                     ///< left alone: the store had the result, which is no failure
  std::size_t not_shown = 0;                 ///< verified, and conformity was not shown
  std::size_t failed = 0;                    ///< now or before
  std::size_t not_reached = 0;               ///< stopped before them
  std::size_t unreadable_folders = 0;
  std::size_t pages = 0;  ///< reports written
  int exit_code = 0;      ///< 3 where a file was refused or a report could not be written, else 4 where one had no
                          ///< solution, else 1 where one was not shown
  std::vector<RecordingOutcome> failures;  ///< in the order of the files, without their rows; at most most_listed
  static constexpr std::size_t max_listed = 1000;
  std::map<std::string, std::string> page_errors;  ///< by path: why there is no report
  std::map<std::string, std::string> not_stored;   ///< by path: failures that the store has no row of

  /// Notes folders that could not be searched among the failures; they are no recordings.
  void note_unreadable(const std::vector<Error>& folders);
};

/// Runs every file and writes what becomes of it to the store, some at a time: a run that is killed has lost nothing
/// but the last of them. `tell` hears of every outcome as it comes, one call at a time. Refused: what the store
/// refuses; what was written before stays.
Expected<BatchSummary> run_batch(const std::vector<std::string>& files, const BatchRequest& request, Store& store,
                                 const std::function<void(const RecordingOutcome&)>& tell);

}  // namespace artcal
