#include "identification/reported_coordinates/joint_assignment.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "acquisition/arm/forward_kinematics.h"
#include "core/kabsch.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr Eigen::Index max_scored = 40;           // readings that judge an assignment
constexpr Eigen::Index max_scored_permuted = 12;  // among up to 1,935,360
constexpr std::size_t max_combined_signs = 10;    // joints
constexpr std::size_t max_permuted = 7;           // joints

// Readings spread over the recording.
std::vector<Eigen::Index> scored_readings(Eigen::Index readings, bool permuted) {
  const Eigen::Index count = std::min(readings, permuted ? max_scored_permuted : max_scored);
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index i = 0; i < count; ++i) {
    chosen.push_back(i * readings / count);
  }
  return chosen;
}

double mean_square(const Eigen::Matrix3Xd& tips, const Eigen::Matrix3Xd& coordinates, bool base_frame_is_known) {
  if (base_frame_is_known) {
    return (tips - coordinates).squaredNorm() / static_cast<double>(tips.cols());
  }
  const Eigen::Matrix3Xd from = tips.colwise() - tips.rowwise().mean();
  const Eigen::Matrix3Xd to = coordinates.colwise() - coordinates.rowwise().mean();
  const Eigen::Matrix3d rotation = rotation_of_moment(to * from.transpose()).rotation;
  return (rotation * from - to).squaredNorm() / static_cast<double>(tips.cols());
}

// Factors of the unit that may be meant: no joint turns by more than some turns, or by less than a degree in all.
std::vector<double> possible_factors(const Arm& arm, const Eigen::MatrixXd& columns) {
  double largest = 0.0;
  for (std::size_t i = 0; i < arm.joints.size(); ++i) {
    if (!arm.joints[i].is_prismatic()) {
      largest = std::max(largest, columns.row(static_cast<Eigen::Index>(i)).cwiseAbs().maxCoeff());
    }
  }
  std::vector<double> factors{1.0};
  for (const double factor : {1.0 / units::degree, units::degree}) {
    if (factor * largest > units::degree && factor * largest < 1000.0 * units::degree) {
      factors.push_back(factor);
    }
  }
  return factors;
}

// Which joints count the other way, as bits: all combinations, of more joints than any maker's arm has one at a time.
std::vector<std::size_t> possible_signs(std::size_t joints) {
  std::vector<std::size_t> signs{0};
  if (joints <= max_combined_signs) {
    signs.resize(std::size_t{1} << joints);
    std::iota(signs.begin(), signs.end(), std::size_t{0});
    return signs;
  }
  for (std::size_t i = 0; i < joints; ++i) {
    signs.push_back(std::size_t{1} << i);
  }
  return signs;
}

bool exchanges_types(const Arm& arm, const std::vector<int>& column) {
  for (std::size_t i = 0; i < column.size(); ++i) {
    if (arm.joints[i].type != arm.joints[static_cast<std::size_t>(column[i])].type) {
      return true;
    }
  }
  return false;
}

}  // namespace

bool JointAssignment::keeps_order() const { return std::is_sorted(column.begin(), column.end()); }

bool JointAssignment::changes_nothing() const {
  return keeps_order() && factor == 1.0 && std::all_of(sign.begin(), sign.end(), [](double s) { return s > 0.0; });
}

Eigen::MatrixXd assigned(const JointAssignment& assignment, const Arm& arm, const Eigen::MatrixXd& columns) {
  Eigen::MatrixXd joints(columns.rows(), columns.cols());
  for (std::size_t i = 0; i < assignment.column.size(); ++i) {
    const double factor = arm.joints[i].is_prismatic() ? 1.0 : assignment.factor;
    joints.row(static_cast<Eigen::Index>(i)) = factor * assignment.sign[i] * columns.row(assignment.column[i]);
  }
  return joints;
}

std::vector<JointAssignment> likely_assignments(const Arm& nominal, const Eigen::MatrixXd& columns,
                                                const Eigen::Matrix3Xd& coordinates, const std::vector<int>& probes,
                                                bool base_frame_is_known, bool permuted, std::size_t count) {
  const std::size_t joints = nominal.joints.size();
  std::vector<ForwardKinematics> kinematics;
  for (int probe = 0; probe < static_cast<int>(nominal.probes.size()); ++probe) {
    kinematics.emplace_back(nominal, std::vector<Parameter>{}, probe);
  }
  const auto readings = scored_readings(columns.cols(), permuted);
  const Eigen::Matrix3Xd reported = coordinates(Eigen::all, readings);
  Eigen::Matrix3Xd tips(3, reported.cols());
  std::vector<double> sines(2 * joints);
  std::vector<std::pair<double, JointAssignment>> best;
  JointAssignment trial;
  trial.column.resize(joints);
  trial.sign.resize(joints);
  std::iota(trial.column.begin(), trial.column.end(), 0);
  const auto factors = possible_factors(nominal, columns);
  const auto all_signs = possible_signs(joints);
  const Eigen::MatrixXd some = columns(Eigen::all, readings);
  do {
    if (exchanges_types(nominal, trial.column)) {
      continue;
    }
    for (const double factor : factors) {
      trial.factor = factor;
      for (const std::size_t signs : all_signs) {
        for (std::size_t i = 0; i < joints; ++i) {
          trial.sign[i] = (signs >> i & 1U) != 0 ? -1.0 : 1.0;
        }
        const Eigen::MatrixXd q = assigned(trial, nominal, some);
        for (Eigen::Index k = 0; k < q.cols(); ++k) {
          const std::span<const double> angles(q.col(k).data(), joints);
          joint_sines(angles, sines);
          const auto reading = static_cast<std::size_t>(readings[static_cast<std::size_t>(k)]);
          tips.col(k) = kinematics[static_cast<std::size_t>(probes[reading])].tip_in_base({sines, angles});
        }
        const double score = mean_square(tips, reported, base_frame_is_known);
        if (best.size() == count && !(score < best.back().first)) {
          continue;
        }
        const auto at = std::upper_bound(best.begin(), best.end(), score,
                                         [](double value, const auto& each) { return value < each.first; });
        best.emplace(at, score, trial);
        best.resize(std::min(best.size(), count));
      }
    }
  } while (permuted && joints <= max_permuted && std::next_permutation(trial.column.begin(), trial.column.end()));
  std::vector<JointAssignment> assignments;
  for (auto& [score, assignment] : best) {
    assignments.push_back(std::move(assignment));
  }
  return assignments;
}

}  // namespace artcal
