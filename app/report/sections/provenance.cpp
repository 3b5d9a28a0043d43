#include "app/report/sections/provenance.h"

#include <fmt/format.h>

#include "app/output/phrases.h"
#include "app/report/numbers.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using namespace numbers;

std::string temperature_of(const Json& result) {
  if (!result.contains("temperature") || result.at("temperature").is_null()) {
    return "not read";
  }
  const double lowest = result.at("temperature").at("lowest_C");
  const double highest = result.at("temperature").at("highest_C");
  return lowest == highest ? fmt::format("{:.2f} °C", lowest) : fmt::format("{:.2f} °C to {:.2f} °C", lowest, highest);
}

std::string readings_of(const Json& result) {
  if (result.contains("readings")) {
    return plural(result.at("readings").get<std::size_t>(), "reading");
  }
  const Json& counts = result.at("counts");
  return fmt::format("{}, {}, {}", plural(counts.at("readings").get<std::size_t>(), "reading"),
                     plural(counts.at("features").get<std::size_t>(), "feature"),
                     plural(counts.at("placements").get<std::size_t>(), "placement"));
}

void write_artefacts(const Json& artefacts, Sheet& sheet) {
  html::Table table("Artefacts and their certificates", {{"artefact", false, true},
                                                         {"type", false},
                                                         {"certificate", false},
                                                         {"laboratory", false},
                                                         {"date", false},
                                                         {"valid until", false}});
  for (const Json& artefact : artefacts) {
    const Json& stated = artefact.at("certificate");
    const Json certificate = stated.is_null() ? Json::object() : stated;
    table.add({shown(text_in(artefact, "name")), text_in(artefact, "type", "–"),
               stated.is_null() ? "none stated" : shown(text_in(certificate, "number", "–")),
               shown(text_in(certificate, "laboratory", "–")), shown(text_in(certificate, "date", "–")),
               shown(text_in(certificate, "valid_until", "–"))});
  }
  sheet.table(table);
}

}  // namespace

void write_circumstances(const Json& result, Sheet& sheet) {
  sheet.facts({{"Arm", shown(text_in(result, "arm"))},
               {"Recording", shown(text_in(result, "recording"))},
               {"Date", shown(text_in(result, "date", "not stated"))},
               {"Temperature", temperature_of(result)},
               {"Readings", readings_of(result)}});
  write_artefacts(result.at("artefacts"), sheet);
  for (const Json& warning : result.at("warnings")) {
    sheet.note("⚠ " + as_sentence(warning.get<std::string>()));
  }
}

void write_provenance(const std::vector<ReportedResult>& results, Sheet& sheet) {
  sheet.section("Where the numbers come from");
  sheet.paragraph(
      "Every file that was read, by its SHA-256. The same files and the same options give the same numbers again.");
  for (const ReportedResult& result : results) {
    const Json& program = result.json.at("program");
    html::Table table(
        fmt::format("{} {}, {}", text_in(program, "name"), text_in(program, "version"), text_in(result.json, "kind")),
        {{"file", false, true}, {"SHA-256", false}});
    for (const Json& input : result.json.at("inputs")) {
      table.add_markup({html::cell(shown(text_in(input, "path"))),
                        "<span class=\"hash\">" + html::text(text_in(input, "sha256")) + "</span>"});
    }
    sheet.table(table);
  }
}

}  // namespace artcal
