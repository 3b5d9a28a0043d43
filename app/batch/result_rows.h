#pragma once

#include <string>
#include <vector>

#include "app/store/shape.h"
#include "artefacts/verification/verify.h"
#include "identification/identify.h"

namespace artcal {

/// A recording's own row, its inputs and its artefacts; `inputs` with paths from its folder. `options` as stored.
void add_recording(StoreRows& rows, const std::string& key, const std::string& options, const Recording& recording,
                   const Constraints& constraints, const std::vector<InputFile>& inputs);

void add_identification(StoreRows& rows, const std::string& key, const Identification& result);

void add_verification(StoreRows& rows, const std::string& key, const VerificationResult& result,
                      const std::string& specification);

/// Warnings and the like, each text once, in their order.
void add_remarks(StoreRows& rows, const std::string& key, const std::string& kind,
                 const std::vector<std::string>& texts);

}  // namespace artcal
