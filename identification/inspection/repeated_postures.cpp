#include "identification/inspection/repeated_postures.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include <fmt/format.h>

namespace artcal {
namespace {

constexpr double same_angle = 1e-6;  // rad: 0.2 arcsec, and a table with five decimals of a degree
constexpr int min_joints = 4;        // of fewer joints a posture may be met again by chance
// A reading on a small feature may be met again by chance; several are not.
constexpr int min_repeated = 2;

bool same_posture(const Eigen::MatrixXd& joints, Eigen::Index one, Eigen::Index other) {
  return (joints.col(one) - joints.col(other)).cwiseAbs().maxCoeff() <= same_angle;
}

}  // namespace

Findings find_repeated_postures(const Recording& recording) {
  const Eigen::MatrixXd& joints = recording.joints;
  if (joints.rows() < min_joints || joints.cols() < 2) {
    return {};
  }
  std::vector<Eigen::Index> order;
  for (Eigen::Index i = 0; i < joints.cols(); ++i) {
    if (joints.col(i).allFinite()) {
      order.push_back(i);
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index one, Eigen::Index other) { return joints(0, one) < joints(0, other); });
  std::vector<Eigen::Index> repeats(static_cast<std::size_t>(joints.cols()), -1);
  // Readings are near one another in the order of the first joint; a scan at rest is not compared pair by
  // pair, since a reading that repeats another is passed over.
  for (std::size_t a = 0; a < order.size(); ++a) {
    for (std::size_t b = a + 1; b < order.size() && repeats[static_cast<std::size_t>(order[a])] < 0 &&
                                joints(0, order[b]) - joints(0, order[a]) <= same_angle;
         ++b) {
      if (same_posture(joints, order[a], order[b])) {
        const auto [first, second] = std::minmax(order[a], order[b]);
        Eigen::Index& repeated = repeats[static_cast<std::size_t>(second)];
        repeated = repeated < 0 ? first : std::min(repeated, first);
      }
    }
  }
  const auto count = std::count_if(repeats.begin(), repeats.end(), [](Eigen::Index i) { return i >= 0; });
  if (count < min_repeated) {
    return {};
  }
  const auto found = std::find_if(repeats.begin(), repeats.end(), [](Eigen::Index i) { return i >= 0; });
  const auto reading = static_cast<int>(found - repeats.begin());
  return {{FindingKind::RepeatedReadings, recording.where(reading),
           fmt::format("{} of {} readings have the joint angles of an earlier one to a microradian (this one those of "
                       "{}); two touches of an arm do not agree so. Remove the rows that were copied, or the table "
                       "that holds readings of another",
                       count, joints.cols(), recording.where(static_cast<int>(*found)))}};
}

}  // namespace artcal
