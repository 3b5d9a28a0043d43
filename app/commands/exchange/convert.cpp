#include <memory>

#include <fmt/format.h>

#include "app/commands/command.h"
#include "app/output/output.h"
#include "app/results/result_reader.h"
#include "app/results/result_table.h"

namespace artcal {
namespace {

struct ConvertArguments {
  std::string result, part, output = "-";
  bool csv = false, quiet = false;
};

Expected<int> convert(const ConvertArguments& arguments) {
  if (!arguments.csv) {
    return wrong_usage("say what to convert to: --csv");
  }
  if (auto checked = check_outputs({arguments.output}, {{arguments.result, ""}}); !checked) {
    return tl::unexpected(checked.error());
  }
  const auto result = read_result_json(arguments.result);
  if (!result) {
    return tl::unexpected(result.error());
  }
  auto text = result_csv(result->json, arguments.part);
  if (!text) {
    return tl::unexpected(Error{text.error().code, text.error().message, arguments.result});
  }
  if (arguments.output == "-") {
    fmt::print("{}", *text);
    return 0;
  }
  return write_file(arguments.output, *text).map([&] {
    if (!arguments.quiet) {
      fmt::print("The table is in {}.\n", arguments.output);
    }
    return 0;
  });
}

}  // namespace

Run set_up_convert(CLI::App& parser) {
  auto arguments = std::make_shared<ConvertArguments>();
  parser.add_option("result", arguments->result, "a result as --json writes it")->required()->type_name("RESULT");
  parser.add_flag("--csv", arguments->csv, "write a table as CSV");
  parser.add_option("--part", arguments->part, "which table of the result; by default the first that it has of these")
      ->check(CLI::IsMember({"parameters", "readings", "verdicts", "lengths", "values"}));
  parser.add_option("-o,--output", arguments->output, "the file to write; - is standard output")->type_name("CSV");
  parser.add_flag("--quiet,-q", arguments->quiet, "print nothing but the table and errors");
  parser.footer(
      "parameters, readings and lengths are of an identification, verdicts and lengths of a verification, values of a "
      "fitted feature.\n"
      "Example:\n  artcal verify examples/iso10360-12/recording.toml --json result.json\n"
      "  artcal convert result.json --csv --part verdicts -o verdicts.csv");
  return [arguments] {
    const auto done = convert(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
