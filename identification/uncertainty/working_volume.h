#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "identification/uncertainty/uncertain_arm.h"

namespace artcal {

/// Lengths that are looked at, as shares of the reach.
inline constexpr std::array surveyed_lengths{0.1, 0.2, 0.4, 2.0 / 3.0, 0.9};

/// How many of what is drawn at random; the same numbers and seed give the same bits.
struct VolumeSampling {
  int lengths = 200;       ///< for each nominal length
  int spheres = 50;        ///< places where a sphere is probed
  int postures = 12;       ///< at each place of the map
  int rings = 8;           ///< of the map: steps of the distance from axis 1, and twice as many of the height
  double diameter = 25.0;  ///< of the probed sphere's surface, mm
  std::uint64_t seed = 1;
};

/// A standard uncertainty all over the working volume, mm.
struct SpreadOfU {
  int count = 0;  ///< places it was taken at; 0: the arm does not reach them
  double rms = 0.0;
  double quantile_95 = 0.0;  ///< 95 % of the places are better
  double maximum = 0.0;
};

/// Standard uncertainty of a length between two single points, at random places, in random directions and postures.
struct LengthUncertainty {
  double length = 0.0;  ///< mm
  SpreadOfU u;
  SpreadOfU u_of_arm;  ///< the identification's share, without the noise of the two readings
};

/// One place of the map: all points at this distance from axis 1 and at this height above the base's origin.
struct MapCell {
  double from_axis = 0.0;  ///< mm
  double height = 0.0;     ///< along axis 1, mm
  SpreadOfU u;             ///< of a point: √ of the trace of its covariance
};

/// What an identified arm may be expected to measure like.
struct WorkingVolume {
  std::vector<LengthUncertainty> lengths;
  SpreadOfU sphere_diameter;  ///< of 25 points on a sphere, the pattern of ISO 10360-12 (docs/verification.md)
  std::vector<MapCell> map;   ///< ring by ring, each from the lowest place to the highest
};

/// Lengths of a tenth, a fifth, two fifths, two thirds and nine tenths of the reach; postures are taken from anywhere
/// on the joints' circles, for an arm without end stops.
WorkingVolume survey(const UncertainArm& arm, const VolumeSampling& sampling = {});

}  // namespace artcal
