#include "artefacts/constraints/coincident_readings.h"

#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "core/coincidence/coincident_columns.h"

namespace artcal {
namespace {

constexpr double joint_step = 1e-9;  // rad; far below any encoder's resolution and above the rounding of a conversion
constexpr double max_by_resolution = 0.25;

// What makes a measurement, a column a reading.
Eigen::MatrixXd measured_numbers(const Recording& recording) {
  const Eigen::Index joints = recording.joints.rows();
  Eigen::MatrixXd numbers(joints + 10, static_cast<Eigen::Index>(recording.readings.size()));
  for (Eigen::Index i = 0; i < numbers.cols(); ++i) {
    const Reading& reading = recording.readings[static_cast<std::size_t>(i)];
    auto column = numbers.col(i);
    if (joints > 0) {
      column.head(joints) = (recording.joints.col(i) / joint_step).array().round().matrix();
    }
    column.segment<3>(joints) << reading.artefact, reading.feature, reading.probe;
    column.segment<3>(joints + 3) = reading.tip;
    column.segment<3>(joints + 6) = reading.reference;
    column(joints + 9) = reading.length;
  }
  return numbers;
}

bool has_joints(const Recording& recording, Eigen::Index reading) {
  return recording.joints.rows() > 0 && recording.joints.col(reading).allFinite();
}

bool is_seat(const Recording& recording, const std::vector<Artefact>& artefacts, const Reading& reading) {
  const std::string& name = recording.artefacts.name(reading.artefact);
  for (const Artefact& artefact : artefacts) {
    if (artefact.name == name || (name.empty() && artefacts.size() == 1)) {
      const int feature = artefact.feature_index(recording.features.name(reading.feature));
      return feature >= 0 && artefact.features[static_cast<std::size_t>(feature)].kind == FeatureKind::Point;
    }
  }
  return false;
}

using Seat = std::tuple<int, int, int>;  // artefact, placement, feature

// Repeats in seats that the resolution of their coordinates explains stay.
void spare_resolution(const Recording& recording, const std::vector<Artefact>& artefacts,
                      std::vector<Eigen::Index>& first) {
  std::map<Seat, std::pair<int, int>> counts;  // readings, and repeated ones among them
  const auto seat_of = [&](std::size_t i) {
    const Reading& reading = recording.readings[i];
    return Seat{reading.artefact, reading.placement, reading.feature};
  };
  const auto concerns = [&](std::size_t i) {
    return !has_joints(recording, static_cast<Eigen::Index>(i)) && is_seat(recording, artefacts, recording.readings[i]);
  };
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (concerns(i)) {
      auto& [all, repeated] = counts[seat_of(i)];
      ++all;
      repeated += first[i] != static_cast<Eigen::Index>(i) ? 1 : 0;
    }
  }
  for (std::size_t i = 0; i < first.size() && !counts.empty(); ++i) {
    if (first[i] != static_cast<Eigen::Index>(i) && concerns(i)) {
      const auto& [all, repeated] = counts[seat_of(i)];
      first[i] = repeated <= max_by_resolution * all ? static_cast<Eigen::Index>(i) : first[i];
    }
  }
}

}  // namespace

void drop_coincident_readings(Recording& recording, const std::vector<Artefact>& artefacts) {
  auto first = first_coincident(measured_numbers(recording));
  spare_resolution(recording, artefacts, first);
  std::string example;
  for (std::size_t i = 0; i < first.size() && example.empty(); ++i) {
    if (first[i] != static_cast<Eigen::Index>(i)) {
      example = fmt::format("{} repeats {}", recording.where(static_cast<int>(i)),
                            recording.where(static_cast<int>(first[i])));
    }
  }
  if (example.empty()) {
    return;
  }
  const bool has_columns = recording.joints.cols() > 0;  // a recording of coordinates may have none
  std::vector<Reading> kept;
  Eigen::MatrixXd joints(recording.joints.rows(), recording.joints.cols());
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == static_cast<Eigen::Index>(i)) {
      if (has_columns) {
        joints.col(static_cast<Eigen::Index>(kept.size())) = recording.joints.col(static_cast<Eigen::Index>(i));
      }
      kept.push_back(recording.readings[i]);
    }
  }
  recording.repeated_readings = fmt::format(
      "{} of {} readings repeat an earlier one in every number ({}) and are counted once: they are no "
      "independent measurements",
      first.size() - kept.size(), first.size(), example);
  recording.warnings.push_back(*recording.repeated_readings);
  if (has_columns) {
    recording.joints = joints.leftCols(static_cast<Eigen::Index>(kept.size())).eval();
  }
  recording.readings = std::move(kept);
}

}  // namespace artcal
