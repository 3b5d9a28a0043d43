#include "app/results/identification/input_warnings.h"

#include <string>
#include <utility>

#include "artefacts/constraints/document_warnings.h"

namespace artcal {

Expected<Identification> with_input_warnings(Expected<Identification> result, const Recording& recording,
                                             const Constraints& constraints) {
  if (!result) {
    return tl::unexpected(with_warnings(std::move(result.error()), recording.warnings));
  }
  auto& warnings = result->warnings;
  for (const std::string& reason : result->misfits) {
    warnings.insert(warnings.begin(), "this arm is no solution of its readings (--accept-misfit): " + reason);
  }
  const auto of_documents = texts_of(document_warnings(recording, constraints.artefacts));
  warnings.insert(warnings.begin(), of_documents.begin(), of_documents.end());
  warnings.insert(warnings.begin(), constraints.warnings.begin(), constraints.warnings.end());
  warnings.insert(warnings.begin(), recording.warnings.begin(), recording.warnings.end());
  return result;
}

}  // namespace artcal
