#include "identification/initial/plane_start.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>

namespace artcal {
namespace {

// Of what the possible sides differ by: a certified distance missed by more does not determine the side.
constexpr double told_clearly = 0.45;

// The stylus shows the side of a plane where this many readings have it on one side, so far from the plane on average.
constexpr int min_styluses = 6;
constexpr double min_stylus_cosine = 0.3;
constexpr double max_contrary_styluses = 0.1;  // as a share: the axis is not known well yet

/// A certified distance between two planes of the group, by their places in it.
struct Between {
  std::size_t first = 0, second = 0;
  double value = 0.0;
};

std::vector<Between> distances_between(const std::vector<Tips>& planes, const Constraints& constraints) {
  const auto place_of = [&](int feature) {
    for (std::size_t i = 0; i < planes.size(); ++i) {
      if (planes[i].feature == &constraints.features[feature]) {
        return i;
      }
    }
    return planes.size();
  };
  std::vector<Between> found;
  for (const DistanceConstraint& distance : constraints.distances) {
    const Between between{place_of(distance.first), place_of(distance.second), distance.value};
    if (between.first < planes.size() && between.second < planes.size()) {
      found.push_back(between);
    }
  }
  return found;
}

// The readings' scatter about the mean of their own plane and tip radius.
Eigen::Matrix3d scatter_of(const std::vector<Tips>& planes) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const Tips& plane : planes) {
    std::map<double, std::vector<Eigen::Index>> by_radius;
    for (Eigen::Index k = 0; k < plane.radii.size(); ++k) {
      by_radius[plane.radii[k]].push_back(k);
    }
    for (const auto& [radius, readings] : by_radius) {
      const Eigen::Matrix3Xd tips = plane.centres(Eigen::all, readings);
      const Eigen::Matrix3Xd about = tips.colwise() - Eigen::Vector3d(tips.rowwise().mean());
      scatter += about * about.transpose();
    }
  }
  return scatter;
}

/// What one plane is on either side.
struct Placed {
  double place = 0.0;
  double squares = 0.0;  ///< of its readings about it
};

Placed placed(const Tips& plane, const Eigen::Vector3d& axis, const Eigen::Vector3d& origin, double side) {
  const Eigen::VectorXd heights =
      (axis.transpose() * (plane.centres.colwise() - origin)).transpose() - side * plane.radii;
  const double place = heights.mean();
  return {place, (heights.array() - place).square().sum()};
}

/// Sides of all planes, and how badly they explain readings and distances.
struct Sides {
  std::vector<double> of;
  double cost = 0.0;
};

using BothSides = std::array<Placed, 2>;
const Placed& on(const BothSides& plane, double side) { return plane[side > 0.0 ? 1 : 0]; }

// Of two planes' outward normals; 0 where one of them is not certified.
double cosine_between(const Tips& first, const Tips& second) {
  const auto& one = first.feature->as<OnPlane>()->normal;
  const auto& other = second.feature->as<OnPlane>()->normal;
  return one && other ? one->dot(*other) : 0.0;
}

// From the first plane's side to those of the others, along the certified distances.
Sides spread(double first_side, const std::vector<Tips>& planes, const std::vector<BothSides>& places,
             const std::vector<Between>& distances) {
  Sides sides{std::vector<double>(planes.size(), 0.0), on(places[0], first_side).squares};
  sides.of[0] = first_side;
  const auto reach_from = [&](std::size_t from, std::size_t to, double value) {
    if (sides.of[from] == 0.0 || sides.of[to] != 0.0) {
      return false;
    }
    const double cosine = cosine_between(planes[from], planes[to]);
    double least = std::numeric_limits<double>::infinity();
    for (const double side : {1.0, -1.0}) {
      if (cosine * side * sides.of[from] < 0.0) {
        continue;  // the certificate says otherwise
      }
      const double miss = std::abs(on(places[to], side).place - on(places[from], sides.of[from]).place) - value;
      if (const double cost = miss * miss + on(places[to], side).squares; cost < least) {
        least = cost;
        sides.of[to] = side;
      }
    }
    sides.cost += least;
    return true;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (const Between& between : distances) {
      changed |= reach_from(between.first, between.second, between.value);
      changed |= reach_from(between.second, between.first, between.value);
    }
  }
  return sides;
}

