#include "acquisition/csv/csv_text.h"

#include <gtest/gtest.h>

#include "acquisition/csv/csv.h"

namespace artcal {
namespace {

TEST(CsvText, EveryLabelComesBack) {
  for (const std::string label : {"A", "", "a,b", "say \"x\"", "#1", " A ", "a;b", "=1+1", "@SUM", "-x", "+x", "'=1",
                                  "''@", "'", "'quoted'", "-1", "+2.5e-3", "ä"}) {
    const TextFile file{"t.csv", "first,second\n" + csv_field(label) + ",x\n", ""};
    auto csv = CsvReader::open(file);
    ASSERT_TRUE(csv);
    ASSERT_TRUE(csv->next().value_or(false)) << label;
    EXPECT_EQ(without_guard(csv->field(0)), label);
  }
}

TEST(CsvText, NoSpreadsheetRunsALabel) {
  EXPECT_EQ(csv_field("=cmd|' /C calc'!A0"), "\"'=cmd|' /C calc'!A0\"");
  EXPECT_EQ(csv_field("@SUM"), "'@SUM");
  EXPECT_EQ(csv_field("-1"), "-1") << "a number is no formula";
}

}  // namespace
}  // namespace artcal
