#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquisition/point_cloud/cloud_limits.h"
#include "acquisition/point_cloud/pcd/pcd_file.h"
#include "core/units.h"
#include "tests/support/cloud_file.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A PCD of three float coordinates, to be spoiled line by line.
struct Header {
  std::string version = "VERSION 0.7\n";
  std::string fields = "FIELDS x y z\n";
  std::string size = "SIZE 4 4 4\n";
  std::string type = "TYPE F F F\n";
  std::string count = "COUNT 1 1 1\n";
  std::string width = "WIDTH 3\n";
  std::string height = "HEIGHT 1\n";
  std::string viewpoint = "VIEWPOINT 0 0 0 1 0 0 0\n";
  std::string points = "POINTS 3\n";
  std::string data = "DATA ascii\n";
  [[nodiscard]] std::string text() const {
    return "# .PCD v0.7 - Point Cloud Data file format\n" + version + fields + size + type + count + width + height +
           viewpoint + points + data;
  }
};

const std::string rows = "1 2 3\n4 5 6\n7 8 9.5\n";

std::string bytes_of(const std::vector<float>& numbers) {
  std::string bytes(numbers.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}
std::string length(std::size_t value) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) {
    bytes += static_cast<char>(value >> (8 * i));
  }
  return bytes;
}

const Eigen::Matrix3d nine = (Eigen::Matrix3d() << 1, 4, 7, 2, 5, 8, 3, 6, 9.5).finished();

class PcdFile : public testing::CloudFile {
 protected:
  Expected<PointCloud> read_pcd(std::string_view bytes) { return read("p.pcd", bytes); }
  std::string refused(const Header& header, const std::string& body = rows) {
    return refusal("p.pcd", header.text() + body);
  }
};

TEST_F(PcdFile, Ascii) {
  const auto cloud = read_pcd(Header{}.text() + rows);
  ASSERT_TRUE(cloud) << cloud.error().text();
  EXPECT_EQ(cloud->points, nine);
  EXPECT_THAT(cloud->warnings, IsEmpty());
}

TEST_F(PcdFile, Binary) {
  Header header;
  header.data = "DATA binary\n";
  const auto cloud = read_pcd(header.text() + bytes_of({1, 2, 3, 4, 5, 6, 7, 8, 9.5f}));
  ASSERT_TRUE(cloud) << cloud.error().text();
  EXPECT_EQ(cloud->points, nine);
  EXPECT_THAT(cloud->warnings, IsEmpty());
}

// Field by field, and packed by hand: one run of literals, one of 12 that repeats, one of literals.
TEST_F(PcdFile, BinaryCompressed) {
  Header header;
  header.data = "DATA binary_compressed\n";
  const std::string numbers = bytes_of({1, 4, 7, 2, 5, 8, 3, 6, 9.5f});
  const std::string packed = std::string(1, 31) + numbers.substr(0, 32) + std::string(1, 3) + numbers.substr(32);
  const auto cloud = read_pcd(header.text() + length(packed.size()) + length(numbers.size()) + packed);
  ASSERT_TRUE(cloud) << cloud.error().text();
  EXPECT_EQ(cloud->points, nine);
}

TEST_F(PcdFile, WhatIsNotNeededMayBeAbsent) {
  Header header;
  header.version = header.count = header.width = header.height = header.viewpoint = "";
  EXPECT_TRUE(read_pcd(header.text() + rows));
  header = {};
  header.points = "";
  header.fields = "COLUMNS x y z\n";
  EXPECT_TRUE(read_pcd(header.text() + rows));
  EXPECT_THAT(refused({.width = "", .points = ""}), HasSubstr("neither WIDTH nor POINTS"));
}

TEST_F(PcdFile, OtherFieldsArePassedOver) {
  Header header{.fields = "FIELDS _ z histogram y _ x\n",
                .size = "SIZE 1 4 2 8 1 4\n",
                .type = "TYPE U F I F U F\n",
                .count = "COUNT 4 1 3 1 4 1\n"};
  const auto ascii = read_pcd(header.text() +
                              "0 0 0 0 3 7 7 7 2 0 0 0 0 1\n0 0 0 0 6 7 7 7 5 0 0 0 0 4\n"
                              "0 0 0 0 9.5 7 7 7 8 0 0 0 0 7\n");
  ASSERT_TRUE(ascii) << ascii.error().text();
  EXPECT_EQ(ascii->points, nine);
  header.data = "DATA binary\n";
  std::string body;
  for (int i = 0; i < 3; ++i) {
    const double y = nine(1, i);
    std::string wide(8, '\0');
    std::memcpy(wide.data(), &y, 8);
    body += "----" + bytes_of({static_cast<float>(nine(2, i))}) + "------" + wide + "----" +
            bytes_of({static_cast<float>(nine(0, i))});
  }
  const auto binary = read_pcd(header.text() + body);
  ASSERT_TRUE(binary) << binary.error().text();
  EXPECT_EQ(binary->points, nine);
}

