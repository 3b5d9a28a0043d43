#include <memory>

#include <fmt/format.h>

#include "app/commands/command.h"
#include "app/history/certificate_use.h"
#include "app/history/history_page.h"
#include "app/history/history_text.h"
#include "app/output/output.h"
#include "app/output/table.h"
#include "app/store/stored_text.h"
#include "app/store/where.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

struct Request {
  CommonOptions common;
  std::string arm, store, certificate, report;
  bool all = false;
};

std::string uses_text(const std::string& number, const std::vector<CertificateUse>& uses) {
  Table table({"arm", "date", "recording", "artefact", "laboratory", "file"});
  for (const CertificateUse& use : uses) {
    table.add({truncated(40, use.arm), use.date.empty() ? "no date" : use.date, truncated(40, use.name),
               truncated(40, use.artefact), truncated(40, use.laboratory),
               use.path.empty() ? "no longer there" : in_one_line(use.path)});
  }
  return fmt::format("Results that rest on certificate {}: {}\n\n{}", in_quotes(number), uses.size(), table.text());
}

Expected<int> tell_certificate(const Request& request, Store& store) {
  return uses_of_certificate(store, request.certificate).map([&](const std::vector<CertificateUse>& uses) {
    if (!request.common.quiet) {
      fmt::print("{}", uses_text(request.certificate, uses));
    }
    return 0;
  });
}

Expected<int> tell(const Request& request) {
  if (request.arm.empty() == request.certificate.empty()) {
    return wrong_usage("whose history? Name an arm, or a certificate with --certificate NUMBER, not both");
  }
  if (!request.certificate.empty() && !request.common.json.empty()) {
    return wrong_usage("--json is for an arm's history; docs/store.md has the SQL for a certificate");
  }
  if (!request.certificate.empty() && !request.report.empty()) {
    return wrong_usage("--report is for an arm's history, not for that of a certificate");
  }
  if (auto checked = check_outputs({request.common.json, request.report}, {{file_of_store(request.store), ""}});
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
  parser.add_option("--report", request->report, "write a page: what changed, with pictures over time")
      ->type_name("FILE.html");
  parser.add_flag("--all", request->all, "list every change, not only the significant ones");
  request->common.add_to(parser);
  parser.footer(
      "Examples:\n  artcal history \"arm 17\" --store results.sqlite\n"
      "  artcal history --certificate 4711 --store results.sqlite");
  return [request] {
    const auto done = tell(*request);
    return done ? *done : report_error(done.error());
  };
}

}  // namespace artcal
