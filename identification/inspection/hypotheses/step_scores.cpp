#include "identification/inspection/hypotheses/step_scores.h"

#include <algorithm>
#include <numeric>

#include <Eigen/QR>

#include "core/overloaded.h"
#include "identification/identifiability/weak_parameters.h"
#include "identification/initial/nuisance_estimation.h"
#include "identification/least_squares/blocks.h"
#include "identification/least_squares/linearisation.h"
#include "identification/least_squares/rows.h"

namespace artcal {
namespace {

constexpr std::size_t min_on_a_side = 8;  // readings
// Share of a step's own square below which the fit takes all of it up.
constexpr double least_left = 1e-4;

/// Where the rows of a reading are.
struct ReadingRows {
  int block = -1;          ///< -1: the reading binds nothing
  Eigen::Index first = 0;  ///< among all rows
  int dimension = 0;
};

// An orthonormal basis of the columns' span.
Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& columns) {
  if (columns.cols() == 0 || columns.rows() == 0) {
    return Eigen::MatrixXd(columns.rows(), 0);
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(columns);
  return decomposition.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), decomposition.rank());
}

/// The linearised fit row by row: its residuals, what a change of each joint does to them, and orthonormal bases of
/// what the unknowns of each block, and artefact parameters and arm beside them, can take up.
class LinearisedFit {
 public:
  LinearisedFit(const System& system, const Weights& weights, const Unknowns& unknowns)
      : system_(system),
        weights_(weights),
        unknowns_(unknowns),
        kinematics_by_probe_(forward_kinematics_of(system, system.start)),
        of_reading_(system.probes.size()),
        blocks_(blocks_of(*system.constraints)) {
    for (const Block& block : blocks_) {
      first_rows_.push_back(rows_);
      rows_ += static_cast<Eigen::Index>(block.distances.size()) + (block.has_certificate ? block.parameters.size : 0);
      for (const int f : block.features) {
        rows_ += system.constraints->features[f].size() * system.constraints->features[f].dimension();
      }
    }
    first_rows_.push_back(rows_);
    const Eigen::Index priors = system.arm_size();
    common_ = Eigen::MatrixXd::Zero(rows_ + priors, system.shared_size() + system.arm_size());
    common_.bottomRightCorner(priors, priors) = prior_weights(system).asDiagonal();
    residuals_ = Eigen::VectorXd::Zero(rows_ + priors);
    by_joints_ = Eigen::MatrixXd::Zero(rows_, static_cast<Eigen::Index>(system.start.joints.size()));
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      add(static_cast<int>(b));
    }
    common_ = orthonormal_basis(common_);
    residuals_ -= common_ * (common_.transpose() * residuals_).eval();
    squares_ = residuals_.squaredNorm();
  }

  [[nodiscard]] StepScore best_place(int joint, SlipOrder by, const std::vector<int>& order) const {
    StepScore best{joint, by, 0, 0.0};
    std::vector<Eigen::VectorXd> in_blocks;
    for (const Eigen::MatrixXd& own : own_) {
      in_blocks.emplace_back(Eigen::VectorXd::Zero(own.cols()));
    }
    Eigen::VectorXd in_common = Eigen::VectorXd::Zero(common_.cols());
    double product = 0.0;
    double own_square = 0.0;
    double in_blocks_square = 0.0;
    for (std::size_t k = order.size(); k-- > min_on_a_side;) {
      const ReadingRows& rows = of_reading_[static_cast<std::size_t>(order[k])];
      if (rows.block >= 0) {
        const auto step = by_joints_.col(joint).segment(rows.first, rows.dimension);
        const Eigen::MatrixXd& own = own_[static_cast<std::size_t>(rows.block)];
        Eigen::VectorXd& in_block = in_blocks[static_cast<std::size_t>(rows.block)];
        in_blocks_square -= in_block.squaredNorm();
        in_block +=
            own.middleRows(rows.first - first_rows_[static_cast<std::size_t>(rows.block)], rows.dimension).transpose() *
            step;
        in_blocks_square += in_block.squaredNorm();
        in_common += common_.middleRows(rows.first, rows.dimension).transpose() * step;
        product += step.dot(residuals_.segment(rows.first, rows.dimension));
        own_square += step.squaredNorm();
      }
      if (order.size() - k < min_on_a_side || !(own_square > 0.0)) {
        continue;
      }
      const double left = std::max(own_square - in_blocks_square - in_common.squaredNorm(), least_left * own_square);
      if (const double share = product * product / (left * squares_); share > best.share) {
        best.share = share;
        best.place = k;
      }
    }
    return best;
  }

 private:
  // The rows of a block, with what its own unknowns take up projected out.
  void add(int b) {
    const Block& block = blocks_[static_cast<std::size_t>(b)];
    const Constraints& constraints = *system_.constraints;
    const Eigen::Index first = first_rows_[static_cast<std::size_t>(b)];
    const BlockColumns columns(block, system_);
    const BlockPoint point = point_of(block, unknowns_);
    RowMatrix rows = RowMatrix::Zero(first_rows_[static_cast<std::size_t>(b) + 1] - first, columns.all());
    Eigen::Index count = 0;
    const auto add_readings = [&](const FeatureReadings& readings) {
      const auto& [f, feature, residual] = readings;
      weighted_rows(system_, feature, weights_.features[f], kinematics_by_probe_, residual, 0, feature.size(),
                    columns.out(rows.row(count).data()));
      for (int k = 0; k < feature.size(); ++k, count += feature.dimension()) {
        by_joints_.middleRows(first + count, feature.dimension()) = by_joints(f, k, residual);
        of_reading_[static_cast<std::size_t>(feature.readings[k])] = {b, first + count, feature.dimension()};
      }
    };
    const auto add_distance = [&](const BindingDistance& distance) {
      rows(count, columns.residual()) = weighted_distance(
          distance.distance, constraints, weights_.distances[distance.index], point.values, rows.row(count).data());
      ++count;
    };
    const auto add_certificate = [&](const CertifiedParameter& certified) {
      const double weight = weights_.shared[certified.index];
      rows(count, columns.unknowns + certified.column) = weight;
      rows(count, columns.residual()) = weighted_shared(certified.parameter, weight, point.shared[certified.index]);
      ++count;
    };
    for_each_observation(constraints, block, point, Overloaded{add_readings, add_distance, add_certificate});
    const Eigen::MatrixXd own = orthonormal_basis(rows.leftCols(block.unknowns));
    rows -= own * (own.transpose() * rows).eval();
    common_.block(first, block.parameters.first, rows.rows(), block.parameters.size) =
        rows.middleCols(block.unknowns, block.parameters.size);
    common_.block(first, system_.shared_size(), rows.rows(), system_.arm_size()) =
        rows.middleCols(block.nuisance(), system_.arm_size());
    residuals_.segment(first, rows.rows()) = rows.rightCols<1>();
    own_.push_back(own);
  }

  // What a change of each joint does to a reading's weighted residual.
  [[nodiscard]] Eigen::MatrixXd by_joints(int f, int k, const FeatureResidual& residual) const {
    const FeatureConstraint& feature = system_.constraints->features[f];
    const FeatureWeights& weights = weights_.features[f];
    const int reading = feature.readings[k];
    const ForwardKinematics& kinematics = kinematics_by_probe_[system_.probes[reading]];
    Eigen::Matrix3Xd tip_by_joints(3, kinematics.joint_count());
    const Eigen::Vector3d tip = kinematics.tip_by_joints(system_.sines_of(reading), tip_by_joints.data());
    const Residual at = residual.at(k, tip, kinematics.tip_radius(), true);
    const Eigen::Matrix3d whitening =
        weights.matrix.empty() ? Eigen::Matrix3d(weights.scalar[k] * Eigen::Matrix3d::Identity()) : weights.matrix[k];
    return ((whitening * at.by_tip) * tip_by_joints).topRows(feature.dimension());
  }

  const System& system_;
  const Weights& weights_;
  const Unknowns& unknowns_;
  std::vector<ForwardKinematics> kinematics_by_probe_;
  std::vector<ReadingRows> of_reading_;
  std::vector<Block> blocks_;
  std::vector<Eigen::Index> first_rows_;  // of each block, and behind the last
  Eigen::Index rows_ = 0;                 // of observations; those of the prior follow
  std::vector<Eigen::MatrixXd> own_;      // bases, block by block
  Eigen::MatrixXd common_;                // the basis of artefact parameters and arm
  Eigen::MatrixXd by_joints_;
  Eigen::VectorXd residuals_;
  double squares_ = 0.0;
};

}  // namespace

std::vector<int> readings_in_order(const Recording& recording, int joint, SlipOrder by) {
  std::vector<int> order(recording.readings.size());
  std::iota(order.begin(), order.end(), 0);
  if (by == SlipOrder::Angle) {
    std::stable_sort(order.begin(), order.end(),
                     [&](int one, int other) { return recording.joints(joint, one) < recording.joints(joint, other); });
  }
  return order;
}

std::vector<StepScore> score_steps(const System& system, const Weights& weights, const Recording& recording) {
  const auto unknowns = estimate_nuisance_parameters(system, system.start, recording);
  if (!unknowns) {
    return {};
  }
  const LinearisedFit fit(system, weights, *unknowns);
  std::vector<StepScore> scores;
  for (int joint = 0; joint < static_cast<int>(system.start.joints.size()); ++joint) {
    for (const SlipOrder by : {SlipOrder::Time, SlipOrder::Angle}) {
      const StepScore best = fit.best_place(joint, by, readings_in_order(recording, joint, by));
      if (best.share > 0.0) {
        scores.push_back(best);
      }
    }
  }
  std::stable_sort(scores.begin(), scores.end(),
                   [](const StepScore& one, const StepScore& other) { return one.share > other.share; });
  return scores;
}

}  // namespace artcal
