#pragma once

#include <optional>
#include <vector>

#include "identification/identify.h"
#include "identification/inspection/hypotheses/hypothesis.h"

namespace artcal {

/// In which order the readings stand before and after a slip: as they were taken, or by the joint's angle (an encoder
/// that wraps: above some angle another zero).
enum class SlipOrder { Time, Angle };

/// A joint whose zero is another for the readings after some place in that order.
struct EncoderSlip {
  int joint = 0;
  SlipOrder order = SlipOrder::Time;
  std::vector<bool> after;  ///< for each reading
  int first = 0;            ///< the first reading after it, in that order
  double angle = 0.0;       ///< rad, of the readings after it
  double size = 0.0;        ///< of the residuals, mm a coordinate, by a fit in which the angle is a parameter
  Arm arm;                  ///< of that fit
};

/// The slip that explains the readings best: by a fit with a robust loss for each joint and some places of both orders,
/// which readings between the place and the slip do not mislead, then by the place at which the readings are nearest to
/// what the arm of the best makes of them. The angle is the gain of a joint that is put into the chain beside the
/// slipped one and reads 1 rad after the slip and 0 before. Nothing where no fit converges.
std::optional<EncoderSlip> find_encoder_slip(const Recording& recording, const Constraints& constraints,
                                             const IdentifyOptions& options);

/// The recording with the slip taken off.
Hypothesis slip_hypothesis(const Recording& recording, const EncoderSlip& slip);

}  // namespace artcal
