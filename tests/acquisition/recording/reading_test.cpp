#include "acquisition/recording/reading.h"

#include <gtest/gtest.h>

namespace artcal {
namespace {

TEST(Labels, CountInOrderOfFirstAppearance) {
  Labels labels;
  EXPECT_EQ(labels.size(), 0);
  EXPECT_EQ(labels.index_of("bar"), 0);
  EXPECT_EQ(labels.index_of("plate"), 1);
  EXPECT_EQ(labels.index_of("bar"), 0);
  EXPECT_EQ(labels.index_of(""), 2);
  EXPECT_EQ(labels.size(), 3);
  EXPECT_EQ(labels.name(1), "plate");
  EXPECT_EQ(labels.name(2), "");
}

TEST(Labels, FindAddsNothing) {
  Labels labels;
  labels.index_of("bar");
  EXPECT_EQ(labels.find("bar"), 0);
  EXPECT_EQ(labels.find("Bar"), -1);
  EXPECT_EQ(labels.size(), 1);
}

}  // namespace
}  // namespace artcal
