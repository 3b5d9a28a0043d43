#pragma once

#include <vector>

#include "acquisition/recording/recording.h"
#include "artefacts/artefact/artefact.h"
#include "artefacts/scans/scan_contents.h"
#include "artefacts/scans/scan_readings.h"

namespace artcal {

/// A [[scan]] of a recording, read and ready to be searched.
struct ScanSource {
  const Artefact* artefact = nullptr;
  int probe = 0;           ///< into Arm::probes
  ArtefactInScan wanted;   ///< where the tip's centre is while it touches the spheres; no planes
  SegmentOptions options;  ///< for an arm that is not identified yet
  PointCloud cloud;        ///< joints: 0 × 0 where coordinates are all there is
  Eigen::Matrix3Xd tips_in_base;
};

/// Errors: those of read_scans that concern the files and what they refer to.
Expected<ScanSource> open_scan(const Recording& recording, const RecordedScan& scan,
                               const std::vector<Artefact>& artefacts, const ScanSelection& selection);

}  // namespace artcal
