#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "artefacts/artefact/artefact.h"
#include "core/error.h"

namespace artcal {

/// A plate's own coordinates from several placements of it: errors of the arm that turn with the arm and not
/// with the plate go into the scatter instead of the plate.
struct PlateCalibration {
  std::string artefact;
  std::vector<std::string> features;
  Eigen::Matrix3Xd centres;     ///< in the certificate's frame, mm at the reference temperature; the arm's scale
  Eigen::Matrix3Xd deviations;  ///< centres − certified, after the best rigid motion, mm
  Eigen::VectorXd u;            ///< standard uncertainty of each coordinate by the scatter over the placements, mm
  /// Of u: each placement's pose is fitted to the balls too, which takes 6 of its 3·n coordinates.
  double degrees_of_freedom = 0.0;
  int placements = 0;
  double least_turn = 0.0;  ///< smallest angle by which two placements are turned against each other, rad
};

/// The mean shape of the placements (same balls in the same columns): each is moved onto the mean without scale
/// and the mean taken anew until it converges (generalised Procrustes analysis without scale; Gower 1975), then
/// moved onto `certified`. REQUIRES: at least two placements, of as many columns as `certified`. Errors as
/// fit_rigid.
Expected<PlateCalibration> mean_shape(const std::vector<Eigen::Matrix3Xd>& placements,
                                      const Eigen::Matrix3Xd& certified);

/// The plate with these coordinates and their u in place of the certified ones. What else its certificate says of
/// places (distances, number, date, laboratory) is left out, for it does not hold for them; diameters, form and
/// expansion stay. A note says where the coordinates are from and that their scale is the arm's. Balls that
/// `calibration` does not have are left out too.
Artefact calibrated_artefact(const Artefact& certified, const PlateCalibration& calibration);

}  // namespace artcal
