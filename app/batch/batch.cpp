#include "app/batch/batch.h"

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <mutex>
#include <optional>
#include <thread>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>

#include "core/parallel.h"

namespace artcal {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t written_at_once = 64;
constexpr std::chrono::milliseconds longest_unwritten{500};

// One recording's matrices are given back just before the next one's are asked for: the C library is told to keep up to
// this much of it in each thread, because the kernel clears every page that it hands out again.
void keep_freed_memory() {
  constexpr int bytes = 32 << 20;
  ::mallopt(M_MMAP_THRESHOLD, bytes);
  ::mallopt(M_TRIM_THRESHOLD, bytes);
  ::mallopt(M_TOP_PAD, bytes / 16);
}

std::string now_in_utc() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

/// A file on its way, with what the store knows of it.
struct Item {
  std::string path;
  std::optional<StoredFile> stored;
};

/// The store as several threads use it. The first error stops everything.
class SharedStore {
 public:
  SharedStore(Store& store, Known known) : store_(store), known_(known) {}

  std::optional<StoredFile> file(const std::string& path) {
    const std::lock_guard lock(mutex_);
    return kept(store_.file(path));
  }
  std::optional<StoredResult> result(const std::string& recording) {
    const std::lock_guard lock(mutex_);
    return kept(store_.result(recording));
  }
  void write(StoreEntry entry) {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(entry));
    if (waiting_.size() >= written_at_once || Clock::now() - last_ > longest_unwritten) {
      flush();
    }
  }
  void finish() {
    const std::lock_guard lock(mutex_);
    flush();
  }
  [[nodiscard]] bool is_sound() {
    const std::lock_guard lock(mutex_);
    return !error_;
  }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  template <typename T>
  std::optional<T> kept(Expected<std::optional<T>> found) {
    if (!found && !error_) {
      error_ = found.error();
    }
    return found ? std::move(*found) : std::nullopt;
  }
  void flush() {
    if (!error_ && !waiting_.empty()) {
      const auto written = store_.write(waiting_, known_).and_then([&] { return store_.forget_moved(waiting_); });
      if (!written) {
        error_ = written.error();
      }
    }
    waiting_.clear();
    last_ = Clock::now();
  }

  Store& store_;
  Known known_;
  std::mutex mutex_;
  std::vector<StoreEntry> waiting_;
  Clock::time_point last_ = Clock::now();
  std::optional<Error> error_;
};

int worse(int one, int other) {
  const auto rank = [](int code) { return code == 3 ? 4 : code == 2 ? 3 : code == 4 ? 2 : code; };
  return rank(one) >= rank(other) ? one : other;
}

// A result that the store has is computed again where its page is not there: the store does not hold its readings.
bool is_done(const BatchRequest& request, const std::string& path, const std::string& recording, int exit_code) {
  return request.pages == nullptr || exit_code > 1 || request.pages->has(path, recording);
}

void write_page(const BatchRequest& request, RecordingOutcome& outcome) {
  if (!outcome.results.empty()) {
    const auto recording = std::get<std::string>(outcome.entry[StoreTable::Recordings].front().front());
    if (auto written = request.pages->write(outcome.path, recording, outcome.results); !written) {
      outcome.page_error = written.error().text();
    }
  }
}

void count(BatchSummary& summary, const RecordingOutcome& outcome) {
  const bool has_failed = outcome.exit_code > 1;
  summary.done += !has_failed && !outcome.was_known;
  summary.known += !has_failed && outcome.was_known;
  summary.identified += !has_failed && outcome.identified;
  summary.verified += !has_failed && outcome.verified;
  summary.not_shown += outcome.exit_code == 1;
  summary.failed += has_failed;
  // What the recording itself asks wrongly is bad input to a batch.
  summary.exit_code = worse(summary.exit_code, outcome.exit_code == 2 ? 3 : outcome.exit_code);
  if (outcome.exit_code > 1 && outcome.entry[StoreTable::Files].empty() && !outcome.was_known) {
    summary.not_stored[outcome.path] = outcome.error;
  }
  if (outcome.exit_code > 1 && summary.failures.size() < BatchSummary::max_listed) {
    summary.failures.push_back({outcome.path, outcome.exit_code, outcome.error, false, false, false, {}, {}, {}});
  }
  summary.pages += !outcome.results.empty() && outcome.page_error.empty();
  if (!outcome.page_error.empty()) {
    summary.page_errors[outcome.path] = outcome.page_error;
    summary.exit_code = worse(summary.exit_code, 3);
  }
}

}  // namespace

void BatchSummary::note_unreadable(const std::vector<Error>& folders) {
  for (const Error& folder : folders) {
    ++unreadable_folders;
    exit_code = worse(exit_code, 3);
    not_stored[folder.where] = folder.message;
    failures.push_back({folder.where, 3, folder.message, false, false, false, {}, {}, {}});
  }
}

Expected<BatchSummary> run_batch(const std::vector<std::string>& files, const BatchRequest& request, Store& store,
                                 const std::function<void(const RecordingOutcome&)>& tell) {
  keep_freed_memory();
  const std::size_t jobs =
      request.jobs > 0 ? static_cast<std::size_t>(request.jobs) : std::max(1u, std::thread::hardware_concurrency());
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, jobs);
  SharedStore shared(store, request.resume ? Known::Keep : Known::Replace);
  BatchSummary summary;
  summary.files = files.size();
  std::size_t next = 0;
  const auto take = [&](tbb::flow_control& flow) -> Item {
    const bool is_stopped = request.stop != nullptr && request.stop->load();
    if (next == files.size() || is_stopped || !shared.is_sound()) {
      flow.stop();
      return {};
    }
    const std::string& path = files[next++];
    return {path, request.resume ? shared.file(path) : std::nullopt};
  };
  const auto run = [&](const Item& item) {
    if (item.stored && is_done(request, item.path, item.stored->recording, item.stored->result.exit_code)) {
      if (auto known = known_outcome(item.path, *item.stored, request.options)) {
        known->entry = {};  // the store says all this already
        return std::move(*known);
      }
    }
    const auto find = [&](const std::string& key) {
      auto result = shared.result(key);
      return result && is_done(request, item.path, key, result->exit_code) ? result : std::nullopt;
    };
    std::optional<OneThreadOnly> alone;
    if (jobs > 1) {
      alone.emplace();
    }
    auto outcome = run_recording(item.path, request.options, request.resume ? FindResult(find) : FindResult(),
                                 request.pages != nullptr ? Keep::RowsAndResults : Keep::Rows);
    write_page(request, outcome);
    return outcome;
  };
  const auto keep = [&](RecordingOutcome outcome) {
    count(summary, outcome);
    if (!outcome.entry[StoreTable::Files].empty()) {
      if (auto& recordings = outcome.entry[StoreTable::Recordings]; !recordings.empty()) {
        outcome.entry[StoreTable::Stored] = {{recordings.front().front(), now_in_utc()}};
      }
      shared.write(std::move(outcome.entry));
    }
    tell(outcome);
  };
  tbb::parallel_pipeline(4 * jobs,
                         tbb::make_filter<void, Item>(tbb::filter_mode::serial_in_order, take) &
                             tbb::make_filter<Item, RecordingOutcome>(tbb::filter_mode::parallel, run) &
                             tbb::make_filter<RecordingOutcome, void>(tbb::filter_mode::serial_in_order, keep));
  shared.finish();
  if (shared.error()) {
    return tl::unexpected(*shared.error());
  }
  summary.not_reached = files.size() - next;
  return summary;
}

}  // namespace artcal
