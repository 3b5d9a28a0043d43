#include "artefacts/verification/sphere_plate/pattern_match.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "artefacts/verification/sphere_plate/rigid_fit.h"

namespace artcal {
namespace {

// Of the rms as named. Where few points say little against chance, the difference must be gross.
double far_better(Eigen::Index points) { return points >= 9 ? 0.5 : 0.1; }
constexpr double near_share = 0.1;    // of the smallest distance between points: what still counts as the same place
constexpr int max_candidates = 4000;  // triples that are tried in full

using Order = std::vector<int>;

Eigen::Matrix3Xd columns_in_order(const Eigen::Matrix3Xd& points, const Order& order) {
  Eigen::Matrix3Xd chosen(3, static_cast<Eigen::Index>(order.size()));
  for (std::size_t i = 0; i < order.size(); ++i) {
    chosen.col(static_cast<Eigen::Index>(i)) = points.col(order[i]);
  }
  return chosen;
}

double smallest_distance(const Eigen::Matrix3Xd& points) {
  double smallest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    for (Eigen::Index j = i + 1; j < points.cols(); ++j) {
      smallest = std::min(smallest, (points.col(i) - points.col(j)).norm());
    }
  }
  return smallest;
}

// The measured points that span the widest triangle found greedily: the first, the farthest, the farthest off.
Order wide_triple(const Eigen::Matrix3Xd& points) {
  const auto farthest = [&](auto&& distance) {
    Eigen::Index best = 0;
    double most = -1.0;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      if (const double d = distance(points.col(i)); d > most) {
        most = d;
        best = i;
      }
    }
    return static_cast<int>(best);
  };
  const int a = 0;
  const int b = farthest([&](const Eigen::Vector3d& p) { return (p - points.col(a)).norm(); });
  const Eigen::Vector3d along = (points.col(b) - points.col(a)).normalized();
  const int c = farthest([&](const Eigen::Vector3d& p) { return (p - points.col(a)).cross(along).norm(); });
  return {a, b, c};
}

// Each measured point's certified one under this pose, all different and near enough; or nothing.
std::optional<Order> assigned(const Eigen::Matrix3Xd& measured, const Eigen::Matrix3Xd& certified,
                              const Rigid& measured_from_certified, double near) {
  const Eigen::Matrix3Xd moved =
      (measured_from_certified.rotation * certified).colwise() + measured_from_certified.translation;
  Order order;
  std::set<Eigen::Index> taken;
  for (Eigen::Index i = 0; i < measured.cols(); ++i) {
    Eigen::Index nearest = 0;
    const double distance = (moved.colwise() - measured.col(i)).colwise().squaredNorm().minCoeff(&nearest);
    if (distance > near * near || !taken.insert(nearest).second) {
      return std::nullopt;
    }
    order.push_back(static_cast<int>(nearest));
  }
  return order;
}

struct Candidate {
  Order order;
  double rms = 0.0;
};

double rms_of(const Eigen::Matrix3Xd& measured, const Eigen::Matrix3Xd& certified) {
  const auto fit = fit_rigid(measured, certified);
  return fit ? fit->rms : std::numeric_limits<double>::infinity();
}

// The assignment of least rms among those that carry one wide triangle of measured points to certified ones.
std::optional<Candidate> best_order(const Eigen::Matrix3Xd& measured, const Eigen::Matrix3Xd& certified) {
  const double near = near_share * smallest_distance(certified);
  const Order triple = wide_triple(measured);
  const Eigen::Matrix3Xd corner = columns_in_order(measured, triple);
  const auto fits = [&](int i, int j, int a, int b) {
    return std::abs((certified.col(i) - certified.col(j)).norm() - (corner.col(a) - corner.col(b)).norm()) < near;
  };
  const auto count = static_cast<int>(certified.cols());
  std::optional<Candidate> best;
  int tried = 0;
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      if (i == j || !fits(i, j, 0, 1)) continue;
      for (int k = 0; k < count; ++k) {
        if (k == i || k == j || !fits(i, k, 0, 2) || !fits(j, k, 1, 2) || ++tried > max_candidates) continue;
        const auto pose = fit_rigid(corner, columns_in_order(certified, {i, j, k}));
        const auto order = pose ? assigned(measured, certified, pose->to_from, 2.0 * near) : std::nullopt;
        if (!order) continue;
        const double rms = rms_of(measured, columns_in_order(certified, *order));
        if (!best || rms < best->rms) {
          best = Candidate{*order, rms};
        }
      }
    }
  }
  return best;
}

