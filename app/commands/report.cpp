#include <memory>

#include <fmt/format.h>

#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/report/report.h"

namespace artcal {
namespace {

struct ReportArguments {
  std::vector<std::string> results;
  std::string page;
  bool quiet = false;
};

// What the result itself was computed from, as far as it lies where it lay then.
std::vector<InputFile> files_named_in(const ReportedResult& result) {
  std::vector<InputFile> files;
  if (const auto inputs = result.json.find("inputs"); inputs != result.json.end() && inputs->is_array()) {
    for (const auto& input : *inputs) {
      if (input.is_object() && input.contains("path") && input["path"].is_string()) {
        files.push_back({input["path"].get<std::string>(), ""});
      }
    }
  }
  return files;
}

Expected<int> report_and_tell(const ReportArguments& arguments) {
  std::vector<InputFile> inputs;
  std::vector<ReportedResult> results;
  for (const std::string& path : arguments.results) {
    auto result = read_result(path, inputs);
    if (!result) {
      return tl::unexpected(result.error());
    }
    results.push_back(std::move(*result));
  }
  for (const ReportedResult& result : results) {
    const auto rests_on = files_named_in(result);
    inputs.insert(inputs.end(), rests_on.begin(), rests_on.end());
  }
  if (auto checked = check_outputs({arguments.page}, inputs); !checked) {
    return tl::unexpected(checked.error());
  }
  const auto page = report_html(results);
  if (!page) {
    return tl::unexpected(page.error());
  }
  if (auto written = write_file(arguments.page, *page); !written) {
    return tl::unexpected(written.error());
  }
  if (!arguments.quiet) {
    fmt::print("The report is in {}.\n", arguments.page);
  }
  return 0;
}

}  // namespace

Run set_up_report(CLI::App& parser) {
  auto arguments = std::make_shared<ReportArguments>();
  parser.add_option("results", arguments->results, "results as --json writes them, all of one arm")
      ->required()
      ->type_name("RESULT");
  parser.add_option("-o,--output", arguments->page, "the page to write")->required()->type_name("FILE.html");
  parser.add_flag("--quiet,-q", arguments->quiet, "print nothing but errors");
  parser.footer(
      "Example:\n  artcal identify examples/two-socket-bar/recording.toml --json result.json\n"
      "  artcal report result.json -o report.html");
  return [arguments] {
    const auto done = report_and_tell(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
