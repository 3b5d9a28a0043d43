#include "acquisition/csv/csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using Rows = std::vector<std::vector<std::string>>;

TextFile file(std::string text) { return {"f.csv", std::move(text), ""}; }

// The header and every row, or the first error as the only field.
Rows rows(const std::string& text) {
  const TextFile source = file(text);
  auto csv = CsvReader::open(source);
  if (!csv) {
    return {{csv.error().text()}};
  }
  Rows all{csv->header()};
  for (auto found = csv->next();; found = csv->next()) {
    if (!found) {
      return {{found.error().text()}};
    }
    if (!*found) {
      return all;
    }
    auto& row = all.emplace_back();
    for (std::size_t i = 0; i < csv->header().size(); ++i) {
      row.emplace_back(csv->field(i));
    }
  }
}

std::string refusal(const std::string& text) {
  const Rows all = rows(text);
  return all.size() == 1 && all[0].size() == 1 ? all[0][0] : "accepted";
}

TEST(Csv, ReadsRows) {
  EXPECT_EQ(rows("a,b\n1,2\n3,4\n"), (Rows{{"a", "b"}, {"1", "2"}, {"3", "4"}}));
  EXPECT_EQ(rows("a,b\n1,2"), (Rows{{"a", "b"}, {"1", "2"}}));
  EXPECT_EQ(rows("a\n1\n"), (Rows{{"a"}, {"1"}}));
}

TEST(Csv, EmptyFieldsCount) {
  EXPECT_EQ(rows("a,b,c\n,,\n1,,3\n"), (Rows{{"a", "b", "c"}, {"", "", ""}, {"1", "", "3"}}));
}

TEST(Csv, WindowsLineEndsBlankLinesAndRemarksMakeNoDifference) {
  const Rows plain{{"a", "b"}, {"1", "2"}, {"3", "4"}};
  EXPECT_EQ(rows("a,b\r\n1,2\r\n3,4\r\n"), plain);
  EXPECT_EQ(rows("# read on Monday\n\na,b\n1,2\n  \t\n# half time\n3,4\n\n\n"), plain);
  EXPECT_EQ(rows(" a , b \n 1,\t2 \n3 ,4\t\n"), plain);
}

TEST(Csv, QuotedFields) {
  EXPECT_EQ(rows("a,b\n\"x, y\",\"\"\n"), (Rows{{"a", "b"}, {"x, y", ""}}));
  EXPECT_EQ(rows("\"a\",b\n\"say \"\"so\"\"\",2\n \"p\" ,3\r\n"), (Rows{{"a", "b"}, {"say \"so\"", "2"}, {"p", "3"}}));
  EXPECT_EQ(rows("a,b\n1,\"# not a remark\"\n"), (Rows{{"a", "b"}, {"1", "# not a remark"}}));
}

TEST(Csv, BrokenQuotesAreNamed) {
  EXPECT_THAT(refusal("a,b\n1,\"open\n2,3\n"), StartsWith("f.csv:2:3: a quoted field is not closed"));
  EXPECT_THAT(refusal("a,b\n\"x\"y,2\n"), StartsWith("f.csv:2:1: a quoted field"));
  EXPECT_THAT(refusal("a,b\n1,\"\n"), HasSubstr("not closed"));
  EXPECT_THAT(refusal("\"a\n"), HasSubstr("f.csv:1:1"));
}

TEST(Csv, ShortAndLongRowsAreNamed) {
  EXPECT_EQ(refusal("a,b\n1,2\n3\n"), "f.csv:3:1: the line has 1 fields, expected 2 as in the header");
  EXPECT_EQ(refusal("a,b\n1,2,3\n"),
            "f.csv:2:1: the line has 3 fields, expected 2 as in the header; are there decimal commas? Numbers have "
            "points here");
  EXPECT_THAT(refusal("a,b\n1,2,\n"), HasSubstr("3 fields"));
}

