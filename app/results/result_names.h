#pragma once

#include <optional>
#include <string_view>

#include "artefacts/verification/verification.h"
#include "identification/identify.h"

namespace artcal {

/// The words that results have for these (docs/result-schema.md, docs/store.md).
const char* result_name(Verdict verdict);
const char* result_name(Conclusion conclusion);
const char* result_name(ParameterState state);
const char* result_name(Loss loss);

/// What such a word means; of any other, that nothing was judged or shown.
Verdict verdict_named(std::string_view word);
Conclusion conclusion_named(std::string_view word);

/// Nothing for a word that no state has.
std::optional<ParameterState> parameter_state_named(std::string_view word);

}  // namespace artcal
