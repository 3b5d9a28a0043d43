#pragma once

#include <Eigen/Core>

namespace artcal::segmentation {

/// The share of a sphere, 0 to 1, that points show whose directions from the centre are given (of any length but zero,
/// one a column).
///
/// The directions' Delaunay triangulation (their convex hull) without the triangles that are wide for the points'
/// density is the part seen. A point stands for twice the mean area of a triangle: inside the part there are two
/// triangles a point, and where it ends the points lie half their spacing within the border. Counting cells that hold a
/// point instead counts the whole cell at the border, and with few points overstates several times.
/// Many points are thinned evenly first. Within some 10 % for a few dozen points and some hundredths of it for many.
double sphere_coverage(const Eigen::Matrix3Xd& directions);

}  // namespace artcal::segmentation
