#include "identification/solution_search.h"

#include <optional>
#include <utility>

namespace artcal {
namespace {

Expected<Candidate> candidate_from(Alignment alignment, const Recording& recording, const Constraints& constraints,
                                   const IdentifyOptions& options) {
  auto preparation = prepare(recording, constraints, options, alignment);
  if (!preparation) {
    return tl::unexpected(preparation.error());
  }
  auto fit = fit_arm(recording, constraints, preparation->start, preparation->free, options.noise,
                     SolveOptions{options.loss, options.max_iterations}, preparation->known_start());
  if (!fit) {
    return tl::unexpected(fit.error());
  }
  auto after = evaluate(recording, constraints, fit->arm);
  if (!after) {
    return tl::unexpected(after.error());
  }
  Candidate candidate{alignment, 1, std::move(*preparation), std::move(*fit), std::move(*after), {}};
  candidate.misfits = misfits(candidate.fit, candidate.after, constraints, recording.arm, candidate.preparation.free,
                              options.noise, options.loss);
  return candidate;
}

// By what the least squares made small: the noise that would explain the residuals.
double residual_size(const Candidate& candidate, const IdentifyOptions& options) {
  return options.noise.is_given() ? noise_ratio(candidate.fit, options.loss) : candidate.fit.noise;
}

}  // namespace

Expected<Candidate> search_solution(const Recording& recording, const Constraints& constraints,
                                    const IdentifyOptions& options) {
  std::optional<Candidate> best;
  std::optional<Error> first_error;
  int attempt = 0;
  for (const Alignment alignment : alignments_for(recording, constraints, arm_for(options.model, recording.arm))) {
    auto candidate = candidate_from(alignment, recording, constraints, options);
    ++attempt;
    if (!candidate) {
      if (candidate.error().code != ErrorCode::NoSolution) {
        return candidate;
      }
      first_error = first_error ? first_error : candidate.error();
      continue;
    }
    candidate->attempt = attempt;
    if (!best || residual_size(*candidate, options) < residual_size(*best, options)) {
      best = std::move(*candidate);
    }
    if (best->misfits.empty()) {
      break;
    }
  }
  if (!best) {
    return tl::unexpected(*first_error);
  }
  return std::move(*best);
}

}  // namespace artcal
