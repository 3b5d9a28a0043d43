// PTX, Wavefront OBJ and STL: small files written for these tests from the public descriptions of the formats (PTX: the
// Cyclone export as Bourke describes it, a point is the row x y z 1 times the matrix). What they hold is stated by
// hand.
#include <cstring>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "acquisition/point_cloud/read_cloud.h"
#include "tests/support/cloud_file.h"

namespace artcal {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ScanFormat : public testing::CloudFile {
 protected:
  ReadCloud take(std::string_view name, std::string_view bytes, const CloudUnits& units = {}) {
    auto cloud = read_cloud(folder_.write(name, bytes), units);
    EXPECT_TRUE(cloud) << (cloud ? "" : cloud.error().text());
    return cloud ? std::move(*cloud) : ReadCloud{};
  }
};

// ---- PTX -----------------------------------------------------------------------------------------------------

const std::string pose = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
// A quarter turn about z: (x, y, z) becomes (-y, x, z), then (100, 0, -5) is added.
const std::string quarter = "0 1 0 0\n-1 0 0 0\n0 0 1 0\n100 0 -5 1\n";
const std::string still = "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";

class Ptx : public ScanFormat {};

TEST_F(Ptx, PointsAreMovedByTheMatrixOfTheirScan) {
  const ReadCloud read = take("p.ptx", "2\n2\n" + pose + quarter + "1 2 3 0.5\n0 0 0 0.5\n4 5 6 0.1\n7 8 10 0.2\n");
  EXPECT_EQ(read.cloud.points, (Eigen::Matrix3Xd(3, 3) << 98, 95, 92, 1, 4, 7, -2, 1, 5).finished());
  EXPECT_THAT(read.cloud.rows, ElementsAre(0, 2, 3));
  EXPECT_EQ(read.cloud.dropped, 1u);
  EXPECT_THAT(read.cloud.warnings, ElementsAre(HasSubstr("1 of 4 points are 0 0 0 in the scanner's own frame")));
  EXPECT_EQ(read.columns, "one scan, moved by its matrix");
}

TEST_F(Ptx, HoldsSeveralScansAndIsKnownByItsContent) {
  const ReadCloud read = take("p.txt",
                              "\xEF\xBB\xBF"
                              "1\r\n2\r\n" +
                                  pose + quarter + "1 2 3 0.5 10 20 30\r\n4 5 6 0.5 1 2 3\r\n\n1\n2\n" + pose + still +
                                  "0 0 0\n7 8 9 0\n");
  EXPECT_EQ(read.cloud.points, (Eigen::Matrix3Xd(3, 3) << 98, 95, 7, 1, 4, 8, -2, 1, 9).finished());
  EXPECT_EQ(read.columns, "2 scans, each moved by its matrix");
}

TEST_F(Ptx, TheTranslationHasTheUnitOfThePoints) {
  const ReadCloud read = take("p.ptx", "1\n2\n" + pose + quarter + "1 2 3 0\n4 5 6 0\n", {1000.0, {}});
  EXPECT_EQ(read.cloud.points.col(0), Eigen::Vector3d(98000, 1000, -2000));
}

TEST_F(Ptx, AMatrixOfFewDigitsIsWarnedOf) {
  const std::string thirty = "0.866 0.5 0 0\n-0.5 0.866 0 0\n0 0 1 0\n0 0 0 1\n";
  EXPECT_THAT(take("p.ptx", "1\n2\n" + pose + thirty + "1 2 3 0\n10000 0 0 0\n").cloud.warnings,
              Contains(HasSubstr("distorts the points by up to 0.44 mm")));  // (0.866² + 0.5² - 1) · 10 m
  EXPECT_THAT(take("p.ptx", "1\n2\n" + pose + quarter + "1 2 3 0\n10000 0 0 0\n").cloud.warnings, IsEmpty());
}

TEST_F(Ptx, IsRefusedWhereItIsNotWhatItPromises) {
  const std::string points = "1 2 3 0\n4 5 6 0\n";
  EXPECT_EQ(refusal("p.ptx", "2\n3\n" + pose + quarter + points + points),
            "p.ptx:1: the header promises 6 points, the file ends after 4; is it truncated?");
  EXPECT_EQ(refusal("p.ptx", "1\n1\n" + pose + quarter + points),
            "p.ptx:12: the line is no positive whole number alone, expected the number of columns of a scan (PTX)");
  EXPECT_THAT(refusal("p.ptx", "1\n2\n" + pose + quarter + "1 2 3 0\n4 5 0\n"), HasSubstr("p.ptx:12: the line has 3"));
  EXPECT_THAT(refusal("p.ptx", "1\n2\n" + pose + quarter + "1 2 3 0\n1\n"),
              HasSubstr("p.ptx:12: the line has 1 column, expected at least 2; 1 of the 2 points"));
  EXPECT_THAT(refusal("p.ptx", "1\n2\n" + pose + quarter + "1 2 3 0\n4 5 x 0\n"),
              HasSubstr("p.ptx:12: column 3: found \"x\""));
  EXPECT_THAT(refusal("p.ptx", "1\n2\n0 0 0\n1 0 0\n0 1 0\n" + quarter + points),
              HasSubstr("p.ptx:6: the line has 4 columns, expected 3 numbers: the scanner's z axis of a scan (PTX)"));
  EXPECT_THAT(refusal("p.ptx", points), HasSubstr("p.ptx:1: the line is no positive whole number"));
  EXPECT_THAT(refusal("p.ptx", "1\n2\n" + pose + "0 1 0 0\n"), HasSubstr("ends in the header of a scan"));
  EXPECT_THAT(refusal("p.ptx", "1\n1\n" + pose + still + "0 0 0 0.5\n"), HasSubstr("at none of the 1 points"));
}

TEST_F(Ptx, NoCountIsBelieved) {
  for (const char* size : {"1000000\n1000000\n", "18446744073709551615\n18446744073709551615\n", "4294967296\n1\n"}) {
    EXPECT_THAT(refusal("p.ptx", size + pose + quarter + "1 2 3 0\n"), HasSubstr("more than the 68 bytes that follow"));
  }
}

TEST_F(Ptx, AMatrixThatIsNoRigidMotionIsRefused) {
  const auto with = [&](const std::string& matrix) {
    return refusal("p.ptx", "1\n2\n" + pose + matrix + "1 2 3 0\n4 5 6 0\n");
  };
  EXPECT_THAT(with("0 1 0 100\n-1 0 0 0\n0 0 1 -5\n0 0 0 1\n"), HasSubstr("p.ptx:10: the last column"));  // transposed
  EXPECT_THAT(with("0.001 0 0 0\n0 0.001 0 0\n0 0 0.001 0\n0 0 0 1\n"), HasSubstr("expected a rigid motion"));
  EXPECT_THAT(with("1 0 0 0\n0 1 0 0\n0 0 -1 0\n0 0 0 1\n"), HasSubstr("expected a rigid motion"));
  EXPECT_THAT(with("nan 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n"), HasSubstr("expected a rigid motion"));
}

// ---- OBJ -----------------------------------------------------------------------------------------------------

class Obj : public ScanFormat {};

TEST_F(Obj, VerticesAreRead) {
  const Eigen::Matrix3Xd expected = (Eigen::Matrix3Xd(3, 3) << 0, 4, 7, 2, 5, 8, 3, 6, 10.5).finished();
  for (const std::string start :
       {"", "\xEF\xBB\xBF", "# made by hand\nmtllib gone.mtl\no part\nvn 0 0 1\nvn 1 0 \\\n0\n"}) {
    const ReadCloud read =
        take("p.txt", start + "v 0 2 3\nv 4 5 6 0.5 0.5 0.5\nvt 0 0\nv 7 8 10.5 1.0\nf 1//1 2//1 3//1\n");
    EXPECT_EQ(read.cloud.points, expected);
    EXPECT_THAT(read.cloud.warnings, IsEmpty());
    EXPECT_EQ(read.columns, "the vertices (v) of a Wavefront OBJ");
  }
  // The vertex at the origin is one.
  EXPECT_EQ(take("p.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n").cloud.points.cols(), 3);
}

TEST_F(Obj, IsRefusedWhereItIsNotUnderstood) {
  EXPECT_THAT(refusal("p.obj", "v 1 2 3\nv 4 5 6 2\n"), HasSubstr("p.obj:2: the vertex has the weight 2"));
  EXPECT_THAT(refusal("p.obj", "v 1 2\nv 4 5\n"), HasSubstr("p.obj:1: the vertex has 2 numbers"));
  EXPECT_THAT(refusal("p.obj", "v 1 2 3\nv 4 5 \\\n6\n"), HasSubstr("p.obj:2: the vertex goes on in the next line"));
  EXPECT_THAT(refusal("p.obj", "v 1 2 3\nv 4 5 six\n"), HasSubstr("p.obj:2: column 4: found \"six\""));
  EXPECT_THAT(refusal("p.obj", "v 1 2 3\ncstype bezier\n"), HasSubstr("p.obj:2: the file has free-form"));
  EXPECT_THAT(refusal("p.obj", "v 1 2 3\ncall other.obj\n"), HasSubstr("p.obj:2: the line begins with no keyword"));
  EXPECT_THAT(refusal("p.obj", "root:x:0\n"), ::testing::Not(HasSubstr("root")));
  EXPECT_THAT(refusal("p.obj", "f 1 2 3\n"), HasSubstr("no points"));
}

// ---- STL -----------------------------------------------------------------------------------------------------

/// The triangles of a box from the origin to (10, 20, 30), with the corners as the numbers 0 to 7: x, y, z by bit.
constexpr int box[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                            {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};

Eigen::Vector3f corner(int number) {
  return {number & 1 ? 10.0F : 0.0F, number & 2 ? 20.0F : 0.0F, number & 4 ? 30.0F : 0.0F};
}

std::string text_box() {
  std::string text = "solid box of 10 x 20 x 30\n";
  for (const auto& triangle : box) {
    text += "  facet normal nan 0 0\n    outer loop\n";
    for (const int number : triangle) {
      const Eigen::Vector3f at = corner(number);
      text += fmt::format("      vertex {:e} {:e} {:e}\n", at.x(), at.y(), at.z());
    }
    text += "    endloop\n  endfacet\n";
  }
  return text + "endsolid\n";
}

std::string binary_box(std::string header) {
  header.resize(80, ' ');
  header.append("\x0C\0\0\0", 4);
  for (const auto& triangle : box) {
    header.append(12, '\0');  // normal
    for (const int number : triangle) {
      const Eigen::Vector3f at = corner(number);
      header.append(reinterpret_cast<const char*>(at.data()), 12);
    }
    header.append("\1\2", 2);
  }
  return header;
}

class Stl : public ScanFormat {
 protected:
  void expect_box(std::string_view name, const std::string& bytes) {
    const ReadCloud read = take(name, bytes);
    // In the order in which the triangles name them.
    Eigen::Matrix3Xd expected(3, 8);
    int i = 0;
    for (const int number : {0, 2, 1, 3, 4, 5, 6, 7}) {
      expected.col(i++) = corner(number).cast<double>();
    }
    EXPECT_EQ(read.cloud.points, expected);
    EXPECT_THAT(read.cloud.warnings, IsEmpty());
    EXPECT_EQ(read.columns, "the 8 vertices of 12 triangles (STL)");
  }
};

TEST_F(Stl, VerticesAreReadOnce) {
  expect_box("box.stl", text_box());
  expect_box("box", text_box());
  expect_box("box.stl", binary_box("written by a test"));
  expect_box("box", binary_box("solid begins some binary ones, too"));
  std::string capitals = text_box();
  for (char& c : capitals) {
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  expect_box("box.STL", capitals);
}

TEST_F(Stl, IsRefusedWhereItIsNotWhatItPromises) {
  const std::string whole = binary_box("box");
  EXPECT_EQ(
      refusal("box.stl", whole.substr(0, whole.size() - 1)),
      "box.stl: as a binary STL the file promises 12 triangles, 84 + 50 x 12 bytes, but it has 683; is it truncated?");
  std::string many = whole;
  std::memset(many.data() + 80, 0xFF, 4);
  EXPECT_THAT(refusal("box.stl", many), HasSubstr("promises 4294967295 triangles"));
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string text = text_box();
    text.replace(text.find(from), from.size(), to);
    return refusal("box.stl", text);
  };
  EXPECT_THAT(changed("endsolid\n", ""), HasSubstr("ends within a solid"));
  EXPECT_THAT(changed("      vertex 0", "      # 0"), HasSubstr("box.stl:7: the facet has 2 vertices, expected 3"));
  EXPECT_THAT(changed("    outer loop\n", ""), HasSubstr("box.stl:3: the line is a vertex outside a loop"));
  EXPECT_THAT(changed("    endloop\n", ""), HasSubstr("box.stl:7: the line is not what comes next in an STL, expected "
                                                      "vertex or endloop"));
  EXPECT_THAT(changed("vertex 0.000000e+00", "vertex O"), HasSubstr("box.stl:4: column 2: found"));
  EXPECT_THAT(refusal("box.stl", "1 2 3\n4 5 6\n"), HasSubstr("begins neither as an STL"));
}

TEST_F(ScanFormat, StatedColumnsAreForTables) {
  for (const auto& [name, bytes] : std::vector<std::pair<std::string, std::string>>{
           {"p.ptx", "1\n1\n" + pose + still + "1 2 3\n"}, {"p.obj", "v 1 2 3\n"}, {"p.stl", text_box()}}) {
    const auto read = read_cloud(folder_.write(name, bytes), {}, {{1, 2, 3}});
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().text(), HasSubstr("columns are stated by number"));
  }
}

}  // namespace
}  // namespace artcal
