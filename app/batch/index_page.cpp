#include "app/batch/index_page.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "app/results/result_names.h"
#include "app/results/verification/standard_name.h"
#include "app/store/stored_text.h"

namespace artcal {
namespace {

constexpr const char* query =
    "SELECT f.path, f.exit_code, f.error, r.arm, r.measured_on, v.standard, v.conclusion, i.rms_before_mm, "
    "i.rms_after_mm, f.recording FROM files f LEFT JOIN recordings r ON r.recording = f.recording "
    "LEFT JOIN verifications v ON v.recording = f.recording LEFT JOIN identifications i ON i.recording = f.recording";
constexpr const char* warnings_query = "SELECT recording FROM remarks WHERE kind = 'warning'";
constexpr const char* shares_query =
    "SELECT recording, value_mm, limit_mm FROM verification_values WHERE limit_mm > 0 AND set_aside = 0";

std::optional<double> number_of(const StoreValue& value) {
  const auto* number = std::get_if<double>(&value);
  return number != nullptr ? std::optional(*number) : std::nullopt;
}

IndexRow row_of(const StoreRow& row) {
  IndexRow shown;
  shown.recording = text_or_empty(row[0]);
  const auto* whole = std::get_if<long long>(&row[1]);
  const long long exit_code = whole != nullptr ? *whole : static_cast<int>(ErrorCode::BadInput);
  shown.outcome = exit_code == 0 ? IndexOutcome::Done : exit_code == 1 ? IndexOutcome::NotShown : IndexOutcome::Failed;
  const std::string word = text_or_empty(row[6]);
  const std::string conclusion = word.empty() ? "" : text_of(conclusion_named(word));
  shown.message = text_or_empty(row[2]).empty() ? conclusion : text_or_empty(row[2]);
  shown.arm = text_or_empty(row[3]);
  shown.date = text_or_empty(row[4]);
  shown.rms_before = number_of(row[7]);
  shown.rms_after = number_of(row[8]);
  shown.task = shown.rms_after ? "identification" : "";
  if (const std::string standard = text_or_empty(row[5]); !standard.empty()) {
    shown.task += (shown.task.empty() ? "" : ", ") + standard_in_words(standard);
  }
  return shown;
}

IndexRow failed_row(const std::string& path, const std::string& error) {
  IndexRow row;
  row.recording = valid_utf8(path);
  row.outcome = IndexOutcome::Failed;
  row.message = valid_utf8(error);
  return row;
}

void add_page(IndexRow& row, const std::string& path, const std::string& recording, const ReportPages* pages,
              const std::map<std::string, std::string>& page_errors) {
  if (pages != nullptr && pages->has(path, recording)) {
    row.report = pages->link(path, recording);
  }
  if (const auto error = page_errors.find(path); error != page_errors.end()) {
    row.message += (row.message.empty() ? "no report: " : "; no report: ") + error->second;
  }
}

}  // namespace

Expected<std::vector<IndexRow>> index_rows(Store& store, const std::vector<std::string>& files,
                                           const ReportPages* pages, const BatchSummary& summary) {
  Expected<std::vector<StoreRow>> found, warnings, shares;
  const auto whole = store.in_snapshot([&] {
    found = store.rows(query);
    warnings = found ? store.rows(warnings_query) : found;
    shares = warnings ? store.rows(shares_query) : warnings;
  });
  if (!whole || !shares) {
    return tl::unexpected(whole ? shares.error() : whole.error());
  }
  std::map<std::string, int> warnings_of;
  for (const StoreRow& row : *warnings) {
    ++warnings_of[text_or_empty(row[0])];
  }
  std::map<std::string, double> largest_of;
  for (const StoreRow& row : *shares) {
    const auto value = number_of(row[1]), limit = number_of(row[2]);
    if (value && limit) {
      double& largest = largest_of[text_or_empty(row[0])];
      largest = std::max(largest, std::abs(*value) / *limit);
    }
  }
  // The store has paths as UTF-8, whatever they are on the disk.
  std::map<std::string, std::string> path_of;
  for (const std::string& file : files) {
    path_of.emplace(valid_utf8(file), file);
  }
  std::vector<IndexRow> rows;
  for (const auto& [path, error] : summary.not_stored) {
    path_of.erase(valid_utf8(path));
    rows.push_back(failed_row(path, error));
  }
  for (const StoreRow& row : *found) {
    const auto path = path_of.find(text_or_empty(row[0]));
    if (path == path_of.end()) {
      continue;
    }
    rows.push_back(row_of(row));
    const std::string recording = text_or_empty(row[9]);
    add_page(rows.back(), path->second, recording, pages, summary.page_errors);
    rows.back().warnings = warnings_of.contains(recording) ? warnings_of[recording] : 0;
    if (largest_of.contains(recording)) {
      rows.back().largest_of_limit = largest_of[recording];
    }
  }
  std::sort(rows.begin(), rows.end(), [](const IndexRow& a, const IndexRow& b) { return a.recording < b.recording; });
  return rows;
}

}  // namespace artcal
