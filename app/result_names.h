#pragma once

#include "artefacts/verification/verification.h"
#include "identification/identify.h"

namespace artcal {

/// The words that results have for these (docs/result-schema.md, docs/store.md).
const char* result_name(Verdict verdict);
const char* result_name(Conclusion conclusion);
const char* result_name(ParameterState state);

}  // namespace artcal