TEST_F(PcdFile, AViewpointIsNotApplied) {
  const auto cloud = read_pcd(Header{.viewpoint = "VIEWPOINT 0 0 100 1 0 0 0\n"}.text() + rows);
  ASSERT_TRUE(cloud);
  EXPECT_EQ(cloud->points, nine);
  EXPECT_THAT(cloud->warnings, ElementsAre(HasSubstr("VIEWPOINT other than the origin; it is not applied")));
}

TEST_F(PcdFile, SinglePrecisionFarOutIsSaid) {
  Header header;
  header.data = "DATA binary\n";
  const auto cloud = read_pcd(header.text() + bytes_of({50000, 0, 0, 50001, 0, 0, 50002, 1, 1}));
  ASSERT_TRUE(cloud);
  EXPECT_THAT(cloud->warnings,
              ElementsAre("the file has single precision, which rounds coordinates of 5e+04 mm by up to 0.003 mm"));
}

TEST_F(PcdFile, TheFirstPointGluedToTheDataLine) {
  EXPECT_EQ(
      refused({.data = "DATA ascii 1 2 3\n"}, "4 5 6\n7 8 9\n"),
      "p.pcd:11: DATA: found \"ascii 1 2 3\", expected ascii, binary or binary_compressed, and the first point after "
      "the end of this line");
  EXPECT_THAT(refused({.data = "DATA ascii1 2 3\n"}, "4 5 6\n7 8 9\n"), HasSubstr("found \"ascii1 2 3\""));
  EXPECT_THAT(refused({.data = "DATA binary"}, bytes_of({1, 2, 3, 4, 5, 6, 7, 8, 9})),
              HasSubstr("p.pcd:11: DATA: found"));
}

