#include "app/batch/summary_text.h"

#include <algorithm>

#include <fmt/format.h>

#include "app/output/phrases.h"
#include "app/output/table.h"
#include "app/results/result_head.h"
#include "app/store/stored_text.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::size_t most_listed = 20;

}  // namespace

std::string to_text(const BatchSummary& summary, const std::string& store) {
  Table table({"recordings", fmt::format("{}", summary.files)});
  const auto add = [&](const char* what, std::size_t count) {
    if (count > 0) {
      table.add({what, fmt::format("{}", count)});
    }
  };
  // These add up to the recordings.
  add("  done now", summary.done);
  add("  known before, left alone", summary.known);
  add("  failed", summary.failed);
  add("  not reached", summary.not_reached);
  // These say what was done, and may overlap.
  add("identified", summary.identified);
  add("verified", summary.verified);
  add("conformity not shown", summary.not_shown);
  add("folders that could not be read", summary.unreadable_folders);
  add("reports written", summary.pages);
  add("reports not written", summary.page_errors.size());
  std::string text = table.text();
  if (!summary.failures.empty()) {
    text += "\nFailed:\n";
  }
  for (std::size_t i = 0; i < std::min(most_listed, summary.failures.size()); ++i) {
    const RecordingOutcome& failure = summary.failures[i];
    text +=
        fmt::format("  {}\n    {}\n", in_one_line(valid_utf8(failure.path)), truncated(400, valid_utf8(failure.error)));
  }
  if (summary.failed > most_listed) {
    text += fmt::format("  … {} more; they are in the store: files with an error\n", summary.failed - most_listed);
  }
  if (!summary.page_errors.empty()) {
    const auto& [path, error] = *summary.page_errors.begin();
    text += fmt::format("\nThe first report that was not written is of {}:\n  {}\n", in_one_line(valid_utf8(path)),
                        truncated(400, in_one_line(valid_utf8(error))));
  }
  return text + fmt::format("\nThe results are in {}.\n", store);
}

std::string interruption_text(const BatchSummary& summary, const std::string& store) {
  return fmt::format(
      "interrupted after {} of {} recordings; their results are in {}. The same command with --resume goes on from "
      "there",
      summary.files - summary.not_reached, summary.files, store);
}

std::string failure_line(const BatchSummary& summary) {
  std::string text;
  if (summary.failed > 0) {
    text = fmt::format("{} of {} recordings failed", summary.failed, summary.files);
  }
  if (summary.unreadable_folders > 0) {
    text += fmt::format("{}{} could not be read", text.empty() ? "" : " and ",
                        plural(summary.unreadable_folders, "folder"));
  }
  if (!summary.failures.empty()) {
    const RecordingOutcome& first = summary.failures.front();
    text += fmt::format(", the first is {}: {}", in_one_line(valid_utf8(first.path)),
                        truncated(400, in_one_line(valid_utf8(first.error))));
  }
  if (!summary.page_errors.empty()) {
    const auto& [path, error] = *summary.page_errors.begin();
    text += fmt::format("{}{} were not written, the first is of {}: {}", text.empty() ? "" : "; ",
                        plural(summary.page_errors.size(), "report"), in_one_line(valid_utf8(path)),
                        truncated(400, in_one_line(valid_utf8(error))));
  }
  return text;
}

nlohmann::ordered_json to_json(const BatchSummary& summary, const std::string& store) {
  nlohmann::ordered_json json = result_head("batch");
  json["store"] = store;
  json["files"] = summary.files;
  json["done"] = summary.done;
  json["known"] = summary.known;
  json["identified"] = summary.identified;
  json["verified"] = summary.verified;
  json["not_shown"] = summary.not_shown;
  json["failed"] = summary.failed;
  json["not_reached"] = summary.not_reached;
  json["unreadable_folders"] = summary.unreadable_folders;
  json["reports"] = summary.pages;
  json["reports_failed"] = summary.page_errors.size();
  json["failures"] = nlohmann::ordered_json::array();
  for (const RecordingOutcome& failure : summary.failures) {
    json["failures"].push_back(
        {{"path", valid_utf8(failure.path)}, {"exit_code", failure.exit_code}, {"error", valid_utf8(failure.error)}});
  }
  return json;
}

}  // namespace artcal
