#pragma once

#include <optional>
#include <string>
#include <vector>

#include "identification/inspection/explanation.h"
#include "identification/inspection/hypotheses/hypothesis.h"
#include "identification/inspection/trial_fit.h"

namespace artcal {

/// A recording without a mistake that was found, where its residuals are still too large.
struct Unexplained {
  Finding found;
  Bound bound;
  IdentifyOptions options;
  AsWritten as_written;
};

/// The search among all hypotheses about one recording, which must outlive it with what else it is given.
class MistakeSearch {
 public:
  MistakeSearch(const Recording& recording, const Constraints& constraints, const IdentifyOptions& options,
                const AsWritten& as_written);

  /// All hypotheses, those first that take the readings furthest; ends with one that explains them.
  void run();
  /// Those about diameters and radii.
  void run_radii();

  [[nodiscard]] Explanation explanation() const;
  /// What is left to be explained without the mistake that was found; nothing where that is no more than a sound
  /// recording leaves.
  [[nodiscard]] std::optional<Unexplained> remainder() const;
  /// Where nothing explains the readings: without the gross mistake that the nominal arm shows, if there is one. A
  /// second behind it may be all that keeps an arm from fitting.
  [[nodiscard]] std::optional<Unexplained> remainder_by_nominal() const;

 private:
  /// The gross hypothesis that brings the readings nearest to what the nominal arm makes of them.
  struct Nearest {
    Hypothesis hypothesis;
    double before = 0.0, after = 0.0;  ///< discrepancies, mm
  };

  void try_gross();
  void try_all_radii();
  void try_local();
  [[nodiscard]] bool is_explained() const;
  void note(const std::string& excluded);
  void accept(Trial&& trial, const std::optional<Arm>& start = {});
  void try_all(const std::vector<Hypothesis>& hypotheses, const std::string& excluded);
  void try_ranked(const std::vector<Hypothesis>& hypotheses, const std::string& excluded);
  void try_radii();
  void try_placements();
  void try_within(int placement, const Trial& without);
  [[nodiscard]] Constraints constraints_of(const Recording& part) const;
  void try_slip();

  const Recording& recording_;
  const Constraints& constraints_;
  IdentifyOptions options_;
  const AsWritten& as_written_;
  TrialFits fits_;
  std::optional<Nearest> nearest_;
  std::vector<Trial> accepted_;
  std::vector<std::string> excluded_;
};

}  // namespace artcal
