#include "identification/identifiability/common_scale.h"

#include <algorithm>

#include <Eigen/QR>

#include "core/contains.h"

namespace artcal {
namespace {

// Relative to the growth: what is seen of it by rounding.
constexpr double not_seen = 1e-6;
// A length that stands for the scale has at least this share of the longest one.
constexpr double long_enough = 1e-2;
// Of 1 − (the part of a parameter in the null space)²: it is not identifiable whatever the others are.
constexpr double by_itself = 1e-10;

// A length taken as known fixes the scale even if no reading does.
bool scale_is_asked(const Arm& arm, const std::vector<Parameter>& asked) {
  const auto all = parameters_of(arm);
  return std::all_of(all.begin(), all.end(), [&](const Parameter& parameter) {
    return !parameter.is_length() || value(arm, parameter) == 0.0 || find_parameter(asked, parameter.name) >= 0;
  });
}

Eigen::Index count_terms(const Eigen::MatrixXd& motions) {
  Eigen::Index count = 0;
  for (const auto& motion : motions.colwise()) {
    count += (motion.array().abs() > no_part * motion.cwiseAbs().maxCoeff()).count();
  }
  return count;
}

// The scale without the lengths that are not identifiable by themselves.
Eigen::VectorXd scale_beside_single(const Eigen::MatrixXd& null_space, Eigen::VectorXd scale) {
  for (Eigen::Index i = 0; i < scale.size(); ++i) {
    if (1.0 - null_space.row(i).squaredNorm() < by_itself) {
      scale[i] = 0.0;
    }
  }
  return scale;
}

}  // namespace

Eigen::VectorXd scale_motion(const Arm& arm, const std::vector<Parameter>& parameters, const Eigen::VectorXd& scale) {
  Eigen::VectorXd motion = Eigen::VectorXd::Zero(scale.size());
  for (Eigen::Index i = 0; i < motion.size(); ++i) {
    const double size = value(arm, parameters[i]) / scale[i];
    motion[i] = parameters[i].is_length() ? size : parameters[i].kind == ParameterKind::Compliance ? -size : 0.0;
  }
  return motion;
}

Eigen::VectorXd unidentifiable_scale(const Arm& arm, const std::vector<Parameter>& parameters,
                                     const Eigen::VectorXd& expansion_factor, const Eigen::MatrixXd& null_space) {
  if (null_space.cols() == 0 || expansion_factor.norm() == 0.0 || !scale_is_asked(arm, parameters)) {
    return {};
  }
  Eigen::MatrixXd unseen = null_space;
  for (Eigen::Index i = 0; i < expansion_factor.size(); ++i) {
    if (parameters[i].kind == ParameterKind::Radius) {
      unseen.conservativeResize(expansion_factor.size(), unseen.cols() + 1);
      unseen.rightCols<1>() = Eigen::VectorXd::Unit(expansion_factor.size(), i);
    }
  }
  const Eigen::VectorXd parts = unseen.completeOrthogonalDecomposition().solve(expansion_factor);
  if ((expansion_factor - unseen * parts).norm() >= not_seen * expansion_factor.norm()) {
    return {};
  }
  return null_space * parts.head(null_space.cols());
}

SimplestDirections simplest_directions(const Eigen::MatrixXd& null_space, const Eigen::VectorXd& tolerances,
                                       const FixingOrder& order, const Eigen::VectorXd& unidentifiable_scale) {
  SimplestDirections simplest;
  if (unidentifiable_scale.size() > 0) {
    const Eigen::VectorXd scale = scale_beside_single(null_space, unidentifiable_scale);
    const double longest = scale.cwiseAbs().maxCoeff();
    // Where each length is unidentifiable by itself, nothing is left of the scale but rounding.
    const bool is_left = longest > no_part * unidentifiable_scale.cwiseAbs().maxCoeff();
    Eigen::Index fewest = 0;
    for (int i = 0; is_left && i < static_cast<int>(scale.size()); ++i) {
      if (std::abs(scale[i]) < long_enough * longest || contains(order.last, i)) {
        continue;
      }
      FixedParameters fixed = choose_fixed(null_space, tolerances, order, {i});
      const Eigen::Index terms = count_terms(fixed.motions.rightCols(fixed.motions.cols() - 1));
      if (simplest.fixed.indices.empty() || terms < fewest) {
        fewest = terms;
        simplest.fixed = std::move(fixed);
      }
    }
    if (!simplest.fixed.indices.empty()) {
      auto& [indices, motions] = simplest.fixed;
      std::rotate(indices.begin(), indices.begin() + 1, indices.end());
      const Eigen::VectorXd of_scale = motions.col(0);
      motions.leftCols(motions.cols() - 1) = motions.rightCols(motions.cols() - 1).eval();
      motions.rightCols<1>() = of_scale;
      simplest.shown = motions;
      simplest.shown.rightCols<1>() = scale / scale[indices.back()];
      return simplest;
    }
  }
  simplest.fixed = choose_fixed(null_space, tolerances, order);
  simplest.shown = simplest.fixed.motions;
  return simplest;
}

}  // namespace artcal
