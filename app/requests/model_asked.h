#pragma once

#include <string>

#include "acquisition/recording/recording.h"
#include "core/error.h"
#include "identification/models/model.h"

namespace artcal {

/// The model that `--model` names or, where that is not given (empty), the recording. A name that is not known is wrong
/// usage there and bad input here.
Expected<ModelRequest> model_asked(const std::string& option, const Recording& recording);

}  // namespace artcal
