#pragma once

#include "acquisition/recording/recording.h"
#include "artefacts/artefact/artefact.h"
#include "identification/inspection/finding.h"

namespace artcal {

/// What is wrong with the numbers that were written down: uncertainties, diameters, temperatures of another unit
/// (artefacts/artefact/plausibility.h), certificates that had lapsed on the day of the recording.
Findings find_wrong_documents(const Recording& recording, const std::vector<Artefact>& artefacts);

/// What a calibration needs for traceability and the files do not say: the date, a certificate's number. Remarks: the
/// numbers are right without them.
Findings find_missing_documents(const Recording& recording, const std::vector<Artefact>& artefacts);

}  // namespace artcal
