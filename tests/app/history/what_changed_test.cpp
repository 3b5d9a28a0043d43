#include "app/history/what_changed.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

namespace artcal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;

CalibrationStep step(std::size_t then, double maximum, bool significant) {
  CalibrationStep made;
  made.then = then;
  made.now = then + 1;
  made.chi_squared = significant ? 50.0 : 1.0;
  made.limit = 10.0;
  made.lengths = LengthChange{0.3 * maximum, maximum};
  return made;
}

// Identifications on consecutive days, with what changed between them.
ArmHistory days(const std::vector<CalibrationStep>& steps) {
  ArmHistory history;
  for (std::size_t i = 0; i <= steps.size(); ++i) {
    Calibration calibration;
    calibration.entry.date = fmt::format("2026-03-{:02}", i + 1);
    history.calibrations.push_back(calibration);
  }
  history.calibration_steps = steps;
  return history;
}

TEST(WhatChanged, TheLargestOfManyChangesIsNamedWithItsLengthsAndItsDay) {
  std::vector<CalibrationStep> steps;
  for (std::size_t i = 0; i < 19; ++i) {
    steps.push_back(step(i, i == 7 ? 0.090 : 0.002, true));
  }
  const auto sentences = what_changed(days(steps), "µm");
  ASSERT_THAT(sentences, SizeIs(1));
  EXPECT_TRUE(sentences[0].significant);
  EXPECT_THAT(sentences[0].text, AllOf(HasSubstr("measured lengths by up to 90.0 µm, 27.0 µm rms"),
                                       HasSubstr("on 2026-03-09 (since 2026-03-08)"), HasSubstr("19 of 19 steps")));
}

TEST(WhatChanged, ASmallChangeThatIsSignificantComesBeforeALargeOneThatIsNot) {
  const auto sentences = what_changed(days({step(0, 0.090, false), step(1, 0.002, true)}), "um");
  EXPECT_THAT(sentences[0].text, AllOf(HasSubstr("by up to 2.0 um"), HasSubstr("on 2026-03-03"), HasSubstr("1 of 2")));
  const auto none = what_changed(days({step(0, 0.090, false)}), "um");
  EXPECT_FALSE(none[0].significant);
  EXPECT_THAT(none[0].text, HasSubstr("no significant change, the largest, measured lengths by up to 90.0 um"));
}

TEST(WhatChanged, OfValuesTheLargestChangeOfALength) {
  ArmHistory history;
  history.verifications.resize(2);
  history.verifications[0].entry.date = "2026-03-01";
  history.verifications[1].entry.name = "undated";
  history.verifications[0].standard = history.verifications[1].standard = "iso10360-12";
  VerificationStep made{0, 1, {}, {}};
  const auto drift = [&](Quantity quantity, const char* second, double size, bool significant) {
    Drift one;
    one.quantity = quantity;
    one.first = "A";
    one.second = second;
    one.placement = "3";
    one.drift = size;
    one.significant = significant;
    made.check.drifts.push_back(one);
  };
  drift(Quantity::LengthUni, "B", 0.010, true);
  drift(Quantity::LengthUni, "C", -0.0234, true);
  drift(Quantity::LengthUni, "D", 0.5, false);
  drift(Quantity::FormError, "", 0.3, true);
  history.verification_steps.push_back(made);
  const auto sentences = what_changed(history, "µm");
  ASSERT_THAT(sentences, SizeIs(1));
  EXPECT_THAT(sentences[0].text,
              AllOf(HasSubstr("ISO 10360-12:2016: largest change, E_Uni A - C, placement 3, by -23.4 µm"),
                    HasSubstr("on no date, recording \"undated\" (since 2026-03-01)")));
}

TEST(WhatChanged, OfOneResultNothingIsSaid) { EXPECT_THAT(what_changed(days({}), "um"), SizeIs(0)); }

}  // namespace
}  // namespace artcal
