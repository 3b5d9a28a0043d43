#include "identification/uncertainty/redundancy.h"

#include <algorithm>
#include <optional>

#include "core/overloaded.h"
#include "identification/least_squares/rows.h"
#include "identification/monte_carlo/arrow_factor.h"
#include "identification/uncertainty/fit_spread.h"

namespace artcal {
namespace {

constexpr int readings_of_a_block = 64;

bool all_count(const LossWeights& weights) {
  const auto is_one = [](double weight) { return weight == 1.0; };
  const auto all = [&](const std::vector<double>& values) { return std::all_of(values.begin(), values.end(), is_one); };
  return all(weights.distances) && all(weights.shared) &&
         std::all_of(weights.readings.begin(), weights.readings.end(), all);
}

/// The checks of observations, block by block.
class Checking {
 public:
  Checking(const System& system, const Linearisation& linearisation)
      : arm_size_(system.arm_size()), factor_(ArrowFactor::of(linearisation)) {}
  Checking(const Checking&) = delete;  // spread_ refers to factor_
  Checking& operator=(const Checking&) = delete;

  /// For loss weights that are not all 1: `squared` is the linearisation with rows multiplied by them, so that its RᵀR
  /// is AᵀW²A.
  void set_squared(const Linearisation& squared) {
    if (factor_) {
      spread_.emplace(*factor_, squared, arm_size_);
    }
  }

  /// Of observations of `dimension` rows each, one below the other; `weight(i)` is the i-th one's.
  template <typename Weight>
  void append(const Block& block, const Eigen::Ref<const Eigen::MatrixXd>& rows, int dimension, Weight&& weight,
              std::vector<Check>& checks) const {
    const Eigen::MatrixXd half = factor_ ? factor_->half_solved(block, rows) : Eigen::MatrixXd();
    const Eigen::MatrixXd solved = factor_ && spread_ ? factor_->fully_solved(block, half) : Eigen::MatrixXd();
    for (Eigen::Index i = 0; i * dimension < rows.rows(); ++i) {
      Check& check = checks.emplace_back(Check{1.0, static_cast<double>(dimension)});
      if (!factor_) {
        continue;
      }
      const double w = weight(static_cast<std::size_t>(i));
      const auto own = half.middleCols(i * dimension, dimension);
      const Eigen::MatrixXd hat = own.transpose() * own;
      const Eigen::MatrixXd covariance =
          Eigen::MatrixXd::Identity(dimension, dimension) - 2.0 * w * hat +
          (spread_ ? spread_->of(block, solved.middleCols(i * dimension, dimension)) : hat);
      const double trace = covariance.trace();
      check.variance = std::max(0.0, trace / dimension);
      const double square = covariance.squaredNorm();
      check.freedom = square > 0.0 ? std::clamp(trace * trace / square, 1.0, static_cast<double>(dimension)) : 1.0;
      check.leverage = hat.trace() / dimension;
      check.influence = w * own.bottomRows(arm_size_).squaredNorm();
    }
  }

