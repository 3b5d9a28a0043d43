#pragma once

#include <string>

#include "acquisition/arm/arm.h"
#include "core/error.h"

namespace artcal {

/// The steps in which a controller or another program keeps an arm's numbers; 0: every digit.
struct RoundingSteps {
  double length = 0.0;  ///< mm
  double angle = 0.0;   ///< rad
};

/// `digits` decimals of a mm and of a degree.
RoundingSteps steps_of_digits(int digits);
/// Reads "length=0.001in,angle=19.8arcsec"; either may be left out. Usage: anything else.
Expected<RoundingSteps> steps_of_text(const std::string& text);

/// The arm with its lengths and angles at the nearest multiples of the steps. Errors of joints keep their digits.
Arm rounded(const RoundingSteps& steps, Arm arm);

/// By how much two arms of the same joints put their tips to different places, mm.
struct TipChange {
  int postures = 0;
  double rms = 0.0, maximum = 0.0;
  double rms_of_lengths = 0.0;  ///< of the distances between postures that follow one another
};

/// Over random postures of every probe, the joints within their stated ends.
TipChange tip_change(const Arm& from, const Arm& to, int postures = 2000);

}  // namespace artcal
