#include "app/results/evaluation/recorded_readings.h"

#include <fmt/format.h>

namespace artcal {
namespace {

void require_size(const RecordedObject& json, const char* key, std::size_t found, std::size_t expected) {
  if (found != expected) {
    json.refuse(key, fmt::format("of {} readings, expected {}", found, expected));
  }
}

void require_columns(const RecordedObject& json, const char* key, const std::vector<std::vector<double>>& columns,
                     std::size_t readings) {
  for (const auto& column : columns) {
    require_size(json, key, column.size(), readings);
  }
}

std::vector<std::vector<double>> coordinates(const RecordedObject& json, const char* key, std::size_t readings) {
  auto columns = json.columns_or_nan(key);
  if (columns.size() != 3) {
    json.refuse(key, fmt::format("of {} lists, expected x, y, z", columns.size()));
  }
  require_columns(json, key, columns, readings);
  return columns;
}

}  // namespace

std::optional<RecordedReadings> recorded_readings(const RecordedObject& identification, std::size_t features) {
  if (!identification.has("residuals")) {
    return std::nullopt;
  }
  const RecordedObject json = identification.object("residuals");
  RecordedReadings readings;
  readings.feature = json.counts("feature");
  const std::size_t count = readings.feature.size();
  require_size(json, "reading", json.size_of("reading"), count);
  for (const std::size_t feature : readings.feature) {
    if (feature >= features) {
      json.refuse("feature",
                  fmt::format("{} for a reading, expected one of the {} in after.features, from 0", feature, features));
    }
  }
  readings.joints = json.columns_or_nan("joints_rad");
  require_columns(json, "joints_rad", readings.joints, count);
  readings.before = json.numbers_or_nan("before_mm");
  require_size(json, "before_mm", readings.before.size(), count);
  readings.after = json.numbers_or_nan("after_mm");
  require_size(json, "after_mm", readings.after.size(), count);
  readings.tip = coordinates(json, "tip_mm", count);
  readings.offset = coordinates(json, "offset_mm", count);
  readings.prismatic = json.has("prismatic_joints") ? json.counts("prismatic_joints") : std::vector<std::size_t>();
  return readings;
}

}  // namespace artcal
