// Texts of points as other programs write them: marks, counts, running numbers, times, other separators.
#include "acquisition/point_cloud/read_cloud.h"

#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/random.h"
#include "tests/support/cloud_file.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ReadCloudText : public testing::CloudFile {
 protected:
  Expected<ReadCloud> take(std::string_view name, std::string_view bytes, const TextColumns& columns = {}) {
    return read_cloud(folder_.write(name, bytes), {}, columns);
  }
  void expect_points(std::string_view name, std::string_view bytes) {
    const auto read = take(name, bytes);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->cloud.points, (Eigen::Matrix3Xd(3, 3) << 1.25, -4, 7, 2, 500, 0.5, -3, 6, 0.125).finished())
        << bytes;
  }
};

TEST_F(ReadCloudText, AByteOrderMarkIsPassedOver) {
  expect_points("p.xyz",
                "\xEF\xBB\xBF"
                "1.25 2 -3\n-4 500 6\n7 .5 .125\n");
  expect_points("p.xyz", "\xEF\xBB\xBF# comment\n1.25 2 -3\n-4 500 6\n7 .5 .125\n");
  expect_points("p.csv", "\xEF\xBB\xBFx,y,z\n1.25,2,-3\n-4,500,6\n7,.5,.125\n");
  expect_points(
      "p.ply",
      "\xEF\xBB\xBFply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double "
      "z\nend_header\n1.25 2 -3\n-4 500 6\n7 .5 .125\n");
  EXPECT_THAT(refusal("p.txt", std::string_view("\xFF\xFE"
                                                "1\0 \0",
                                                6)),
              HasSubstr("UTF-16"));
}

TEST_F(ReadCloudText, TheCountOfAPts) {
  expect_points("p.pts", "3\n1.25 2 -3\n-4 500 6\n7 .5 .125\n");
  expect_points("p.pts", "3 \r\n1.25 2 -3 -1500 1 2 3\r\n-4 500 6 -1500 1 2 3\r\n7 .5 .125 -1500 1 2 3\r\n");
  expect_points("p.txt", "//X Y Z\n3\n1.25 2 -3\n-4 500 6\n7 .5 .125\n");
  expect_points("p.txt", "X Y Z\n3\n1.25 2 -3\n-4 500 6\n7 .5 .125\n");
  expect_points("p.pts", "2\n1.25 2 -3\n-4 500 6\n1\n7 .5 .125\n");  // two scans
  EXPECT_EQ(refusal("p.pts", "4\n1.25 2 -3\n-4 500 6\n7 .5 .125\n"),
            "p.pts:1: the line promises 4 points, 3 follow; is the file truncated?");
  EXPECT_THAT(refusal("p.pts", "2\n1.25 2 -3\n-4 500 6\n7 .5 .125\n"), HasSubstr("promises 2 points, 3 follow"));
  EXPECT_THAT(refusal("p.pts", "200\n"), HasSubstr("looks like the number of points of a PTS file"));
}

TEST_F(ReadCloudText, LinesOfOneNumberAreNoPoints) {
  EXPECT_THAT(refusal("p.txt", "1\n2\n3\n"), HasSubstr("the line has 1 column, expected at least 3"));
}

TEST_F(ReadCloudText, FortranExponents) {
  expect_points("p.xyz", "0.125D+01 2.0d0 -3.D0\n-4D0 5.0D+02 6\n7 5D-01 .125\n");
  EXPECT_THAT(refusal("p.xyz", "1 2 3\n4 5 D2\n"), HasSubstr("found \"D2\""));
  EXPECT_THAT(refusal("p.xyz", "1 2 3\n4 5 1D2D3\n"), HasSubstr("found \"1D2D3\""));
}

TEST_F(ReadCloudText, SemicolonsWithADecimalComma) {
  expect_points("p.csv", "X;Y;Z\n1,25;2;-3\n-4;500;6\n7;0,5;0,125\n");
  expect_points("p.csv", "\"Z\";\"X\";\"Y\"\r\n-3;1,25;2\r\n6;-4;5,0e2\r\n0,125;7;,5\r\n");
  expect_points("p.csv", "1.25;2;-3\n-4;500;6\n7;0.5;0.125\n");
  EXPECT_THAT(refusal("p.csv", "x;y;z\n1,25;2;-3\n1.234;2;3\n"), HasSubstr("decimal points and decimal commas"));
  EXPECT_THAT(refusal("p.csv", "x;y;z\n1.234,5;2;-3\n"), HasSubstr("found \"1.234,5\""));
}

TEST_F(ReadCloudText, SaysWhichColumns) {
  EXPECT_EQ(take("p.xyz", "1 2 3\n4 5 7\n")->columns, "columns 1, 2, 3 of 3, without a header");
  EXPECT_EQ(take("p.csv", "t,z,y,x\n9,1,2,3\n8,4,5,6\n")->columns, "columns 4, 3, 2 of 4, named x, y, z by the header");
  EXPECT_EQ(take("p.xyz", "9 1 2 3\n8 4 5 7\n", {{2, 3, 4}})->columns, "columns 2, 3, 4 of 4, as stated");
}

TEST_F(ReadCloudText, StatedColumns) {
  const Eigen::Vector3d first(1.5, 2.5, 3.5);
  EXPECT_EQ(take("p.xyz", "1 1.5 2.5 3.5\n2 4 5 6\n3 4 5 7\n", {{2, 3, 4}})->cloud.points.col(0), first);
  EXPECT_EQ(take("p.xyz", "P1 1.5 2.5 3.5\nP2 4 5 6\n", {{2, 3, 4}})->cloud.points.col(0), first);
  EXPECT_EQ(take("p.csv", "z,x,y\n3.5,1.5,2.5\n1,2,3\n", {{2, 3, 1}})->cloud.points.col(0), first);
  EXPECT_THAT(take("p.xyz", "1 2 3\n4 5 6\n", {{2, 3, 4}}).error().text(), HasSubstr("column 4 is stated"));
  EXPECT_THAT(take("p.pcd",
                   "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3\n",
                   {{1, 2, 3}})
                  .error()
                  .text(),
              HasSubstr("columns are stated by number"));
  EXPECT_THAT(refusal("p.xyz", "P1 1.5 2.5 3.5\nP2 4 5 6\n"), HasSubstr("--columns"));
}

