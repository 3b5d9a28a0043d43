#pragma once

#include <string>
#include <variant>

#include "app/report/result_file.h"
#include "app/results/identification/recorded/recorded_identification.h"
#include "app/results/recorded/recorded_head.h"
#include "app/results/uncertainty/recorded_monte_carlo.h"
#include "app/results/uncertainty/recorded_uncertainty.h"
#include "app/results/verification/recorded_verification.h"
#include "core/error.h"

namespace artcal {

/// A result as its typed readers give it: all that a report shows of it.
struct RecordedResult {
  RecordedHead head;
  std::variant<RecordedIdentification, RecordedVerification, RecordedUncertainty, RecordedMonteCarlo> content;
  std::string path;  ///< empty where it was not read from a file
};

/// Refused: a result that is not as docs/result-schema.md says; the message names the place and the reason.
Expected<RecordedResult> recorded_result(const ReportedResult& result);

}  // namespace artcal
