#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "app/batch/batch.h"
#include "app/batch/find_recordings.h"
#include "app/batch/index_page.h"
#include "app/batch/progress.h"
#include "app/batch/shard.h"
#include "app/batch/summary_text.h"
#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/output/stop_on_signal.h"
#include "app/requests/access_option.h"
#include "app/store/where.h"

namespace artcal {
namespace {

struct BatchArguments {
  CommonOptions common;
  RecordingOptions access;
  std::vector<std::string> paths;
  std::string store, shard, report, report_pages = "shared";
  BatchRequest batch;
};

std::vector<InputFile> as_inputs(const std::vector<std::string>& files) {
  std::vector<InputFile> inputs;
  for (const std::string& file : files) {
    inputs.push_back({file, ""});
  }
  return inputs;
}

// Beside a file only: an index that goes to a pipe or a device has none.
std::optional<ReportPages> pages_of(const BatchArguments& arguments) {
  std::error_code ignored;
  const auto index = std::filesystem::status(arguments.report, ignored);
  if (arguments.report.empty() || arguments.report_pages == "none" ||
      (std::filesystem::exists(index) && !std::filesystem::is_regular_file(index))) {
    return std::nullopt;
  }
  return ReportPages(arguments.report, arguments.report_pages == "self-contained" ? ReportPages::Kind::SelfContained
                                                                                  : ReportPages::Kind::Shared);
}

Expected<void> write_index(const BatchArguments& arguments, Store& store, const std::vector<std::string>& files,
                           const BatchSummary& summary, const ReportPages* pages) {
  if (arguments.report.empty()) {
    return {};
  }
  const auto rows = index_rows(store, files, pages, summary);
  if (!rows) {
    return tl::unexpected(rows.error());
  }
  return write_file(arguments.report, index_html("Calibrations", *rows));
}

Expected<int> run_and_tell(const BatchArguments& arguments) {
  const auto shard = parse_shard(arguments.shard, [](const char* name) { return std::getenv(name); });
  if (!shard) {
    return tl::unexpected(shard.error());
  }
  const auto found = find_recordings(arguments.paths, std::cin);
  if (!found) {
    return tl::unexpected(found.error());
  }
  if (auto checked = check_outputs({arguments.common.json, file_of_store(arguments.store), arguments.report},
                                   as_inputs(found->files));
      !checked) {
    return tl::unexpected(checked.error());
  }
  // What the recordings refer to is known only once they are read.
  for (const auto& [output, kind] :
       {std::pair(arguments.common.json, OutputKind::JsonFile), std::pair(arguments.report, OutputKind::Page)}) {
    if (auto checked = check_replaced(output, kind); !checked) {
      return tl::unexpected(checked.error());
    }
  }
  const std::vector<std::string> files = part_of(found->files, shard->index, shard->count);
  auto store = Store::open(arguments.store, Database::Access::Write);
  if (!store) {
    return tl::unexpected(store.error());
  }
  std::optional<Progress> progress;
  if (!arguments.common.quiet) {
    progress.emplace(stderr, files.size(), ::isatty(STDERR_FILENO) == 1);
  }
  auto pages = pages_of(arguments);
  BatchRequest asked = arguments.batch;
  asked.options.anywhere = arguments.access.anywhere;
  asked.options.limits = arguments.access.limits;
  asked.options.folders = found->folders;
  if (pages) {
    pages->begin();
    asked.pages = &*pages;
  }
  const StopOnSignal signal;
  asked.stop = &signal.stop();
  auto summary = run_batch(files, asked, *store, [&](const RecordingOutcome& outcome) {
    if (progress) {
      progress->step(outcome.exit_code > 1);
    }
  });
  progress.reset();
  if (!summary) {
    return tl::unexpected(summary.error());
  }
  summary->note_unreadable(found->unreadable);
  if (arguments.common.talks()) {
    fmt::print("{}", to_text(*summary, store->name()));
  } else if (summary->exit_code > 1) {
    fmt::print(stderr, "artcal: {}\n", failure_line(*summary));
  }
  if (auto written = write_json(arguments.common.json, to_json(*summary, store->name())); !written) {
    return tl::unexpected(written.error());
  }
  if (auto written = write_index(arguments, *store, files, *summary, asked.pages); !written) {
    return tl::unexpected(written.error());
  }
  if (summary->not_reached > 0) {
    fmt::print(stderr, "artcal: {}\n", interruption_text(*summary, store->name()));
    return interrupted;
  }
  return summary->exit_code;
}

}  // namespace

Run set_up_batch(CLI::App& parser) {
  auto arguments = std::make_shared<BatchArguments>();
  parser
      .add_option("paths", arguments->paths,
                  "recordings, folders of them, patterns in quotes; - is a list on standard input")
      ->required()
      ->type_name("PATH…");
  parser.add_option("--store", arguments->store, "file (SQLite) or postgresql://… to keep the results in")
      ->required()
      ->type_name("STORE");
  parser.add_flag("--resume", arguments->batch.resume, "leave alone what the store has a result of, by content");
  parser
      .add_option("--jobs,-j", arguments->batch.jobs,
                  "recordings at once; 0: one a core. The store is the same with any")
      ->check(CLI::Range(0, 1024));
  parser.add_flag("--leave-out", arguments->batch.options.leave_out,
                  "identify again without each placement, as identify does; takes several times as long");
  parser.add_option("--shard", arguments->shard, "do the k-th of n parts; in a Slurm job array known by itself")
      ->type_name("K/N");
  parser
      .add_option("--report", arguments->report,
                  "write a page that lists these recordings and what they came to, and beside it, in FILE-reports, a "
                  "page of each")
      ->type_name("FILE.html");
  parser
      .add_option("--report-pages", arguments->report_pages,
                  "the pages' plots: shared, one file for all of the folder; self-contained, 1.8 MB in each, to be "
                  "sent alone; none, no pages")
      ->check(CLI::IsMember({"shared", "self-contained", "none"}))
      ->needs(parser.get_option("--report"))
      ->capture_default_str();
  arguments->access.add_to(parser);
  arguments->common.add_to(parser);
  parser.footer(
      "Each recording is identified, verified or both, as its file asks. The exit code is 0 where all went well, 1 "
      "where\n"
      "conformity was not shown, 3 where a recording was refused, 4 where one had no solution.\n"
      "Example:\n  artcal batch examples --store results.sqlite --resume");
  return [arguments] {
    const auto done = run_and_tell(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
