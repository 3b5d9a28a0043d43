#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "app/results/recorded/recorded_object.h"
#include "artefacts/verification/b89_4_22/b89_4_22.h"

namespace artcal {

/// A sphere plate in one placement as a result has it (table "plate" of docs/result-schema.md), mm.
struct RecordedPlate {
  struct Ball {
    std::string feature;
    Eigen::Vector3d residual = Eigen::Vector3d::Zero();  ///< in the plate's axes
    double standardised = 0.0;
    bool is_outlier = false;
  };
  std::string artefact, placement, repeat;
  double rms = 0.0;
  double scale_ppm = 0.0, u_scale_ppm = 0.0;
  double en_worst = 0.0;  ///< of a distance
  std::string finding;    ///< empty: none
  std::vector<Ball> balls;
};

/// A plate as its placements determine it (table "plate_calibration"), mm and rad.
struct RecordedCalibration {
  struct Ball {
    std::string feature;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    Eigen::Vector3d deviation = Eigen::Vector3d::Zero();  ///< from the certificate
    double u = 0.0;
  };
  std::string artefact;
  std::size_t placements = 0;
  double least_turn = 0.0;
  std::vector<Ball> balls;
};

/// Each reads the part of a verification; all throw NotAsInSchema. Nothing: another standard.
std::vector<RecordedPlate> recorded_plates(const RecordedObject& verification);
std::vector<RecordedCalibration> recorded_calibrations(const RecordedObject& verification);
std::vector<Articulation> recorded_articulations(const RecordedObject& verification);
std::optional<VolumetricSummary> recorded_volumetric(const RecordedObject& verification);

}  // namespace artcal
