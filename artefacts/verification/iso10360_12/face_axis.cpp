#include "artefacts/verification/iso10360_12/face_axis.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "artefacts/artefact/parallel.h"
#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr double thinnest = 0.02;  // spread across over spread along: less is one line
constexpr double thickest = 0.1;   // spread off a plane over the smaller one in it: more is no plane
constexpr double perpendicular = 1e-4;
constexpr double least_angle = 30.0 * units::degree;  // between sides that tell an axis
constexpr double max_disagreement = 1.0 * units::degree;

using Group = std::vector<int>;  // readings of one plane

const CertifiedFeature& feature_of(const Artefact& artefact, int feature) {
  return artefact.features[static_cast<std::size_t>(feature)];
}

// The normal that planes share, by the readings of each about their own mean.
std::optional<FaceAxis> common_normal(const Session& session, const std::vector<Group>& groups) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  int freedom = -2;
  for (const Group& group : groups) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const int reading : group) {
      mean += session.tips.in_base.col(reading) / static_cast<double>(group.size());
    }
    for (const int reading : group) {
      const Eigen::Vector3d off = session.tips.in_base.col(reading) - mean;
      scatter += off * off.transpose();
    }
    freedom += static_cast<int>(group.size()) - 1;
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(scatter, Eigen::ComputeFullU);
  const Eigen::Vector3d spread = svd.singularValues().cwiseSqrt();
  if (!(spread(1) > thinnest * spread(0)) || !(spread(2) < thickest * spread(1))) {
    return std::nullopt;
  }
  return FaceAxis{svd.matrixU().col(2), freedom > 0 ? spread(2) / std::sqrt(freedom) / spread(1) : 0.0};
}

// Along the faces' certified normals.
std::optional<Eigen::Vector3d> axis_in_artefact(const Artefact& artefact) {
  for (const CertifiedDistance& length : artefact.distances) {
    if (const auto& normal = feature_of(artefact, length.first).normal) {
      return normal;
    }
  }
  for (const CertifiedFeature& feature : artefact.features) {
    if (artefact.distances.empty() && feature.kind == FeatureKind::Plane && feature.normal && feature.at) {
      return feature.normal;
    }
  }
  return std::nullopt;
}

bool is_side(const Artefact& artefact, int feature) {
  const auto axis = axis_in_artefact(artefact);
  const auto& normal = feature_of(artefact, feature).normal;
  return axis && normal && std::abs(axis->dot(*normal)) < perpendicular;
}

std::vector<Group> faces_of(const Artefact& artefact, const PlaneReadings& planes, std::optional<int> repeat) {
  std::vector<Group> groups;
  for (const auto& [feature, repeats] : planes) {
    Group group;
    for (const auto& [read_in, readings] : repeats) {
      if (is_measuring_face(artefact, feature) && read_in == repeat.value_or(read_in)) {
        group.insert(group.end(), readings.begin(), readings.end());
      }
    }
    if (!group.empty()) {
      groups.push_back(std::move(group));
    }
  }
  return groups;
}

struct SideOfGauge {
  int feature = 0;
  FaceAxis normal;
};

std::vector<SideOfGauge> sides_of(const Session& session, const Artefact& artefact, const PlaneReadings& planes) {
  std::vector<SideOfGauge> sides;
  for (const auto& [feature, repeats] : planes) {
    if (!is_side(artefact, feature)) {
      continue;
    }
    Group all;
    for (const auto& [repeat, readings] : repeats) {
      all.insert(all.end(), readings.begin(), readings.end());
    }
    if (const auto normal = common_normal(session, {all})) {
      sides.push_back({feature, *normal});
    }
  }
  return sides;
}

// Without signs, from 0 to a right angle.
double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), std::abs(a.dot(b)));
}

Expected<std::optional<FaceAxis>> axis_by_sides(const Artefact& artefact, const std::vector<SideOfGauge>& sides) {
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  double widest = 0.0;
  double u = 0.0;
  for (const SideOfGauge& side : sides) {
    squares += side.normal.in_base * side.normal.in_base.transpose();
    for (const SideOfGauge& other : sides) {
      const double angle = angle_between(side.normal.in_base, other.normal.in_base);
      const double certified =
          angle_between(*feature_of(artefact, side.feature).normal, *feature_of(artefact, other.feature).normal);
      if (std::abs(angle - certified) > max_disagreement) {
        return no_solution(fmt::format(
            "the sides {} and {} stand at {:.1f} degrees to each other, and are certified to stand at {:.1f}",
            in_quotes(feature_of(artefact, side.feature).name), in_quotes(feature_of(artefact, other.feature).name),
            angle / units::degree, certified / units::degree));
      }
      if (angle > widest) {
        widest = angle;
        u = std::hypot(side.normal.u, other.normal.u) / std::sin(angle);
      }
    }
  }
  if (widest < least_angle) {
    return std::nullopt;
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(squares, Eigen::ComputeFullU);
  return FaceAxis{svd.matrixU().col(2), u};
}

}  // namespace

bool is_measuring_face(const Artefact& artefact, int feature) {
  if (feature_of(artefact, feature).kind != FeatureKind::Plane) {
    return false;
  }
  const auto is_end = [&](const CertifiedDistance& d) { return d.first == feature || d.second == feature; };
  if (std::any_of(artefact.distances.begin(), artefact.distances.end(), is_end)) {
    return true;
  }
  const auto axis = axis_in_artefact(artefact);
  const auto& normal = feature_of(artefact, feature).normal;
  return axis && normal && are_parallel(*axis, *normal);
}

Expected<FaceAxis> face_axis(const Session& session, const Artefact& artefact, const PlaneReadings& planes,
                             int repeat) {
  for (const std::optional<int> read_in : {std::optional(repeat), std::optional<int>()}) {
    if (const auto axis = common_normal(session, faces_of(artefact, planes, read_in))) {
      return *axis;
    }
  }
  const auto by_sides = axis_by_sides(artefact, sides_of(session, artefact, planes));
  if (!by_sides) {
    return tl::unexpected(by_sides.error());
  }
  if (*by_sides) {
    return **by_sides;
  }
  return no_solution(
      "the readings of each face are single points or lie on one line, so that its direction is not determined; read a "
      "face in three or more points, or two sides whose normals are certified, in the same placement");
}

}  // namespace artcal
