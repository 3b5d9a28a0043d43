#pragma once

#include <optional>
#include <vector>

#include "identification/identify.h"
#include "identification/inspection/as_written.h"
#include "identification/inspection/hypotheses/hypothesis.h"
#include "identification/inspection/hypotheses/step_scores.h"

namespace artcal {

/// A joint whose zero is another for the readings after some place in that order.
struct EncoderSlip {
  int joint = 0;
  SlipOrder order = SlipOrder::Time;
  std::vector<bool> after;  ///< for each reading
  int first = 0;            ///< the first reading after it, in that order
  double change = 0.0;      ///< of the readings after it, rad; of a prismatic joint mm
  double size = 0.0;        ///< of the residuals, mm a coordinate, by a fit in which the change is a parameter
  Arm arm;                  ///< of that fit
};

/// The slip that explains the readings best. Joints and places are ranked by linearised fits (step_scores.h): at the
/// nominal arm, there with the balls taken for points along the stylus, which a slip of many degrees does not mislead,
/// and at the arm of the readings as they are written, which shows the slips that are smaller than the arm's errors.
/// The few best are fitted with a robust loss, which readings between the place and the slip do not mislead; then the
/// place is where the readings are nearest to what the arm of the best makes of them. The change is the gain of a joint
/// that is put into the chain beside the slipped one and reads 1 rad (1 mm) after the slip and 0 before. Nothing where
/// no fit converges.
std::optional<EncoderSlip> find_encoder_slip(const Recording& recording, const Constraints& constraints,
                                             const IdentifyOptions& options, const AsWritten& as_written);

/// The recording with the slip taken off.
Hypothesis slip_hypothesis(const Recording& recording, const EncoderSlip& slip);

}  // namespace artcal