bool is_flat(const Eigen::Matrix3Xd& points, double near) {
  const Eigen::Matrix3Xd centred = points.colwise() - points.rowwise().mean();
  return Eigen::JacobiSVD<Eigen::Matrix3Xd>(centred).singularValues()(2) < near * std::sqrt(double(points.cols()));
}

// Whether an order turns a flat pattern's plane over: the best map of the plane onto itself is a reflection.
bool turns_over(const Eigen::Matrix3Xd& certified, const Order& order) {
  const Eigen::Matrix3Xd named = certified.leftCols(static_cast<Eigen::Index>(order.size()));
  const Eigen::Matrix3Xd a = columns_in_order(certified, order);
  const Eigen::Matrix3Xd from = named.colwise() - named.rowwise().mean();
  const Eigen::Matrix3Xd to = a.colwise() - a.rowwise().mean();
  const Eigen::Matrix3d plane = Eigen::JacobiSVD<Eigen::Matrix3Xd>(from, Eigen::ComputeFullU).matrixU();
  const Eigen::Matrix2d map =
      (plane.leftCols<2>().transpose() * to) * (plane.leftCols<2>().transpose() * from).transpose();
  return map.determinant() < 0.0;
}

// The points that one pose of three of them carries near their names, largest set first found.
Order largest_set(const Eigen::Matrix3Xd& measured, const Eigen::Matrix3Xd& certified, const Order& among,
                  double near) {
  Order largest;
  for (std::size_t i = 0; i + 2 < among.size(); ++i) {
    const Order triple{among[i], among[i + 1], among[i + 2]};
    const auto pose = fit_rigid(columns_in_order(measured, triple), columns_in_order(certified, triple));
    if (!pose) continue;
    Order set;
    for (const int point : among) {
      if ((measured.col(point) - pose->to_from * Eigen::Vector3d(certified.col(point))).norm() < near) {
        set.push_back(point);
      }
    }
    if (set.size() > largest.size()) {
      largest = set;
    }
  }
  return largest;
}

std::optional<PatternFinding> two_poses(const Eigen::Matrix3Xd& measured, const Eigen::Matrix3Xd& certified, double rms,
                                        double near) {
  Order all;
  for (int i = 0; i < static_cast<int>(measured.cols()); ++i) {
    all.push_back(i);
  }
  const Order first = largest_set(measured, certified, all, near);
  Order rest;
  std::set_difference(all.begin(), all.end(), first.begin(), first.end(), std::back_inserter(rest));
  if (first.size() < 3 || rest.size() < 3) {
    return std::nullopt;
  }
  const double apart = std::hypot(rms_of(columns_in_order(measured, first), columns_in_order(certified, first)),
                                  rms_of(columns_in_order(measured, rest), columns_in_order(certified, rest)));
  if (!(apart < 0.2 * rms)) {
    return std::nullopt;
  }
  return PatternFinding{PatternFinding::Kind::TwoPoses, {}, rest, rms, apart};
}

}  // namespace

std::optional<PatternFinding> find_misnaming(const Eigen::Matrix3Xd& measured, const Eigen::Matrix3Xd& certified,
                                             const Eigen::Matrix3Xd& others) {
  const auto named = fit_rigid(measured, certified);
  if (!named) {
    return std::nullopt;
  }
  Eigen::Matrix3Xd all(3, certified.cols() + others.cols());
  all << certified, others;
  const double near = near_share * smallest_distance(all);
  const bool flat = is_flat(certified, near);
  if (!flat) {
    const auto mirrored = fit_mirrored(measured, certified);
    if (mirrored && mirrored->rms < far_better(certified.cols()) * named->rms) {
      return PatternFinding{PatternFinding::Kind::Mirrored, {}, {}, named->rms, mirrored->rms};
    }
  }
  if (const auto best = best_order(measured, all); best && best->rms < far_better(certified.cols()) * named->rms) {
    const auto kind =
        flat && turns_over(all, best->order) ? PatternFinding::Kind::Mirrored : PatternFinding::Kind::OtherOrder;
    return PatternFinding{kind, best->order, {}, named->rms, best->rms};
  }
  return named->rms > near ? two_poses(measured, certified, named->rms, near) : std::nullopt;
}

}  // namespace artcal
