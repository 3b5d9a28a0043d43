#pragma once

#include <Eigen/Core>

#include "acquisition/recording/recording.h"
#include "core/error.h"

namespace artcal {

/// Who says where the tip was.
enum class TipSource {
  Joints,    ///< an arm's kinematics, from the joint angles
  Reported,  ///< the arm's own software (columns x, y, z)
};

struct TipCentres {
  Eigen::Matrix3Xd in_base;  ///< a column a reading, mm
  TipSource source = TipSource::Joints;
};

/// The tip's centre of every reading by the kinematics of `arm`, which has the joints and the probes of the
/// recording's. Refused: an arm of another number of joints, a probe that it does not have or has with another
/// radius (unless `identification` says that the radius was identified), a reading without joint angles, or without the
/// arm's temperature where the arm expands.
Expected<TipCentres> tip_centres(const Recording& recording, const Arm& arm,
                                 const ArmIdentification* identification = nullptr);

/// As reported where every reading says, else by the recording's own arm.
Expected<TipCentres> tip_centres(const Recording& recording);

/// Radius of the tip that made a reading, mm: of the probe that `arm` has by the name that the recording's arm gives
/// it, else of the recording's own.
double tip_radius(const Recording& recording, int reading, const Arm& arm);

/// Whether every reading has joint angles; else an error at the first that has not, for whoever needs them.
Expected<void> require_joints(const Recording& recording);

/// Whether every reading has the arm's temperature; else an error at the first that has not.
Expected<void> require_arm_temperatures(const Recording& recording);

}  // namespace artcal
