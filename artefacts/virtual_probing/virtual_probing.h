#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "acquisition/recording/recording.h"
#include "artefacts/artefact/artefact.h"

namespace artcal {

/// A kind of reading, as `artcal coupling --kind` names it.
enum class ReadingKind {
  BaseCoordinates,   ///< "base": known coordinates in the base frame
  FrameCoordinates,  ///< "frame": known coordinates in an unknown frame
  Point,             ///< "point": many readings of unknown points
  Distance,          ///< "distance": pairs of points at a certified distance, one reading each
  Plate,             ///< "plate": nine points of known coordinates on a plate, in several placements
  Sphere,            ///< "sphere": balls of known radius at unknown places
  UnknownSphere,     ///< "sphere-unknown-radius": the same, but nobody knows their radii
  Plane,             ///< "plane": unknown planes, oblique to everything
  LevelPlane,        ///< "plane-perpendicular": unknown planes perpendicular to the first axis
  Length,            ///< "length": measured lengths to unknown anchors
};

struct VirtualProbing {
  ReadingKind kind = ReadingKind::BaseCoordinates;
  int readings = 240;  ///< in all
  /// Points, balls, planes or anchors, or placements of a plate they are spread over (not used by coordinates
  /// and distances).
  int features = 4;
  double distance = 0.0;      ///< of a pair, or a plate's width, mm; 0 takes a quarter of the reach
  double ball_radius = 12.7;  ///< mm
  std::uint64_t seed = 1;
};

/// A recording without noise, and the artefacts it was made on.
struct VirtualRecording {
  Recording recording;
  std::vector<Artefact> artefacts;
};

/// Reads `arm` (taken as the truth) at random postures, every joint anywhere on its circle. The same
/// arguments give the same bits. There are fewer readings than asked for where the arm cannot do it (one of
/// two joints on a ball, say, or a distance beyond its reach).
VirtualRecording probe_virtually(const Arm& arm, const VirtualProbing& options);

}  // namespace artcal
