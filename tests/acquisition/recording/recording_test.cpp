#include "acquisition/recording/recording.h"

#include <gtest/gtest.h>

namespace artcal {
namespace {

TEST(Recording, WhereNamesTheFileAndLineOfAReading) {
  Recording recording;
  recording.files = {"first.csv", "second.csv"};
  recording.readings.resize(2);
  recording.readings[0].line = 2;
  recording.readings[1].file = 1;
  recording.readings[1].line = 17;
  EXPECT_EQ(recording.where(0), "first.csv:2");
  EXPECT_EQ(recording.where(1), "second.csv:17");
}

TEST(Noise, IsGivenByAnyOfItsParts) {
  EXPECT_FALSE(Noise{}.is_given());
  EXPECT_TRUE((Noise{0.01, {}, {}}.is_given()));
  EXPECT_TRUE((Noise{{}, 1e-5, 0.003}.is_given()));
}

}  // namespace
}  // namespace artcal
