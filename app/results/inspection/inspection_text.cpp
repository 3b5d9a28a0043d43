#include "app/results/inspection/inspection_text.h"

#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/output/phrases.h"
#include "app/output/table.h"
#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

std::string list_text(const std::string& head, const Findings& findings) {
  std::string text = findings.empty() ? "" : head + "\n";
  for (const Finding& finding : findings) {
    text += fmt::format("  [{}] {}\n", name_of(finding.kind), as_sentence(finding.sentence()));
  }
  return text.empty() ? text : text + "\n";
}

std::string usage_text(const Usage& usage) {
  if (usage.joints.empty()) {
    return "";
  }
  Table table({"joint", "from, deg", "to, deg", "of its circle"});
  for (std::size_t j = 0; j < usage.joints.size(); ++j) {
    table.add({fmt::format("{}", j + 1), fmt::format("{:.0f}", usage.joints[j].lowest / units::degree),
               fmt::format("{:.0f}", usage.joints[j].highest / units::degree),
               fmt::format("{:.0f} %", 100.0 * usage.joints[j].covered)});
  }
  return fmt::format(
      "Used of the arm (nominal):\n{}\n"
      "  tips at {:.0f} to {:.0f} % of the reach, in {:.0f} % of 16 parts of the volume; stylus in {:.0f} % of 26 "
      "directions\n  placements with the elbow left, right, both: {}, {}, {}\n",
      table.text(), 100.0 * usage.nearest, 100.0 * usage.farthest, 100.0 * usage.volume_share,
      100.0 * usage.orientation_share, usage.placements_left, usage.placements_right, usage.placements_both);
}

}  // namespace

std::string further_findings_text(const Findings& findings) {
  Findings further = findings;
  std::erase_if(further, [](const Finding& finding) { return finding.is_input_warning; });
  return list_text("Findings:", further);
}

std::string to_text(const Recording& recording, const Constraints& constraints, const Inspection& inspection) {
  std::set<int> placements;
  for (const Reading& reading : recording.readings) {
    placements.insert(reading.placement);
  }
  std::string text =
      fmt::format("{}\narm {}: {}, {}, {}\n\n", truncated(60, recording.name), in_quotes(recording.arm.name),
                  plural(recording.readings.size(), "reading"), plural(constraints.features.size(), "feature"),
                  plural(placements.size(), "placement"));
  text += inspection.findings.empty() ? "No mistake found.\n\n" : "";
  text += list_text("Findings:", inspection.findings);
  if (!inspection.excluded.empty()) {
    text += fmt::format("Looked for in vain: {}.\n\n", fmt::join(inspection.excluded, "; "));
  }
  text += list_text("Remarks:", inspection.remarks);
  return text + warning_lines(recording.warnings) + usage_text(inspection.usage);
}

}  // namespace artcal
