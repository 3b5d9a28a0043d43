#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "identification/problem/system.h"

namespace artcal {

/// What the inputs of an identification are uncertain by, as standard deviations.
struct InputSpread {
  double encoder = 0.0;          ///< of each joint's reading, rad
  double probing = 0.0;          ///< of each coordinate of the tip, mm
  double temperature = 0.0;      ///< of an artefact's temperature in a placement, K
  double arm_temperature = 0.0;  ///< of the arm's in a placement, K
  double scale_factor = 1.0;     ///< factor on all of them and on those of the certificates
  /// Where the noise was estimated from residuals: their degrees of freedom. Each trial then draws what the noise may
  /// be as well, so that what comes out is t-distributed (JCGM 101 §6.4.9).
  std::optional<int> degrees_of_freedom;
};

/// One trial's inputs: the readings and the certificates' numbers, each moved by a draw from its distribution. All
/// normal. Readings are independent of each other; an error of a certificate is one for all placements of its artefact,
/// and independent from number to number; expansion is one for all lengths of an artefact, temperature for those of a
/// placement; the arm's temperature for all readings of a placement. The memory is used again for the next trial.
class TrialInputs {
 public:
  /// `system` and what it refers to must outlive this.
  TrialInputs(const System& system, const Recording& recording, const InputSpread& spread);
  TrialInputs(const TrialInputs&) = delete;
  TrialInputs& operator=(const TrialInputs&) = delete;

  /// Draws trial number `trial`; nothing is left of the one before. The same three arguments of the seed, the stream's
  /// name and the trial give the same bits.
  void draw(std::uint64_t seed, std::uint64_t trial);

  /// With the drawn readings and certificates.
  [[nodiscard]] const System& system() const { return drawn_; }

 private:
  void draw_readings(std::uint64_t seed, std::uint64_t trial);
  void draw_certificates(std::uint64_t seed, std::uint64_t trial);
  void draw_arm_temperatures(std::uint64_t seed, std::uint64_t trial);

  const System& base_;
  InputSpread spread_;
  std::vector<double> above_reference_;  // of each feature, K
  std::vector<int> certificates_;        // of each distance: into all certified ones, artefact after artefact; or -1
  Constraints constraints_;
  System drawn_;
};

}  // namespace artcal
