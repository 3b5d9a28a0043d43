#pragma once

#include <cstddef>
#include <vector>

#include "acquisition/recording/recording.h"
#include "artefacts/artefact/artefact.h"
#include "core/error.h"

namespace artcal {

/// What readings of a scan are for.
enum class ScanUse {
  /// Identification: points that surely lie on a ball. How near the ball they lie has a part in that, so that their
  /// scatter is no measure of the arm.
  SureOfBall,
  /// Verification: all points of a ball, whatever their distance from it (fitting/segmentation/spheres/ball_region.h).
  WholeBalls,
};

/// Which points of scans become readings.
struct ScanSelection {
  ScanUse use = ScanUse::SureOfBall;
  const Arm* arm = nullptr;    ///< that says where the tip was; null: the recording's own
  std::size_t max_memory = 0;  ///< bytes that compressed points may take; 0: sixteen times their file, at least 256 MiB
};

/// Makes readings of the scans that a recording names (Recording::scans): each point that lies on a sphere of the
/// artefact becomes a contact reading on it, its line the point's row in the file, from 1. The spheres are looked for
/// among the tip's positions as the arm gives them from q1 … qn, with the ball's radius and the tip's together; x, y, z
/// of the file are not used. For identification that arm is nominal, and may see spheres somewhat out of round and
/// their distances changed. For verification a scan may be without joint angles: x, y, z are then where the tip's
/// centre was as the arm's own software reported it. Notes each file as an input of the recording, and how much of it
/// was used as a warning.
///
/// Errors, naming the scan: BadInput for a file that cannot be read, has no joint angles or those of another arm, is
/// named twice; for an artefact, sphere or probe that is not there, or an artefact without spheres of known diameter.
/// NoSolution where no sphere is found, none of the certified distances fit, several ways of naming them fit, or (of
/// whole balls) where a ball ends is not determined. After an error the recording may hold part of the scans and is of
/// no use.
Expected<void> read_scans(Recording& recording, const std::vector<Artefact>& artefacts,
                          const ScanSelection& selection = {});

}  // namespace artcal