// The side of each plane by the stylus, which cannot come out of the material: against the outward normal. Nothing
// where it does not show for each plane, because the readings are few or the stylus lay along the plane.
std::optional<std::vector<double>> sides_by_stylus(const std::vector<Tips>& planes, const Eigen::Vector3d& axis) {
  std::vector<double> sides;
  for (const Tips& plane : planes) {
    const Eigen::ArrayXd along = (axis.transpose() * plane.styluses).transpose().array();
    const double side = along.mean() < 0.0 ? 1.0 : -1.0;
    if (plane.feature->size() < min_styluses || std::abs(along.mean()) < min_stylus_cosine ||
        static_cast<double>((side * along > 0.0).count()) > max_contrary_styluses * plane.feature->size()) {
      return std::nullopt;
    }
    sides.push_back(side);
  }
  return sides;
}

// Whether a distance is met well enough to determine the sides of its planes.
bool tells_sides(const Between& between, const std::vector<Tips>& planes, const std::vector<BothSides>& places,
                 const Sides& sides) {
  const Tips& first = planes[between.first];
  const Tips& second = planes[between.second];
  const double cosine = cosine_between(first, second);
  const double diameter = first.radii.mean() + second.radii.mean();
  if (cosine > 0.0 || diameter == 0.0) {
    return true;  // the same way: the tip's radius does not enter
  }
  const double apart = std::abs(on(places[between.second], sides.of[between.second]).place -
                                on(places[between.first], sides.of[between.first]).place);
  const double possible = cosine < 0.0 ? 2.0 * diameter : diameter;
  return std::abs(apart - between.value) <= told_clearly * possible;
}

// The axis of a gauge by linear least squares: along it, the tips are at the certified heights, less a place in common.
// Narrow faces alone do not show it while the arm misses them; their certified distances do. Nothing where these do not
// either, because one face was read or the lengths are not of one unit.
std::optional<Eigen::Vector3d> gauge_axis(const std::vector<Tips>& faces, const Eigen::Vector3d& origin) {
  Eigen::Index rows = 0;
  for (const Tips& face : faces) {
    rows += face.centres.cols();
  }
  Eigen::MatrixX4d a(rows, 4);
  Eigen::VectorXd b(rows);
  Eigen::Index row = 0;
  for (const Tips& face : faces) {
    const GaugeFace& certified = *face.feature->face();
    for (Eigen::Index k = 0; k < face.centres.cols(); ++k, ++row) {
      a.row(row) << (face.centres.col(k) - origin).transpose(), -1.0;
      b[row] = certified.height + certified.facing * face.radii[k];
    }
  }
  const Eigen::Vector3d axis = a.colPivHouseholderQr().solve(b).head<3>();
  return axis.norm() > 0.5 && axis.norm() < 2.0 ? std::optional<Eigen::Vector3d>(axis.normalized()) : std::nullopt;
}

const Between* first_missed(const std::vector<Between>& distances, const std::vector<Tips>& planes,
                            const std::vector<BothSides>& places, const Sides& sides) {
  const auto missed = std::find_if(distances.begin(), distances.end(), [&](const Between& between) {
    return !tells_sides(between, planes, places, sides);
  });
  return missed == distances.end() ? nullptr : &*missed;
}

// The normal by the styluses, whose mean lies against it on each plane.
Eigen::Vector3d normal_by_styluses(const std::vector<Tips>& planes) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Tips& plane : planes) {
    const Eigen::Vector3d mean = plane.styluses.rowwise().mean();
    sum += mean.dot(sum) < 0.0 ? Eigen::Vector3d(-mean) : mean;
  }
  return sum.norm() > 0.0 ? Eigen::Vector3d(sum.normalized()) : Eigen::Vector3d::UnitZ();
}