TEST_F(PcdFile, FewerOrMorePointsThanPromised) {
  EXPECT_THAT(refused({}, "1 2 3\n4 5 6\n"), HasSubstr("the header promises 3 points"));
  EXPECT_EQ(refused({}, "1.000 2.000 3.000\n4.000 5.000 6.000\n"),
            "p.pcd: the header promises 3 points, the file ends after 2; is it truncated?");
  EXPECT_EQ(refused({}, rows + "10 11 12\n"),
            "p.pcd:15: the header promises 3 points, but the file goes on after them");
  EXPECT_EQ(refused({.data = "DATA binary\n"}, bytes_of({1, 2, 3, 4, 5, 6, 7, 8})),
            "p.pcd: the header promises 3 points of 12 bytes, 36 together, but 32 follow; is the file truncated?");
  const auto longer = read_pcd(Header{.data = "DATA binary\n"}.text() + bytes_of({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
  ASSERT_TRUE(longer);
  EXPECT_THAT(longer->warnings, ElementsAre(HasSubstr("4 bytes follow the last point and were not read")));
}

TEST_F(PcdFile, CountsAreNotBelieved) {
  for (const char* data : {"DATA ascii\n", "DATA binary\n", "DATA binary_compressed\n"}) {
    const std::string body = length(900) + length(2'000'000'000u / 12 * 12) + std::string(900, '\1');
    EXPECT_THAT(refused({.width = "WIDTH 166666666\n", .points = "POINTS 166666666\n", .data = data}, body),
                HasSubstr(data == std::string("DATA binary_compressed\n") ? "damaged" : "promises 166666666 points"));
  }
  EXPECT_THAT(refused({.width = "WIDTH 4000000000\n"}), HasSubstr("p.pcd:7: WIDTH is 4000000000, expected at most"));
  EXPECT_THAT(refused({.width = "WIDTH 99999999999999999999\n"}), HasSubstr("expected a whole number"));
  EXPECT_THAT(refused({.width = "WIDTH -3\n"}), HasSubstr("WIDTH: found \"-3\", expected a whole number"));
  EXPECT_THAT(refused({.width = "WIDTH 65536\n", .height = "HEIGHT 65536\n"}), HasSubstr("contradicts itself"));
  EXPECT_EQ(refused({.width = "WIDTH 0\n", .points = "POINTS 0\n"}, ""), "p.pcd: the file holds no points");
}

TEST_F(PcdFile, HostileCompression) {
  const Header header{.data = "DATA binary_compressed\n"};
  EXPECT_THAT(refused(header, "abc"), HasSubstr("ends before the size of its compressed points"));
  EXPECT_THAT(refused(header, length(37) + length(36) + std::string(36, 'x')),
              HasSubstr("37 compressed bytes are promised"));
  EXPECT_THAT(refused(header, length(36) + length(35) + std::string(36, 'x')),
              HasSubstr("but 35 bytes are compressed"));
  for (const std::string& packed :
       {std::string("\x20\x00", 2), std::string("\x00\x41\xe0\xff\x00", 5), std::string("\x00\x41\xe0", 3),
        std::string("\x00\x41\xe0\x10", 4), std::string("\x1f", 1), std::string("\x00\x41\xe0\x1b\x00", 5),
        std::string("\x00\x41\xe0\x19\x01", 5)}) {
    EXPECT_THAT(refused(header, length(packed.size()) + length(36) + packed), HasSubstr("cannot be decompressed"));
  }
  // The same with the right length: one byte, and 35 that repeat it.
  const std::string good("\x00\x41\xe0\x1a\x00", 5);
  EXPECT_THAT(refused(header, length(good.size()) + length(36) + good), HasSubstr("all 3 points are the same"));
}

TEST_F(PcdFile, NonsenseInTheHeader) {
  EXPECT_THAT(refused({.version = "VERSION 2\n"}),
              HasSubstr("p.pcd:2: VERSION: found \"2\", expected 0.5, 0.6 or 0.7"));
  EXPECT_THAT(refused({.size = "SIZE 4 4\n"}), HasSubstr("p.pcd:4: SIZE has 2 values for 3 fields"));
  EXPECT_THAT(refused({.size = "SIZE 3 4 4\n"}), HasSubstr("has TYPE \"F\" and SIZE \"3\""));
  EXPECT_THAT(refused({.type = "TYPE F Q F\n"}), HasSubstr("has TYPE \"Q\""));
  EXPECT_THAT(refused({.count = "COUNT 1 0 1\n"}), HasSubstr("the field y has COUNT 0"));
  EXPECT_THAT(refused({.count = "COUNT 1 -1 1\n"}), HasSubstr("expected a whole number"));
  EXPECT_THAT(refused({.count = "COUNT 1 2 1\n"}), HasSubstr("the field y has COUNT 2"));
  EXPECT_THAT(refused({.count = "COUNT 1 4000000000 1\n"}), HasSubstr("has COUNT 4000000000"));
  EXPECT_THAT(refused({.fields = "FIELDS x x z\n"}), HasSubstr("the field x is there twice"));
  EXPECT_THAT(refused({.fields = "FIELDS x y w\n"}), HasSubstr("there is no field z among x, y, w"));
  EXPECT_THAT(refused({.height = "HEIGHT 1\nHEIGHT 1\n"}), HasSubstr("p.pcd:9: HEIGHT is there twice"));
  EXPECT_THAT(refused({.viewpoint = "VIEWPOINT 0 0\n"}), HasSubstr("expected seven numbers"));
  EXPECT_THAT(refused({.viewpoint = "VIEW 0\n"}),
              HasSubstr("p.pcd:9: found \"VIEW\", expected a line of a PCD header"));
  EXPECT_THAT(refused({.data = "DATA\n"}), HasSubstr("DATA: found nothing"));
  EXPECT_THAT(refused({.size = "SIZE 8 8 8\n", .type = "TYPE I F F\n"}), HasSubstr("a double holds exactly"));
  EXPECT_THAT(refused({.data = ""}, ""), HasSubstr("the header has no line DATA"));
  EXPECT_THAT(refused({.fields = "FIELDS x y z" + std::string(100'000, ' ')}),
              HasSubstr("a line of the header does not end"));
}

TEST_F(PcdFile, RowsThatAreNotWhatTheHeaderSays) {
  EXPECT_EQ(refused({}, "1 2 3\n4 5\n6 7 8 9\n"), "p.pcd:13: the line has 2 numbers, expected 3 as the header says");
  EXPECT_EQ(refused({}, "1 2 3\n4 hello 6\n7 8 9\n"),
            "p.pcd:13: column 2: found \"hello\", expected a number with a decimal point");
}

// So many points of three doubles, all zero: two bytes of literal zeros, then runs of 264.
std::string equal_points(std::size_t points) {
  const std::size_t size = 24 * points;
  std::string body("\0\0", 2);
  for (std::size_t left = size - 1; left > 0;) {
    const std::size_t run = std::min<std::size_t>(left, left > 264 && left < 267 ? 200 : 264);
    body += run > 8 ? std::string{'\xe0', static_cast<char>(run - 9), '\0'}
                    : std::string{static_cast<char>((run - 2) << 5), '\0'};
    left -= run;
  }
  Header header;
  header.size = "SIZE 8 8 8\n";
  header.width = fmt::format("WIDTH {}\n", points);
  header.points = fmt::format("POINTS {}\n", points);
  header.data = "DATA binary_compressed\n";
  return header.text() + length(body.size()) + length(size) + body;
}

TEST_F(PcdFile, CompressedPointsTakeNoMoreMemoryThanIsAllowed) {
  const std::string sound = equal_points(1000);
  EXPECT_THAT(refusal("p.pcd", sound), HasSubstr("all 1000 points are the same")) << "decompressed, and looked at";
  const std::string bomb = equal_points(12'000'000);
  EXPECT_LT(bomb.size(), std::size_t{4} << 20);
  EXPECT_THAT(refusal("p.pcd", bomb),
              HasSubstr("the file of 3.1 MiB holds 12000000 compressed points, which take 595 MiB "
                        "of memory, more than the 256 MiB that are allowed"));
  const auto with_limit = [&](std::size_t bytes) {
    return parse_pcd({"p.pcd", sound, "hash"}, CloudUnits{}, CloudLimits{bytes}).error().text();
  };
  EXPECT_THAT(with_limit(50'000), HasSubstr("or allow more with --max-memory"));
  EXPECT_THAT(with_limit(53'000), HasSubstr("all 1000 points are the same"));
}

}  // namespace
}  // namespace artcal
