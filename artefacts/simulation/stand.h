#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace artcal {

/// A table, a wall or a machine beside the arm: everything below `top` over a rectangle of the base's x and y, mm.
struct Obstacle {
  Eigen::Vector2d x{0.0, 0.0}, y{0.0, 0.0};  ///< from, to
  double top = 0.0;
};

/// Where an artefact can be held: heights along the base's z axis, mm. Nothing stated holds everything.
struct Stand {
  std::optional<double> lowest, highest;  ///< of the features' centres, such as the travel of a stand
  std::optional<double> floor;            ///< below which no part of a feature may be
  std::vector<Obstacle> tables;           ///< into which neither a feature nor a line between two of them may go
};

/// A feature as it stands: its centre and, of a ball, its radius.
struct StandingFeature {
  std::string name;
  Eigen::Vector3d at_in_base = Eigen::Vector3d::Zero();
  double radius = 0.0;
};

/// Why an artefact cannot stand so, such as "the feature "A" is at a height of -812.0 mm, below the floor at -700.0
/// mm"; empty where it can. Between its features an artefact is taken to be straight.
std::string not_held(const Stand& stand, const std::vector<StandingFeature>& features);

}  // namespace artcal
