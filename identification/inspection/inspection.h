#pragma once

#include <string>
#include <vector>

#include "identification/identify.h"
#include "identification/inspection/finding.h"
#include "identification/inspection/usage.h"

namespace artcal {

/// What an inspection says of a recording.
struct Inspection {
  Findings findings;                  ///< mistakes; none in a sound recording
  Findings remarks;                   ///< what a careful person would add or vary; the numbers are right without
  std::vector<std::string> excluded;  ///< mistakes that were looked for in vain, where the readings do not fit
  bool is_gross_misfit = false;       ///< no arm fits the readings as they are written, or one does only far worse
  Usage usage;
};

/// Mistakes that show without a fit: repeated postures, documents.
Findings find_mistakes_without_fit(const Recording& recording, const Constraints& constraints);

/// These, and remarks about documents and about what of the arm was used.
Inspection inspect_recording(const Recording& recording, const Constraints& constraints);

/// The same, balls whose centre is not determined, a quick fit of the recording as it is written and, where that leaves
/// too much, the hypotheses about mistakes (explanation.h). Of a recording without joint angles the first alone.
Inspection inspect(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options);

/// Findings from a fit that is a solution: a joint's zero that is far from the arm's file; balls whose centre the
/// touches do not determine, where `arm` has them (ball_touches.h).
Findings find_offsets(const Recording& recording, const Arm& identified);
Findings find_undetermined_centres(const Recording& recording, const Constraints& constraints, const Arm& arm);

}  // namespace artcal
