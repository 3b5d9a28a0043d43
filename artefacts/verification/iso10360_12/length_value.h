#pragma once

#include "artefacts/verification/session.h"
#include "artefacts/verification/verification.h"

namespace artcal {

/// One certified length as it was measured.
struct MeasuredLength {
  std::vector<int> readings;  ///< of both ends
  double length = 0.0;        ///< at the artefact's temperature, mm
  Eigen::Vector3d middle_in_base = Eigen::Vector3d::Zero();
};

/// Its error at the reference temperature, with its uncertainty and where it was measured; not judged yet.
TestValue length_value(const Session& session, const Artefact& artefact, const CertifiedDistance& certified,
                       const MeasuredLength& measured);

}  // namespace artcal
