#include "artefacts/verification/session.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace artcal {

std::vector<Touched> touched_features(const Session& session, Orientations orientations) {
  std::vector<Touched> all;
  for (const FeatureConstraint& constraint : session.constraints.features) {
    std::map<std::pair<int, int>, std::size_t> index;
    for (const int reading : constraint.readings) {
      const Reading& r = session.recording.readings[reading];
      const auto [entry, is_new] =
          index.try_emplace({r.repeat, orientations == Orientations::Apart ? r.orientation : 0}, all.size());
      if (is_new) {
        all.push_back({constraint.artefact, constraint.placement, constraint.feature, r.orientation, r.repeat, {}});
      }
      all[entry->second].readings.push_back(reading);
    }
  }
  return all;
}

bool is_scanned(const Session& session, const std::vector<int>& readings) {
  const Recording& recording = session.recording;
  std::vector<bool> by_scan;
  for (const std::string& file : recording.files) {
    by_scan.push_back(std::any_of(recording.scans.begin(), recording.scans.end(),
                                  [&](const RecordedScan& scan) { return scan.path == file; }));
  }
  return std::any_of(readings.begin(), readings.end(), [&](int reading) {
    return by_scan[static_cast<std::size_t>(recording.readings[static_cast<std::size_t>(reading)].file)];
  });
}

double mean_temperature(const Session& session, const std::vector<int>& readings) {
  double sum = 0.0;
  int count = 0;
  for (const int reading : readings) {
    const double temperature = session.recording.readings[reading].temperature;
    if (std::isfinite(temperature)) {
      sum += temperature;
      ++count;
    }
  }
  return sum / count;  // 0/0 is NaN, as promised
}

ThermalState thermal_state(const Session& session, const Artefact& artefact, double temperature) {
  ThermalState state{artefact.expansion, artefact.u_expansion, 0.0, session.specification.u_temperature.value_or(0.0)};
  if (std::isfinite(temperature)) {
    state.difference = temperature - artefact.reference_temperature;
  }
  return state;
}

double expansion_factor_or_one(const Artefact& artefact, double temperature) {
  return std::isfinite(temperature) ? artefact.expansion_factor(temperature) : 1.0;
}

}  // namespace artcal
