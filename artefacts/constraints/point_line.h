#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace artcal {

/// The line along which certified points lie, or nearly lie.
struct PointLine {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< the points' mean, in the artefact's frame, mm
  /// Rotation; its third column is the direction of the line.
  Eigen::Matrix3d artefact_from_line = Eigen::Matrix3d::Identity();
  double straightness = 0.0;  ///< largest distance of a point from the line, mm
  double length = 0.0;        ///< between the outermost points along it, mm
};

/// The least-squares line through points (at least one), by the principal axis of their scatter.
PointLine line_through(const std::vector<Eigen::Vector3d>& points);

}  // namespace artcal