// A gauge looks along the axis or against it: its certified heights and its tips' radii agree with one.
void estimate_gauge(const std::vector<Tips>& faces, GroupState& group) {
  double least = std::numeric_limits<double>::infinity();
  Eigen::Matrix3d turned = group.reference.rotation;
  turned.rightCols<2>() *= -1.0;
  for (const Eigen::Matrix3d& rotation : {group.reference.rotation, turned}) {
    std::vector<double> places;
    for (const Tips& face : faces) {
      const GaugeFace& certified = *face.feature->face();
      const Eigen::RowVectorXd heights =
          rotation.col(2).transpose() * (face.centres.colwise() - group.reference.origin);
      for (Eigen::Index k = 0; k < heights.size(); ++k) {
        places.push_back(heights[k] - certified.height - certified.facing * face.radii[k]);
      }
    }
    const auto all = Eigen::ArrayXd::Map(places.data(), static_cast<Eigen::Index>(places.size()));
    if (const double squares = (all - all.mean()).square().sum(); squares < least * (1.0 - 1e-9)) {
      least = squares;
      group.reference.rotation = rotation;
      group.values = Eigen::Vector3d(0.0, 0.0, all.mean());
    }
  }
}

}  // namespace

Expected<GroupState> estimate_planes(const std::vector<Tips>& planes, const Constraints& constraints,
                                     const std::string& called) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(scatter_of(planes));
  if (!(eigen.eigenvalues()[1] > 1e-9 * eigen.eigenvalues()[2])) {
    return no_solution(fmt::format(
        "the plane of {} cannot be determined from its readings: at least three are needed that are not on a "
        "line, on it or on planes certified to be parallel",
        called));
  }
  GroupState group;
  Eigen::Index count = 0;
  for (const Tips& plane : planes) {
    group.reference.origin += plane.centres.rowwise().sum();
    count += plane.centres.cols();
  }
  group.reference.origin /= static_cast<double>(count);
  double squares = 0.0;
  for (const Tips& plane : planes) {
    squares += (plane.centres.colwise() - group.reference.origin).squaredNorm();
  }
  group.reference.size = std::sqrt(squares / static_cast<double>(count));
  const bool is_gauge = planes.front().feature->face() != nullptr;
  const auto by_heights = is_gauge ? gauge_axis(planes, group.reference.origin) : std::nullopt;
  const Eigen::Vector3d axis = by_heights.value_or(eigen.eigenvectors().col(0));
  const Eigen::Vector3d across = by_heights ? axis.unitOrthogonal() : Eigen::Vector3d(eigen.eigenvectors().col(2));
  group.reference.rotation << across, axis.cross(across), axis;

  if (is_gauge) {
    estimate_gauge(planes, group);
    return group;
  }
  std::vector<BothSides> places;
  for (const Tips& plane : planes) {
    places.push_back(
        {placed(plane, axis, group.reference.origin, -1.0), placed(plane, axis, group.reference.origin, 1.0)});
  }
  const auto distances = distances_between(planes, constraints);
  const Sides outward = spread(1.0, planes, places, distances);
  const Sides inward = spread(-1.0, planes, places, distances);
  Sides sides = inward.cost < outward.cost * (1.0 - 1e-9) ? inward : outward;
  if (const auto by_stylus = planes.size() > 1 ? sides_by_stylus(planes, axis) : std::nullopt) {
    sides.of = *by_stylus;
  } else if (const Between* missed = first_missed(distances, planes, places, sides)) {
    // Faces that the arm misses by more than they are wide do not show their normal; the styluses roughly do.
    const Eigen::Vector3d along_styluses = normal_by_styluses(planes);
    const auto roughly = sides_by_stylus(planes, along_styluses);
    if (!roughly) {
      return no_solution(fmt::format(
          "a certified distance between planes, {} mm at {}, is missed by so much that it does not show "
          "on which side of them the tip was; state `at` and `normal` of the planes, or begin with a better arm",
          missed->value, called));
    }
    const Eigen::Vector3d side = along_styluses.unitOrthogonal();
    group.reference.rotation << side, along_styluses.cross(side), along_styluses;
    sides.of = *roughly;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      places[i] = {placed(planes[i], along_styluses, group.reference.origin, -1.0),
                   placed(planes[i], along_styluses, group.reference.origin, 1.0)};
    }
  }
  group.reference.sides = sides.of;
  group.values = Eigen::VectorXd::Zero(2 + static_cast<Eigen::Index>(planes.size()));
  for (std::size_t i = 0; i < planes.size(); ++i) {
    group.values[2 + static_cast<Eigen::Index>(i)] = on(places[i], sides.of[i]).place;
  }
  return group;
}

}  // namespace artcal