// ---- what a first column may be ------------------------------------------------------------------------------

/// Points of a ball, a plane or an arc, each with something before them.
std::string table(int rows, const std::function<std::string(int)>& first, int shape, char separator = ' ') {
  RandomStream random(4, "rows", static_cast<std::uint64_t>(shape));
  std::string text;
  for (int i = 0; i < rows; ++i) {
    Eigen::Vector3d p = Eigen::Vector3d(300.0, 200.0, 100.0) + 12.0 * random.direction();
    if (shape == 1) {
      p = {random.uniform(0.0, 400.0), random.uniform(0.0, 300.0), 12.5 + 0.001 * random.normal()};
    } else if (shape == 2) {
      p = {500.0 * std::cos(0.05 * i), 500.0 * std::sin(0.05 * i), 800.0};
    }
    text += fmt::format("{}{s}{:.4f}{s}{:.4f}{s}{:.4f}\n", first(i), p.x(), p.y(), p.z(), fmt::arg("s", separator));
  }
  return text;
}

TEST_F(ReadCloudText, RunningNumbersAndTimesAreNoX) {
  double time = 0.0;
  RandomStream random(9, "clock");
  const std::vector<std::function<std::string(int)>> firsts{
      [](int i) { return fmt::format("{}", i + 1); },
      [](int i) { return fmt::format("{}", i); },
      [](int i) { return fmt::format("{}.0", i + 1); },
      [](int i) { return fmt::format("{}", 10 * (i + 1)); },
      [](int i) { return fmt::format("{}", 1001 + i + i / 3); },
      [](int i) { return fmt::format("{}", i % 7 + 1); },              // again from 1 for each feature
      [](int i) { return fmt::format("{}", (i * 37) % 101); },         // numbered, but sorted otherwise
      [](int i) { return fmt::format("{}", 500 - i); },                // backwards
      [](int i) { return fmt::format("{:.6f}", 3.0 + 0.05 * i); },     // even time
      [](int i) { return fmt::format("{}", 1'700'000'000 + i / 4); },  // clock in whole seconds
      [&](int) { return fmt::format("{:.4f}", time += random.uniform(0.001, 0.02)); },
  };
  for (std::size_t k = 0; k < firsts.size(); ++k) {
    for (const int rows : {9, 12, 60}) {
      for (const int shape : {0, 1, 2}) {
        for (const char separator : {' ', ',', '\t'}) {
          EXPECT_THAT(refusal("p.txt", table(rows, firsts[k], shape, separator)),
                      AllOf(HasSubstr("4 columns without a header"), HasSubstr("--columns 2,3,4")))
              << "first column " << k << ", " << rows << " rows, shape " << shape;
        }
      }
    }
  }
}

TEST_F(ReadCloudText, CoordinatesAreX) {
  RandomStream random(10, "intensity");
  const auto x = [&](int) { return fmt::format("{:.3f}", random.uniform(-50.0, 50.0)); };
  for (const int rows : {3, 4, 6, 10, 200}) {
    const auto read = take("p.txt", table(rows, x, 1));
    ASSERT_TRUE(read) << read.error().text();
    if (rows >= 6) {
      EXPECT_THAT(read->cloud.warnings, IsEmpty()) << rows;
    }
  }
  // Three columns are all there is; a count stated to be x is believed.
  EXPECT_TRUE(take("p.txt", "1 2.5 3.5\n2 2.5 3.6\n3 2.7 3.5\n"));
  EXPECT_TRUE(take("p.txt", "1 2.5 3.5 7\n2 2.5 3.6 7\n3 2.7 3.5 7\n", {{1, 2, 3}}));
  EXPECT_TRUE(take("p.csv", "x,y,z,i\n1,2.5,3.5,7\n2,2.5,3.6,7\n3,2.7,3.5,7\n"));
}

TEST_F(ReadCloudText, WhatFewRowsLeaveOpenIsAskedAbout) {
  const auto read = take("p.txt", "0.1 1.5 2.5 3.5\n0.2 1.4 2.6 3.5\n0.3 1.3 2.2 3.5\n");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_THAT(read->cloud.warnings, ::testing::Contains(HasSubstr("was taken for x")));
}

// As drivers write padding: a field of COUNT 0 takes no bytes.
TEST_F(ReadCloudText, APcdFieldOfCountZero) {
  std::string bytes =
      "VERSION 0.7\nFIELDS x y z _ t _\nSIZE 8 8 8 2 4 1\nTYPE F F F U U U\nCOUNT 1 1 1 0 1 3\nWIDTH 2\nHEIGHT "
      "1\nPOINTS "
      "2\nDATA binary\n";
  for (const double p : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) {
    bytes.append(reinterpret_cast<const char*>(&p), sizeof p);
    if (p == 3.0 || p == 6.0) {
      bytes.append(7, '\1');
    }
  }
  const auto read = take("p.pcd", bytes);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->cloud.points, (Eigen::Matrix3Xd(3, 2) << 1, 4, 2, 5, 3, 6).finished());
  EXPECT_EQ(read->columns, "the fields x, y, z");
}

}  // namespace
}  // namespace artcal
