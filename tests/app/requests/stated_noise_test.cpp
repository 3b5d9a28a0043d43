#include "app/requests/stated_noise.h"

#include <gmock/gmock.h>

namespace artcal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string refusal(const Expected<double>& read) { return read ? "" : read.error().message; }

TEST(StatedNoise, IsReadWithItsUnit) {
  EXPECT_DOUBLE_EQ(*stated_length_noise("3 um", "--noise"), 0.003);
  EXPECT_NEAR(*stated_angle_noise("2 arcsec", "--encoder-noise"), 9.696273622e-6, 1e-14);
}

TEST(StatedNoise, IsRefusedWithWhatWasExpected) {
  EXPECT_THAT(refusal(stated_length_noise("3", "--noise")),
              AllOf(HasSubstr("--noise is \"3\""), HasSubstr("\"3 um\"")));
  EXPECT_THAT(refusal(stated_angle_noise("2 um", "--encoder-noise")), HasSubstr("\"2 arcsec\""));
  EXPECT_THAT(refusal(stated_angle_noise("0 arcsec", "--encoder-noise")), HasSubstr("above zero"));
  EXPECT_THAT(refusal(stated_length_noise("", "--probing-noise")), HasSubstr("--probing-noise is \"\""));
}

TEST(StatedNoise, IsRefusedWhereNoMeasurementHasIt) {
  EXPECT_THAT(refusal(stated_length_noise("3000 m", "--noise")), HasSubstr("is the unit right?"));
  EXPECT_THAT(refusal(stated_angle_noise("90 deg", "--encoder-noise")), HasSubstr("is the unit right?"));
}

TEST(StatedNoise, MayBeZeroWhereThatIsAllowed) {
  EXPECT_EQ(*stated_angle_noise("0 arcsec", "--encoder-noise", ZeroNoise::Allowed), 0.0);
  EXPECT_THAT(refusal(stated_length_noise("3000 m", "--noise", ZeroNoise::Allowed)),
              HasSubstr("expected 0 or a standard deviation of"));
  EXPECT_THAT(refusal(stated_length_noise("2", "--noise", ZeroNoise::Allowed)),
              HasSubstr("expected 0 or a number above zero with its unit"));
}

TEST(StatedNoise, AsksAboutADecimalComma) {
  EXPECT_THAT(refusal(stated_length_noise("3,5 um", "--noise")), HasSubstr("decimal comma"));
}

}  // namespace
}  // namespace artcal
