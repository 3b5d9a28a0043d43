#include "artefacts/simulation/simulated_scans.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace artcal {
namespace {

const Reading& first_of(const Simulation& simulation, const SimulatedScan& scan) {
  return simulation.recording.readings[static_cast<std::size_t>(scan.readings.front())];
}

std::optional<double> mean_of(double Reading::*temperature, const Simulation& simulation, const SimulatedScan& scan) {
  double sum = 0.0;
  for (const int reading : scan.readings) {
    sum += simulation.recording.readings[static_cast<std::size_t>(reading)].*temperature;
  }
  return std::isfinite(sum) ? std::optional(sum / static_cast<double>(scan.readings.size())) : std::nullopt;
}

RecordedScan recorded(const Simulation& simulation, const SimulatedScan& scan) {
  const Recording& recording = simulation.recording;
  const Reading& first = first_of(simulation, scan);
  RecordedScan written;
  written.path = scan.file;
  written.placement = recording.placements.name(first.placement);
  written.artefact = recording.artefacts.name(first.artefact);
  written.orientation = recording.orientations.name(first.orientation);
  written.repeat = recording.repeats.name(first.repeat);
  if (recording.arm.probes.size() > 1) {
    written.probe = recording.arm.probes[static_cast<std::size_t>(first.probe)].name;
  }
  written.temperature = mean_of(&Reading::temperature, simulation, scan);
  written.arm_temperature = mean_of(&Reading::arm_temperature, simulation, scan);
  return written;
}

}  // namespace

void add_to_scan(Simulation& simulation, int probing) {
  const auto index = static_cast<int>(simulation.recording.readings.size()) - 1;
  const Reading& reading = simulation.recording.readings.back();
  auto& scans = simulation.scans;
  auto scan = std::find_if(scans.begin(), scans.end(), [&](const SimulatedScan& s) {
    return s.probing == probing && s.placement == reading.placement && s.orientation == reading.orientation &&
           s.repeat == reading.repeat;
  });
  if (scan == scans.end()) {
    const std::string file = fmt::format("scan-{}.pcd", scans.size() + 1);
    scans.push_back({file, probing, reading.placement, reading.orientation, reading.repeat, {}});
    scan = scans.end() - 1;
  }
  scan->readings.push_back(index);
}

int planned_scans(const SimulationPlan& plan) {
  int count = 0;
  for (const PlannedProbing& probing : plan.probings) {
    if (probing.scan) {
      count += static_cast<int>(probing.placements.size()) * std::max(1, probing.orientations) * probing.repeats;
    }
  }
  return count;
}

Recording recording_with_scans(const Simulation& simulation) {
  Recording written = simulation.recording;
  std::vector<bool> scanned(written.readings.size(), false);
  for (const SimulatedScan& scan : simulation.scans) {
    written.scans.push_back(recorded(simulation, scan));
    for (const int reading : scan.readings) {
      scanned[static_cast<std::size_t>(reading)] = true;
    }
  }
  std::vector<Eigen::Index> kept;
  written.readings.clear();
  for (std::size_t i = 0; i < scanned.size(); ++i) {
    if (!scanned[i]) {
      kept.push_back(static_cast<Eigen::Index>(i));
      written.readings.push_back(simulation.recording.readings[i]);
    }
  }
  written.joints = Eigen::MatrixXd(simulation.recording.joints(Eigen::all, kept));
  return written;
}

}  // namespace artcal
