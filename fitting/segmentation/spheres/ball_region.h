#pragma once

#include <vector>

#include "fitting/fit.h"

namespace artcal {

/// Every point of a scan that was taken on a ball, and where the ball was looked at.
struct BallRegion {
  std::vector<int> points;  ///< columns, ascending
  double share = 0.0;       ///< of the sphere's surface that they cover, to some hundredths, 0 to 1
  double band = 0.0;        ///< greatest distance of a point from the sphere that was told, mm
  int far_off = 0;          ///< points farther than half the band from it
  int beside_foreign = 0;   ///< points within the band that were left out because of where they lie

  /// Few of the points are far off, and most of those within the band are among them: the ball ends where something
  /// else begins. Else neither size nor form can be determined of it.
  [[nodiscard]] bool is_clear() const;
};

/// All points of one ball, chosen by where they lie around it and not by how near: what is fitted to them shows their
/// whole scatter. `sphere` is roughly known, to a fiftieth of its radius R.
///  - Candidates lie within R/10 of the sphere, whatever the noise.
///  - What lies up to R/2 off it but is no candidate is foreign (stem, table, mixed pixels, a tip on its way).
///  Directions
///    from the centre within 15° of foreign ones are not used: what is foreign comes nearer to the ball there than
///    R/10.
///  - Of the directions with candidates that are left, cells of about 5° on the sphere that lie within 25° of one
///  another
///    hang together; the part with most points is the ball. What a ring of foreign points cuts off is not.
///  - All candidates in it are taken. It is not clear where more than one in twenty of them is farther off than R/20,
///  or
///    where more than half of the candidates were left out.
/// Noise above R/40 is therefore told as a region that is not clear, never as a smaller noise. Time goes with the
/// number of points. REQUIRES a radius above zero.
BallRegion ball_region(const Points& points, const Sphere& sphere);

}  // namespace artcal
