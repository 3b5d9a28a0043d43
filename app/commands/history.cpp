#include <memory>

#include <fmt/format.h>

#include "app/commands/command.h"
#include "app/history/history_page.h"
#include "app/history/history_text.h"
#include "app/history/recall/certificate_list.h"
#include "app/output/output.h"
#include "app/results/result_table.h"
#include "app/store/where.h"

namespace artcal {
namespace {

struct HistoryArguments {
  CommonOptions common;
  std::string arm, store, certificate, report, csv;
  bool all = false;
};

Expected<int> tell_certificate(const HistoryArguments& arguments, Store& store) {
  const auto uses = uses_of_certificate(store, arguments.certificate);
  if (!uses) {
    return tl::unexpected(uses.error());
  }
  const auto json = to_json(arguments.certificate, *uses, store.name());
  for (const auto& [path, text] : {std::pair(arguments.csv, csv_of_rows(json.at("results"))),
                                   {arguments.report, arguments.report.empty() ? "" : certificate_page(json)}}) {
    if (auto written = path.empty() ? Expected<void>() : write_file(path, text); !written) {
      return tl::unexpected(written.error());
    }
  }
  return arguments.common.tell(json, to_text(arguments.certificate, *uses));
}

Expected<int> tell_history(const HistoryArguments& arguments) {
  if (arguments.arm.empty() == arguments.certificate.empty()) {
    return wrong_usage("whose history? Name an arm, or a certificate with --certificate NUMBER, not both");
  }
  if (arguments.certificate.empty() && !arguments.csv.empty()) {
    return wrong_usage("--csv is for the results that rest on a certificate: --certificate NUMBER");
  }
  if (auto checked = check_outputs({arguments.common.json, arguments.report, arguments.csv},
                                   {{file_of_store(arguments.store), ""}});
      !checked) {
    return tl::unexpected(checked.error());
  }
  auto store = Store::open(arguments.store, Database::Access::Read);
  if (!store) {
    return tl::unexpected(store.error());
  }
  if (!arguments.certificate.empty()) {
    return tell_certificate(arguments, *store);
  }
  const auto history = read_history(*store, arguments.arm);
  if (!history) {
    return tl::unexpected(history.error());
  }
  if (!arguments.report.empty()) {
    if (auto written = write_file(arguments.report, history_html(*history, store->name())); !written) {
      return tl::unexpected(written.error());
    }
  }
  return arguments.common.tell(to_json(*history), to_text(*history, arguments.all));
}

}  // namespace

Run set_up_history(CLI::App& parser) {
  auto arguments = std::make_shared<HistoryArguments>();
  parser.add_option("arm", arguments->arm, "the arm's name, as its file states it")->type_name("ARM");
  parser.add_option("--store", arguments->store, "file or postgresql://… that artcal batch has written")
      ->required()
      ->type_name("STORE");
  parser
      .add_option("--certificate", arguments->certificate,
                  "list every result that rests on this certificate, of any arm")
      ->type_name("NUMBER");
  parser
      .add_option("--report", arguments->report,
                  "write a page: what changed, with pictures over time; of a certificate the list")
      ->type_name("FILE.html");
  parser.add_option("--csv", arguments->csv, "of a certificate: write the list as CSV")->type_name("CSV");
  parser.add_flag("--all", arguments->all, "list every change, not only the significant ones");
  arguments->common.add_to(parser);
  parser.footer(
      "Examples:\n  artcal history \"arm 17\" --store results.sqlite\n"
      "  artcal history --certificate 4711 --store results.sqlite --csv recall.csv");
  return [arguments] {
    const auto done = tell_history(*arguments);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
