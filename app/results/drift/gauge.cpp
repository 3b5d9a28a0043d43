#include "app/results/drift/gauge.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/LU>
#include <Eigen/QR>

namespace artcal {
namespace {

using Indices = std::vector<Eigen::Index>;

constexpr double negligible = 1e-9;  // of coefficients, and of a fixed value against itself

bool is_in(const Indices& indices, Eigen::Index index) {
  return std::find(indices.begin(), indices.end(), index) != indices.end();
}

Indices fixed_in(const GaugedParameters& parameters) {
  Indices fixed;
  for (Eigen::Index i = 0; i < parameters.values.size(); ++i) {
    if (!is_in(parameters.estimated, i)) {
      fixed.push_back(i);
    }
  }
  return fixed;
}

// What differs between them at one parameter, in words; empty where nothing does.
std::string difference_at(const GaugedParameters& first, const GaugedParameters& later, Eigen::Index i) {
  const std::string& name = first.names[static_cast<std::size_t>(i)];
  if (is_in(first.estimated, i) != is_in(later.estimated, i)) {
    return fmt::format("{} was identified in one and fixed in the other", name);
  }
  // Both come from files with every digit: fixed at the same value means the same number.
  if (!is_in(first.estimated, i) && first.values[i] != later.values[i]) {
    return fmt::format("{} was fixed at {} and then at {} {}, which others make up for", name, first.values[i],
                       later.values[i], first.is_angle[static_cast<std::size_t>(i)] ? "rad" : "mm");
  }
  return {};
}

std::string difference(const GaugedParameters& first, const GaugedParameters& later) {
  for (Eigen::Index i = 0; i < first.values.size(); ++i) {
    if (std::string text = difference_at(first, later, i); !text.empty()) {
      return text;
    }
  }
  return {};
}

Eigen::MatrixXd in_full(const GaugedParameters& parameters) {
  const Eigen::Index size = parameters.values.size();
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(size, size);
  full(parameters.estimated, parameters.estimated) = parameters.covariance;
  return full;
}

// The rows of the fixed parameters that determine the combinations, one each; empty where they do not.
Indices pivots_among(const Indices& fixed, const Eigen::MatrixXd& combinations) {
  if (combinations.cols() == 0 || static_cast<Eigen::Index>(fixed.size()) < combinations.cols()) {
    return {};
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(combinations(fixed, Eigen::all).transpose());
  qr.setThreshold(negligible);
  if (qr.rank() < combinations.cols()) {
    return {};
  }
  Indices pivots;
  for (Eigen::Index k = 0; k < combinations.cols(); ++k) {
    pivots.push_back(fixed[static_cast<std::size_t>(qr.colsPermutation().indices()(k))]);
  }
  return pivots;
}

// The combinations as columns of which each moves one pivot by 1 and no other; nothing where there are none such.
Eigen::MatrixXd by_pivots(const Eigen::MatrixXd& combinations, const Indices& pivots) {
  if (pivots.empty() || combinations.cols() != static_cast<Eigen::Index>(pivots.size())) {
    return {};
  }
  const Eigen::FullPivLU<Eigen::MatrixXd> at_pivots(combinations(pivots, Eigen::all));
  return at_pivots.isInvertible() ? Eigen::MatrixXd(combinations * at_pivots.inverse()) : Eigen::MatrixXd();
}

// What the third order may leave, of each parameter.
Eigen::VectorXd remainder_of(const GaugedParameters& parameters, const Eigen::VectorXd& moved) {
  double angle = 0.0, length = 0.0;
  for (Eigen::Index i = 0; i < moved.size(); ++i) {
    (parameters.is_angle[static_cast<std::size_t>(i)] ? angle : length) += std::abs(moved[i]);
  }
  const double third = std::pow(angle, 3) / 6.0;
  Eigen::VectorXd remainder = Eigen::VectorXd::Constant(moved.size(), third);
  for (Eigen::Index i = 0; i < moved.size(); ++i) {
    if (!parameters.is_angle[static_cast<std::size_t>(i)]) {
      remainder[i] *= angle > 0.0 ? length / angle : 0.0;
    }
  }
  return remainder;
}

}  // namespace

InGauge in_gauge_of(const GaugedParameters& first, const GaugedParameters& later) {
  InGauge stated;
  if (first.names != later.names) {
    stated.not_comparable = "the arm has other parameters";
    return stated;
  }
  stated.values = later.values;
  stated.not_comparable = difference(first, later);
  if (stated.not_comparable.empty()) {
    stated.covariance = later.covariance;
    return stated;
  }
  const Indices fixed = fixed_in(first);
  const Indices pivots = pivots_among(fixed, later.unidentifiable);
  const Eigen::MatrixXd there = by_pivots(later.unidentifiable, pivots);
  const Eigen::MatrixXd here = by_pivots(first.unidentifiable, pivots);
  if (there.size() == 0 || here.size() == 0) {
    return stated;
  }
  const Eigen::MatrixXd combinations = 0.5 * (here + there);
  const Eigen::VectorXd steps = first.values(pivots) - later.values(pivots);
  const Eigen::VectorXd moved = combinations * steps;
  const Eigen::VectorXd values = later.values + moved;
  for (const Eigen::Index i : fixed) {
    if (std::abs(values[i] - first.values[i]) > negligible * (1.0 + std::abs(first.values[i]))) {
      return stated;
    }
    if (later.values[i] != first.values[i]) {
      stated.moved.push_back(first.names[static_cast<std::size_t>(i)]);
    }
  }
  Eigen::MatrixXd projection = Eigen::MatrixXd::Identity(values.size(), values.size());
  projection(Eigen::all, pivots) -= combinations;
  const Eigen::MatrixXd full = projection * in_full(later) * projection.transpose();
  stated.covariance = full(first.estimated, first.estimated);
  if (!(stated.covariance.diagonal().array() > 0.0).all()) {
    return stated;  // something that is estimated in the first only
  }
  if ((here - there).cwiseAbs().maxCoeff() > negligible) {
    const Eigen::VectorXd remainder = remainder_of(first, moved)(first.estimated);
    stated.covariance.diagonal() += remainder.cwiseAbs2();
  }
  stated.values = values;
  stated.not_comparable.clear();
  return stated;
}

}  // namespace artcal
