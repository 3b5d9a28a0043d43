#include <memory>

#include <fmt/format.h>

#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/results/result_reader.h"
#include "app/results/result_table.h"

namespace artcal {
namespace {

struct Request {
  std::string result, part, output = "-";
  bool csv = false, quiet = false;
};

Expected<int> convert(const Request& request) {
  if (!request.csv) {
    return wrong_usage("say what to convert to: --csv");
  }
  if (auto checked = check_outputs({request.output}, {{request.result, ""}}); !checked) {
    return tl::unexpected(checked.error());
  }
  const auto result = read_result_json(request.result);
  if (!result) {
    return tl::unexpected(result.error());
  }
  auto text = result_csv(result->json, request.part);
  if (!text) {
    return tl::unexpected(Error{text.error().code, text.error().message, request.result});
  }
  if (request.output == "-") {
    fmt::print("{}", *text);
    return 0;
  }
  return write_file(request.output, *text).map([&] {
    if (!request.quiet) {
      fmt::print("The table is in {}.\n", request.output);
    }
    return 0;
  });
}

}  // namespace

Run set_up_convert(CLI::App& parser) {
  auto request = std::make_shared<Request>();
  parser.add_option("result", request->result, "a result as --json writes it")->required()->type_name("RESULT");
  parser.add_flag("--csv", request->csv, "write a table as CSV");
  parser.add_option("--part", request->part, "which table of the result; by default the first that it has of these")
      ->check(CLI::IsMember({"parameters", "readings", "verdicts", "lengths", "values"}));
  parser.add_option("-o,--output", request->output, "the file to write; - is standard output")->type_name("CSV");
  parser.add_flag("--quiet,-q", request->quiet, "print nothing but the table and errors");
  parser.footer(
      "parameters, readings and lengths are of an identification, verdicts and lengths of a verification, values of a "
      "fitted feature.\n"
      "Example:\n  artcal verify examples/iso10360-12/recording.toml --json result.json\n"
      "  artcal convert result.json --csv --part verdicts -o verdicts.csv");
  return [request] {
    const auto done = convert(*request);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
