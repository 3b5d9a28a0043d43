#pragma once

#include <limits>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <Eigen/Core>

namespace artcal {

/// Names and their indices, in order of first appearance.
class Labels {
 public:
  int index_of(std::string_view name);                  ///< adds the name if it is new
  [[nodiscard]] int find(std::string_view name) const;  ///< -1 if unknown
  [[nodiscard]] const std::string& name(int index) const { return names_[index]; }
  [[nodiscard]] int size() const { return static_cast<int>(names_.size()); }

 private:
  std::vector<std::string> names_;
  std::unordered_map<std::string, int> index_;
  int last_ = 0;  // what was asked for last: rows come in runs of one label
};

/// One reading's labels and whatever was read beside the joints. The joint angles themselves stand in
/// Recording::joints, a column a reading.
struct Reading {
  static constexpr double not_read = std::numeric_limits<double>::quiet_NaN();

  int artefact = 0;                   ///< into Recording::artefacts
  int placement = 0;                  ///< into Recording::placements
  int feature = 0;                    ///< into Recording::features
  int orientation = 0;                ///< into Recording::orientations: the posture of the wrist, where it is told
  int repeat = 0;                     ///< into Recording::repeats
  int probe = 0;                      ///< into Arm::probes
  double temperature = not_read;      ///< of the artefact, °C; NaN where it was not read
  double arm_temperature = not_read;  ///< of the arm, °C; NaN where it was not read
  double length = not_read;           ///< measured from the tip to the feature's anchor, mm; NaN where there is none
  /// The tip's coordinates by another instrument, mm; NaN where there are none.
  Eigen::Vector3d reference = Eigen::Vector3d::Constant(not_read);
  /// The tip's centre in the base frame as the arm's own software reported it, mm; NaN where it did not.
  Eigen::Vector3d tip = Eigen::Vector3d::Constant(not_read);
  int file = 0;  ///< into Recording::files
  int line = 0;  ///< in that file, from 1
};

}  // namespace artcal
