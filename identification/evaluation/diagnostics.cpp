#include "identification/evaluation/diagnostics.h"

#include <utility>

#include "identification/evaluation/judgement.h"
#include "identification/evaluation/residual_diagnostics.h"
#include "identification/identifiability/fixed_hayati_angles.h"
#include "identification/uncertainty/influence.h"

namespace artcal {
namespace {

void add_warning(std::string text, std::vector<std::string>& warnings) {
  if (!text.empty()) {
    warnings.push_back(std::move(text));
  }
}

}  // namespace

Diagnostics diagnose(const System& system, const Estimate& estimate, const EstimateUncertainty& uncertainty,
                     const Recording& recording, const IdentifyOptions& options) {
  const Constraints& constraints = *system.constraints;
  Diagnostics found;
  // A nominal arm so far off that nothing can be fitted to its points says nothing against the identified one.
  const auto before = evaluate(recording, constraints, recording.arm);
  found.before = before ? *before : not_evaluated(estimate.after);
  if (!before) {
    add_warning(
        "the nominal arm cannot be evaluated by these readings, so that there is nothing to compare the identified one "
        "with: " +
            before.error().message,
        found.warnings);
  }
  add_warning(warning_of_weak_prior(estimate.weak, estimate.preparation.free.size()), found.warnings);
  found.outliers = find_outliers(recording, constraints, estimate.fit, uncertainty.redundancy, estimate.after);
  add_warning(warning_of(found.outliers.certificates, options.loss), found.warnings);
  found.influences = influences_of(constraints, estimate.fit, uncertainty.redundancy);
  if (options.progress) {
    options.progress("search for unmodelled effects", 0, 0);
  }
  found.residuals = search_residuals(system, estimate.fit, recording);
  add_warning(warning_of(found.residuals), found.warnings);
  add_warning(note_on_fixed_hayati_angles(recording, constraints, options, estimate.after), found.warnings);
  return found;
}

}  // namespace artcal
