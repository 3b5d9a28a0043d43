#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "artefacts/verification/session.h"
#include "core/error.h"

namespace artcal {

/// The readings of each plane of an artefact in one placement: by feature, then by repeat.
using PlaneReadings = std::map<int, std::map<int, std::vector<int>>>;

/// The direction across an artefact's parallel faces in one placement; its sign says nothing.
struct FaceAxis {
  Eigen::Vector3d in_base = Eigen::Vector3d::UnitX();
  double u = 0.0;  ///< standard uncertainty of the direction by the readings' scatter, rad; 0: not told
};

/// The first that the readings tell:
///  1. the common normal of the measuring faces and of all planes certified to be parallel to them, as read in
///  `repeat`;
///  2. the same by all repeats of the placement, which may be one that was read for this alone;
///  3. what stands on two or more planes that are certified to stand on the faces, such as the sides of a gauge block,
///     read in any repeat.
/// A plane tells its normal where its readings lie off one line and on one plane: faces may then be read in a single
/// point each. Measuring faces are the ends of certified distances and all planes parallel to a certified one.
///
/// Errors (NoSolution): none of them is told; sides that stand at another angle to each other than certified.
Expected<FaceAxis> face_axis(const Session& session, const Artefact& artefact, const PlaneReadings& planes, int repeat);

/// Whether the feature is an end of lengths, or parallel to one: a plane, and no side.
bool is_measuring_face(const Artefact& artefact, int feature);

}  // namespace artcal