 private:
  int arm_size_;
  Expected<ArrowFactor> factor_;
  std::optional<FitSpread> spread_;
};

}  // namespace

LossWeights loss_weights(const Constraints& constraints, const Weights& weights, Loss loss,
                         const WhitenedResiduals& residuals) {
  LossWeights slopes;
  for (std::size_t f = 0; f < constraints.features.size(); ++f) {
    const FeatureConstraint& feature = constraints.features[f];
    const int dimension = feature.dimension();
    auto& of_readings = slopes.readings.emplace_back();
    for (int k = 0; k < feature.size(); ++k) {
      const double squares =
          Eigen::VectorXd::Map(residuals.readings[f].data() + k * dimension, dimension).squaredNorm();
      of_readings.push_back(loss_of(loss, squares, expected_square(weights.features[f], k, dimension)).slope);
    }
  }
  std::size_t binding = 0;
  for (std::size_t d = 0; d < constraints.distances.size(); ++d) {
    const double r = constraints.distances[d].binds ? residuals.distances[binding++] : 0.0;
    slopes.distances.push_back(
        loss_reaches_distances(loss, weights) ? loss_of(loss, r * r, weights.distance_variance[d]).slope : 1.0);
  }
  for (std::size_t s = 0; s < constraints.shared.size(); ++s) {
    const double r = residuals.shared[s];
    slopes.shared.push_back(loss_reaches_shared(loss, weights) ? loss_of(loss, r * r, weights.shared_variance[s]).slope
                                                               : 1.0);
  }
  return slopes;
}

Weights multiplied(Weights weights, const LossWeights& by) {
  for (std::size_t f = 0; f < weights.features.size(); ++f) {
    FeatureWeights& feature = weights.features[f];
    feature.variance.clear();
    for (std::size_t k = 0; k < by.readings[f].size(); ++k) {
      if (feature.matrix.empty()) {
        feature.scalar[k] *= by.readings[f][k];
      } else {
        feature.matrix[k] *= by.readings[f][k];
      }
    }
  }
  for (std::size_t d = 0; d < weights.distances.size(); ++d) {
    weights.distances[d] *= by.distances[d];
  }
  for (std::size_t s = 0; s < weights.shared.size(); ++s) {
    weights.shared[s] *= by.shared[s];
  }
  weights.distance_variance.clear();
  weights.shared_variance.clear();
  return weights;
}

Redundancy redundancy_of(const System& system, const Weights& weights, const LossWeights& counted,
                         const Linearisation& linearisation, const Arm& arm, const Unknowns& unknowns) {
  const Constraints& constraints = *system.constraints;
  Checking checking(system, linearisation);
  if (!all_count(counted)) {
    checking.set_squared(linearise(system, multiplied(weights, counted), Loss::None, arm, unknowns));
  }
  const auto kinematics_by_probe = forward_kinematics_of(system, arm);
  const auto blocks = blocks_of(constraints);
  Redundancy redundancy;
  redundancy.readings.resize(constraints.features.size());
  redundancy.distances.resize(constraints.distances.size());
  redundancy.shared.resize(constraints.shared.size());
  for (const Block& block : blocks) {
    const BlockPoint point = point_of(block, unknowns);
    const BlockColumns columns(block, system);
    RowMatrix rows(3 * readings_of_a_block, columns.all());
    const auto check_readings = [&](const FeatureReadings& readings) {
      const auto& [f, feature, residual] = readings;
      rows.leftCols(columns.nuisance()).setZero();
      for (int first = 0; first < feature.size(); first += readings_of_a_block) {
        const int count = std::min(readings_of_a_block, feature.size() - first);
        weighted_rows(system, feature, weights.features[f], kinematics_by_probe, residual, first, count,
                      columns.out(rows.data()));
        const std::vector<double>& own = counted.readings[f];
        checking.append(
            block, rows.topLeftCorner(count * feature.dimension(), columns.fitted()), feature.dimension(),
            [&](std::size_t i) { return own[static_cast<std::size_t>(first) + i]; }, redundancy.readings[f]);
      }
    };
    const auto check_of = [&](const RowMatrix& row, double weight) {
      std::vector<Check> one;
      checking.append(
          block, row, 1, [&](std::size_t) { return weight; }, one);
      return one.front();
    };
    const auto check_distance = [&](const BindingDistance& distance) {
      const auto d = static_cast<std::size_t>(distance.index);
      RowMatrix row = RowMatrix::Zero(1, columns.fitted());
      weighted_distance(distance.distance, constraints, weights.distances[d], point.values, row.data());
      redundancy.distances[d] = check_of(row, counted.distances[d]);
    };
    const auto check_certificate = [&](const CertifiedParameter& certified) {
      const auto s = static_cast<std::size_t>(certified.index);
      RowMatrix row = RowMatrix::Zero(1, columns.fitted());
      row(0, columns.unknowns + certified.column) = weights.shared[s];
      redundancy.shared[s] = check_of(row, counted.shared[s]);
    };
    for_each_observation(constraints, block, point, Overloaded{check_readings, check_distance, check_certificate});
  }
  return redundancy;
}

}  // namespace artcal
