#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/cloud_file.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string xyz = "property double x\nproperty float y\nproperty short z\n";
const std::string vertex = "element vertex 2\n" + xyz;
const std::string faces = "element face 2\nproperty list uchar int vertex_indices\n";

std::string header(const std::string& format, const std::string& elements) {
  return "ply\nformat " + format + " 1.0\ncomment by hand\n" + elements + "end_header\n";
}

template <typename T>
std::string number(T value, bool big) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (big != (std::endian::native == std::endian::big)) {
    std::reverse(bytes.begin(), bytes.end());
  }
  return bytes;
}

std::string two_points(bool big) {
  return number(0.1, big) + number(2.5f, big) + number<std::int16_t>(-300, big) + number(4.0, big) +
         number(-5.0f, big) + number<std::int16_t>(6, big);
}

const Eigen::Matrix<double, 3, 2> two = (Eigen::Matrix<double, 3, 2>() << 0.1, 4, 2.5, -5, -300, 6).finished();

class PlyFile : public testing::CloudFile {
 protected:
  std::string refused(std::string_view bytes) { return refusal("p.ply", bytes); }
  void expect_two(const std::string& bytes) {
    const auto cloud = read("p.ply", bytes);
    ASSERT_TRUE(cloud) << cloud.error().text();
    EXPECT_EQ(cloud->points, two);
    EXPECT_THAT(cloud->warnings, IsEmpty());
  }
};

TEST_F(PlyFile, Ascii) {
  expect_two(header("ascii", vertex) + "0.1 2.5 -300\n4 -5 6\n");
  expect_two("ply\r\nformat ascii 1.0\r\n" + vertex + "end_header\r\n0.1 2.5 -300\r\n4 -5 6\r\n");
}

TEST_F(PlyFile, BinaryOfBothByteOrders) {
  expect_two(header("binary_little_endian", vertex) + two_points(false));
  expect_two(header("binary_big_endian", vertex) + two_points(true));
}

TEST_F(PlyFile, FacesBeforeAndBehindThePointsArePassedOver) {
  expect_two(header("ascii", vertex + faces) + "0.1 2.5 -300\n4 -5 6\n3 0 1 1\n2 0 1\n");
  expect_two(header("ascii", faces + vertex) + "3 0 1 1\n2 0 1\n0.1 2.5 -300\n4 -5 6\n");
  for (const bool big : {false, true}) {
    std::string lists = number<std::uint8_t>(3, big) + number(0, big) + number(1, big) + number(1, big);
    lists += number<std::uint8_t>(0, big);
    const std::string format = big ? "binary_big_endian" : "binary_little_endian";
    expect_two(header(format, faces + vertex) + lists + two_points(big));
    expect_two(header(format, vertex + faces) + two_points(big) + lists);
    expect_two(header(format, "element camera 1\nproperty int8 a\nproperty float64 b\n" + vertex) +
               number<std::int8_t>(1, big) + number(2.0, big) + two_points(big));
  }
}

TEST_F(PlyFile, ListsAmongThePointsAreRefused) {
  EXPECT_EQ(refused(header("ascii", vertex + "property list uchar int neighbours\n") + "1 2 3 0\n4 5 6 0\n"),
            "p.ply: the element vertex has a list among its properties, which is not read; export without it");
}

TEST_F(PlyFile, FewerOrMorePointsThanPromised) {
  EXPECT_EQ(refused(header("ascii", vertex) + "1.0000 2.0000 3.0000\n"),
            "p.ply: the header promises 2 points, but the file ends before that; is it truncated?");
  EXPECT_EQ(refused(header("binary_little_endian", vertex) + two_points(false).substr(1)),
            "p.ply: the header promises 2 points, but the file ends before that; is it truncated?");
  EXPECT_EQ(refused(header("ascii", vertex) + "1 2 3\n4 5 6\n7 8 9\n"),
            "p.ply:11: the header promises 2 points, but the file goes on after them");
  EXPECT_THAT(read("p.ply", header("binary_big_endian", vertex) + two_points(true) + "more")->warnings,
              ElementsAre(HasSubstr("4 bytes follow the last point")));
  EXPECT_EQ(refused(header("ascii", "element vertex 0\n" + xyz)), "p.ply: the file holds no points");
}

