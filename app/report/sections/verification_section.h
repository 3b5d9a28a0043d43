#pragma once

#include "app/report/sheet.h"
#include "app/results/verification/recorded_verification.h"

namespace artcal {

/// What a verification came to, for the top of a report.
void write_verification_verdict(const RecordedVerification& result, Sheet& sheet);

/// A verification: what is missing, every value with limit, uncertainty and verdict, what its standard tells beside.
void write_verification(const RecordedVerification& result, Sheet& sheet);

}  // namespace artcal
