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

struct Request {
  CommonOptions common;
  std::string arm, store, certificate, report, csv;
  bool all = false;
};

Expected<int> tell_certificate(const Request& request, Store& store) {
  const auto uses = uses_of_certificate(store, request.certificate);
  if (!uses) {
    return tl::unexpected(uses.error());
  }
  const auto json = to_json(request.certificate, *uses, store.name());
  for (const auto& [path, text] : {std::pair(request.csv, csv_of_rows(json.at("results"))),
                                   {request.report, request.report.empty() ? "" : certificate_page(json)}}) {
    if (auto written = path.empty() ? Expected<void>() : write_file(path, text); !written) {
      return tl::unexpected(written.error());
    }
  }
  return request.common.tell(json, to_text(request.certificate, *uses));
}

Expected<int> tell_history(const Request& request) {
  if (request.arm.empty() == request.certificate.empty()) {
    return wrong_usage("whose history? Name an arm, or a certificate with --certificate NUMBER, not both");
  }
  if (request.certificate.empty() && !request.csv.empty()) {
    return wrong_usage("--csv is for the results that rest on a certificate: --certificate NUMBER");
  }
  if (auto checked =
          check_outputs({request.common.json, request.report, request.csv}, {{file_of_store(request.store), ""}});
      !checked) {
    return tl::unexpected(checked.error());
  }
  auto store = Store::open(request.store, Database::Access::Read);
  if (!store) {
    return tl::unexpected(store.error());
  }
  if (!request.certificate.empty()) {
    return tell_certificate(request, *store);
  }
  const auto history = read_history(*store, request.arm);
  if (!history) {
    return tl::unexpected(history.error());
  }
  if (!request.report.empty()) {
    if (auto written = write_file(request.report, history_html(*history, store->name())); !written) {
      return tl::unexpected(written.error());
    }
  }
  return request.common.tell(to_json(*history), to_text(*history, request.all));
}

}  // namespace

Run set_up_history(CLI::App& parser) {
  auto request = std::make_shared<Request>();
  parser.add_option("arm", request->arm, "the arm's name, as its file states it")->type_name("ARM");
  parser.add_option("--store", request->store, "file or postgresql://… that artcal batch has written")
      ->required()
      ->type_name("STORE");
  parser
      .add_option("--certificate", request->certificate, "list every result that rests on this certificate, of any arm")
      ->type_name("NUMBER");
  parser
      .add_option("--report", request->report,
                  "write a page: what changed, with pictures over time; of a certificate the list")
      ->type_name("FILE.html");
  parser.add_option("--csv", request->csv, "of a certificate: write the list as CSV")->type_name("CSV");
  parser.add_flag("--all", request->all, "list every change, not only the significant ones");
  request->common.add_to(parser);
  parser.footer(
      "Examples:\n  artcal history \"arm 17\" --store results.sqlite\n"
      "  artcal history --certificate 4711 --store results.sqlite --csv recall.csv");
  return [request] {
    const auto done = tell_history(*request);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
