#include "app/report/sections/provenance.h"

#include <fmt/format.h>

#include "app/output/phrases.h"
#include "app/report/numbers.h"

namespace artcal {
namespace {

using namespace numbers;

std::string temperature_of(const RecordedCircumstances& circumstances) {
  if (!circumstances.temperatures) {
    return "not read";
  }
  const auto [lowest, highest] = *circumstances.temperatures;
  return lowest == highest ? fmt::format("{:.2f} °C", lowest) : fmt::format("{:.2f} °C to {:.2f} °C", lowest, highest);
}

std::string readings_of(const RecordedCircumstances& circumstances) {
  const std::string readings = plural(circumstances.readings, "reading");
  return circumstances.features && circumstances.placements
             ? fmt::format("{}, {}, {}", readings, plural(*circumstances.features, "feature"),
                           plural(*circumstances.placements, "placement"))
             : readings;
}

void write_artefacts(const std::vector<RecordedArtefact>& artefacts, Sheet& sheet) {
  html::Table table("Artefacts and their certificates", {{"artefact", false, true},
                                                         {"type", false},
                                                         {"certificate", false},
                                                         {"laboratory", false},
                                                         {"date", false},
                                                         {"valid until", false}});
  for (const RecordedArtefact& artefact : artefacts) {
    table.add({shown(artefact.name), or_dash(artefact.type),
               artefact.is_certified ? shown(or_dash(artefact.number)) : "none stated",
               shown(or_dash(artefact.laboratory)), shown(or_dash(artefact.date)),
               shown(or_dash(artefact.valid_until))});
  }
  sheet.table(table);
}

}  // namespace

void write_circumstances(const RecordedHead& head, const RecordedCircumstances& circumstances, Sheet& sheet) {
  sheet.facts({{"Arm", shown(head.arm)},
               {"Recording", shown(head.recording)},
               {"Date", head.date.empty() ? "not stated" : shown(head.date)},
               {"Temperature", temperature_of(circumstances)},
               {"Readings", readings_of(circumstances)}});
  write_artefacts(circumstances.artefacts, sheet);
  for (const std::string& warning : circumstances.warnings) {
    sheet.note("⚠ " + as_sentence(warning));
  }
}

void write_provenance(const std::vector<RecordedResult>& results, Sheet& sheet) {
  sheet.section("Where the numbers come from");
  sheet.paragraph(
      "Every file that was read, by its SHA-256. The same files and the same options give the same numbers again.");
  for (const RecordedResult& result : results) {
    const RecordedHead& head = result.head;
    html::Table table(fmt::format("{} {}, {}", head.program, head.version, head.kind),
                      {{"file", false, true}, {"SHA-256", false}});
    for (const InputFile& input : head.inputs) {
      table.add_markup({html::cell(shown(input.path)), "<span class=\"hash\">" + html::text(input.sha256) + "</span>"});
    }
    sheet.table(table);
  }
}

}  // namespace artcal
