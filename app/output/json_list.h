#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace artcal {

/// A JSON array of what `to_json` makes of each item, in order.
template <typename Items, typename ToJson>
nlohmann::ordered_json json_list(const Items& items, ToJson to_json) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const auto& item : items) {
    json.push_back(to_json(item));
  }
  return json;
}

inline nlohmann::ordered_json point_json(const Eigen::Vector3d& point) { return {point.x(), point.y(), point.z()}; }

}  // namespace artcal
