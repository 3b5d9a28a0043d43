#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "acquisition/point_cloud/point_cloud.h"

namespace artcal {

/// Where a sphere of the artefact stands, so that a symmetric artefact can be determined.
struct SpherePlace {
  std::string sphere;          ///< the feature's name
  Eigen::Vector3d at_in_base;  ///< mm
};

/// What a recording says of one scan: a [[scan]] of recording.toml.
struct RecordedScan {
  std::string path;                       ///< of the points, resolved
  std::string placement;                  ///< where the artefact stood
  std::string artefact;                   ///< empty: the only one
  std::string probe;                      ///< empty: the only one
  std::string orientation;                ///< of the wrist; empty: not told
  std::string repeat;                     ///< of a test; empty: there is one
  std::optional<double> temperature;      ///< of the artefact, °C
  std::optional<double> arm_temperature;  ///< °C
  CloudUnits units;                       ///< of x, y, z and of q1 … qn
  std::optional<double> tolerance;        ///< of distances between spheres as the nominal arm sees them, mm
  std::vector<SpherePlace> places;
  int use_every = 1;  ///< of the points on spheres, every so manyth becomes a reading
  std::string where;  ///< of this table in recording.toml, for messages
};

}  // namespace artcal