TEST_F(PlyFile, CountsAreNotBelieved) {
  const std::string huge = "element vertex 2000000000\n" + xyz;
  for (const char* format : {"ascii", "binary_little_endian"}) {
    EXPECT_THAT(refused(header(format, huge) + two_points(false)),
                HasSubstr("promises 2000000000 points, but the file"));
    EXPECT_THAT(refused(header(format, "element face 2000000000\nproperty list uint int i\n" + vertex) + "1 0\n"),
                HasSubstr("promises 2000000000 records of the element \"face\""));
  }
  EXPECT_THAT(refused(header("ascii", "element vertex 99999999999\n" + xyz)), HasSubstr("p.ply:4: expected element"));
  EXPECT_THAT(refused(header("ascii", "element vertex -1\n" + xyz)), HasSubstr("a whole number up to"));
  // A list of -1 or of four thousand million items in front of the points.
  EXPECT_THAT(refused(header("binary_little_endian", "element face 1\nproperty list char int i\n" + vertex) + "\xff" +
                      two_points(false)),
              HasSubstr("promises 1 records"));
  EXPECT_THAT(refused(header("binary_little_endian", "element face 1\nproperty list uint double i\n" + vertex) +
                      "\xff\xff\xff\xff" + two_points(false)),
              HasSubstr("promises 1 records"));
}

TEST_F(PlyFile, NonsenseInTheHeader) {
  EXPECT_THAT(refused("ply\n" + vertex + "end_header\n1 2 3\n4 5 6\n"), HasSubstr("no line that says the format"));
  EXPECT_THAT(refused(header("binary", vertex)), HasSubstr("p.ply:2: format: expected ascii, binary_little_endian"));
  EXPECT_THAT(refused("ply\nformat ascii 1.0\nformat ascii 1.0\nend_header\n"),
              HasSubstr("p.ply:3: format is there twice"));
  EXPECT_THAT(refused(header("ascii", "property float x\n")), HasSubstr("p.ply:4: a property without an element"));
  EXPECT_THAT(refused(header("ascii", "element vertex 1\nproperty quad x\n")), HasSubstr("p.ply:5: expected property"));
  EXPECT_THAT(refused(header("ascii", "element vertex 1\nproperty list float int x\n")),
              HasSubstr("p.ply:5: expected property"));
  EXPECT_THAT(refused(header("ascii", vertex + "property double x\n")), HasSubstr("the field x is there twice"));
  EXPECT_THAT(refused(header("ascii", faces) + "1 0\n1 0\n"), HasSubstr("no element vertex"));
  EXPECT_THAT(refused(header("ascii", vertex + vertex)), HasSubstr("the element vertex is there twice"));
  EXPECT_THAT(refused(header("ascii", "element vertex 1\nproperty uchar green\n") + "1\n"),
              HasSubstr("no field x among green"));
  EXPECT_THAT(refused("ply\nformat ascii 1.0\n" + vertex + "end_header 1 2 3\n4 5 6\n"),
              HasSubstr("p.ply:7: end_header: expected nothing behind it"));
  EXPECT_THAT(refused("ply\nformat ascii 1.0\n" + vertex + "end_header1 2 3\n4 5 6\n"),
              HasSubstr("p.ply:7: found \"end_header1\""));
  EXPECT_THAT(refused("ply\nformat ascii 1.0\n" + vertex), HasSubstr("without a line end_header"));
}

TEST_F(PlyFile, RowsThatAreNotWhatTheHeaderSays) {
  EXPECT_EQ(refused(header("ascii", vertex) + "1 2 3\n4 5\n6 7 8\n"),
            "p.ply:10: the line has 2 numbers, expected 3 as the header says");
  EXPECT_THAT(refused(header("ascii", vertex) + "1 2 3\n4,5 6 7\n"), HasSubstr("p.ply:10: column 1: found \"4,5\""));
}

}  // namespace
}  // namespace artcal