TEST(Csv, HeadersAreChecked) {
  EXPECT_EQ(refusal("a,b,a\n1,2,3\n"), "f.csv:1:5: the column \"a\" is there twice");
  EXPECT_EQ(refusal("a,,b\n"), "f.csv:1:3: a column has no name");
  EXPECT_THAT(refusal("a;b\n1;2\n"), HasSubstr("separated by semicolons or tabs, expected commas"));
  EXPECT_THAT(refusal("a\tb\n1\t2\n"), HasSubstr("semicolons or tabs"));
  EXPECT_THAT(refusal("\n# nothing\n"), HasSubstr("the file has no header line"));
}

TEST(Csv, ControlCharactersAreRefused) {
  EXPECT_THAT(refusal("a,b\n1,x\x1b[2J\n"), StartsWith("f.csv:2:4: there is a control character (code 27)"));
  EXPECT_THAT(refusal("a,b\n1,x\u009b2J\n"), StartsWith("f.csv:2:4: there is a control character (code 155)"));
  EXPECT_THAT(refusal("a,b\r1,2\r"), HasSubstr("(code 13), expected plain text with lines that end in LF or CR LF"));
  EXPECT_THAT(refusal("a,b\x7f\n"), HasSubstr("code 127"));
}

TEST(Csv, NumbersAreFiniteAndWhole) {
  const TextFile source = file("a\n1\n-2.5e-3\n+4\n1e100\n.5\n5e-324\n");
  auto csv = CsvReader::open(source);
  for (const double expected : {1.0, -2.5e-3, 4.0, 1e100, 0.5, 5e-324}) {
    ASSERT_TRUE(csv->next().value());
    EXPECT_EQ(csv->number(0, "a number").value(), expected);
  }
  EXPECT_FALSE(csv->next().value());
}

TEST(Csv, WhatIsNoNumberIsQuotedWithItsPlace) {
  for (const std::string bad : {"x", "1.5x", "1,5", "nan", "-nan", "inf", "-inf", "infinity", "1e999", "1e101", "0x10",
                                "++1", "+-1", "1 2", "--", "1e", "", "٣"}) {
    const TextFile source = file("label,value\nµm,\"" + bad + "\"\n");
    auto csv = CsvReader::open(source);
    ASSERT_TRUE(csv->next().value());
    const auto number = csv->number(1, "an angle in deg");
    ASSERT_FALSE(number) << bad;
    const std::string shown = bad.empty() ? "nothing" : "\"" + bad + "\"";
    EXPECT_EQ(number.error().text(),
              "f.csv:2:4: column value: found " + shown + ", expected an angle in deg" +
                  (bad == "1,5" ? "; is the comma a decimal comma? Write \"1,5\" with a point: 1.5" : ""));
  }
}

TEST(Csv, PlacesCountCharactersAndLines) {
  const TextFile source = file("# µ\nlabel,value\n\n\"µ, 1\",x\n");
  auto csv = CsvReader::open(source);
  ASSERT_TRUE(csv->next().value());
  EXPECT_EQ(csv->line(), 4);
  EXPECT_EQ(csv->where(0), "f.csv:4:1");
  EXPECT_EQ(csv->where(1), "f.csv:4:8");
}

TEST(Csv, LongLinesAreReadOrRefusedBriefly) {
  const std::string long_label(1'000'000, 'x');
  EXPECT_EQ(rows("a,b\n" + long_label + ",2\n"), (Rows{{"a", "b"}, {long_label, "2"}}));
  const TextFile source = file("a\n" + long_label + "\n");
  auto csv = CsvReader::open(source);
  ASSERT_TRUE(csv->next().value());
  EXPECT_LT(csv->number(0, "a number").error().text().size(), 120u);
  EXPECT_LT(refusal(long_label + "," + long_label + "\n").size(), 120u);
  // A million columns, of another number than the header's.
  EXPECT_THAT(refusal("a,b\n" + std::string(1'000'000, ',') + "\n"), HasSubstr("1000001 fields"));
}

TEST(Csv, ColumnsAreFoundByName) {
  const TextFile source = file("a,b\n");
  const auto csv = CsvReader::open(source);
  EXPECT_EQ(csv->column("b"), 1u);
  EXPECT_FALSE(csv->column("B"));
}

}  // namespace
}  // namespace artcal
