#include "app/stream/virtual_events.h"

#include <fmt/format.h>

#include "acquisition/recording/tip_centres.h"
#include "core/units.h"

namespace artcal {

Expected<void> send_events(const Simulation& simulation, const std::vector<PlantedMistake>& mistakes, double period,
                           const std::function<bool(const std::string&)>& send) {
  const Recording& recording = simulation.recording;
  if (!simulation.scans.empty()) {
    return wrong_usage("--stream sends touches one by one, and the plan has scans; simulate it with -o FOLDER");
  }
  const auto tips = tip_centres(recording, recording.arm);
  if (!tips) {
    return tl::unexpected(tips.error());
  }
  std::string artefact;
  std::string placement;
  std::string feature;
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    const Reading& reading = recording.readings[i];
    const auto column = static_cast<Eigen::Index>(i);
    std::string lines;
    for (const auto& [word, name, before] :
         {std::tuple("artefact", recording.artefacts.name(reading.artefact), &artefact),
          {"placement", recording.placements.name(reading.placement), &placement},
          {"feature", recording.features.name(reading.feature), &feature}}) {
      if (name != *before) {
        lines += fmt::format("!{} {}\n", word, name);
        *before = name;
      }
    }
    const Eigen::VectorXd joints = handed_on(mistakes, recording.joints.col(column));
    for (const bool pressed : {true, false}) {
      lines += "{";
      for (Eigen::Index j = 0; j < joints.size(); ++j) {
        const bool is_prismatic = recording.arm.joints[static_cast<std::size_t>(j)].is_prismatic();
        lines += fmt::format("\"Angle{}\":{:.12f},", j + 1, joints[j] / (is_prismatic ? 1.0 : units::degree));
      }
      lines += fmt::format(
          "\"X\":{:.9f},\"Y\":{:.9f},\"Z\":{:.9f},\"Buttons\":{},\"ArmAtRest\":true,"
          "\"EncodersReferenced\":true,\"EndStops\":0,\"TimeStamp\":{:.6f}}}\n",
          tips->in_base(0, column), tips->in_base(1, column), tips->in_base(2, column), pressed ? 1 : 0,
          period * (static_cast<double>(i) + (pressed ? 0.0 : 0.5)));
    }
    if (!send(lines)) {
      break;
    }
  }
  return {};
}

}  // namespace artcal
