// Text of millions of points is read side by side: the same numbers as line by line with strtod, errors at the same
// lines, on any number of threads.
#include "acquisition/point_cloud/text_rows.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "acquisition/point_cloud/read_cloud.h"
#include "core/random.h"
#include "tests/support/cloud_file.h"

namespace artcal {
namespace {

using Lines = std::vector<std::string>;

// Four columns, as programs write them: lengths differ, some lines are blank or comments, some end with a return.
Lines many_lines(std::size_t count) {
  RandomStream random(5, "text rows");
  Lines lines;
  for (std::size_t i = 0; i < count; ++i) {
    lines.push_back(fmt::format("{:.{}f}  {:.6e}\t{} {}", 400.0 * random.normal(), i % 9, random.normal(),
                                i % 1000 == 7 ? "nan" : fmt::format("{:+.4f}", random.normal()), i));
    if (i % 977 == 0) lines.push_back(i % 2 == 0 ? "" : "# a comment 1 2 3");
    if (i % 55 == 0) lines.back() += "\r";
  }
  return lines;
}

std::string text_of(const Lines& lines) {
  std::string text;
  for (const auto& line : lines) text += line + "\n";
  return text;
}

bool is_row(const std::string& line) { return line.find_first_not_of(" \r") != std::string::npos && line[0] != '#'; }

// Of all columns.
std::vector<double> by_strtod(const Lines& lines) {
  std::vector<double> numbers;
  for (const auto& line : lines) {
    const char* at = line.c_str();
    for (int i = 0; i < 4 && is_row(line); ++i) {
      char* end = nullptr;
      numbers.push_back(std::strtod(at, &end));
      at = end;
    }
  }
  return numbers;
}

struct ReadText {
  std::vector<double> numbers;
  std::size_t at_once = 0;  // of these
  std::string error;
};

ReadText read_text(const std::string& text, const std::vector<std::size_t>& columns, int threads) {
  TextRows rows(text, "file", 1, TextRows::Separator::Blanks);
  ReadText read;
  std::vector<double> row(columns.size());
  for (;;) {
    const auto many = rows.take_many(columns, 4, text.size(), threads);
    read.numbers.insert(read.numbers.end(), many.begin(), many.end());
    read.at_once += many.size();
    if (!many.empty()) continue;
    if (!rows.next()) return read;
    if (auto taken = rows.numbers(columns, row.data()); !taken) {
      read.error = taken.error().text();
      return read;
    }
    read.numbers.insert(read.numbers.end(), row.begin(), row.end());
  }
}

// `all` are the numbers of `rows` rows or more.
void expect_same(const std::vector<double>& found, const std::vector<double>& all,
                 const std::vector<std::size_t>& columns, std::size_t rows) {
  ASSERT_EQ(found.size(), rows * columns.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double expected = all[i / columns.size() * 4 + columns[i % columns.size()]];
    ASSERT_TRUE(found[i] == expected || (std::isnan(found[i]) && std::isnan(expected))) << i;
  }
}

class ManyAtOnce : public ::testing::Test {
 protected:
  static constexpr std::size_t count = 500'000;  // more than are read at once
  const Lines lines_ = many_lines(count);
  const std::vector<double> all_ = by_strtod(lines_);
};

TEST_F(ManyAtOnce, AreTheNumbersOfEachLine) {
  const std::string text = text_of(lines_);
  for (const std::vector<std::size_t>& columns : {std::vector<std::size_t>{0, 1, 2}, {3, 0}}) {
    for (const int threads : {1, 2, 8}) {
      const ReadText read = read_text(text, columns, threads);
      EXPECT_EQ(read.error, "");
      expect_same(read.numbers, all_, columns, count);
      EXPECT_GT(read.at_once, count * columns.size() / 10 * 9) << "read side by side";
    }
  }
}

// What is wrong, and in which line, wherever the blocks begin and end.
TEST_F(ManyAtOnce, SayWhichLineIsWrong) {
  for (const double place : {0.02, 0.31, 0.7, 0.98}) {
    Lines wrong = lines_;
    const auto at = static_cast<std::ptrdiff_t>(place * static_cast<double>(lines_.size()));
    wrong[static_cast<std::size_t>(at)] = "1 2,5 3 4";
    const auto before = static_cast<std::size_t>(std::count_if(lines_.begin(), lines_.begin() + at, is_row));
    for (const int threads : {1, 2, 5}) {
      const ReadText read = read_text(text_of(wrong), {0, 1, 2}, threads);
      EXPECT_EQ(read.error,
                fmt::format("file:{}: column 2: found \"2,5\", expected a number with a decimal point", at + 1));
      expect_same(read.numbers, all_, {0, 1, 2}, before);
    }
  }
}

class ManyLines : public testing::CloudFile {};

// Each format of text: points in their order, the count of lines, what is wrong and where.
TEST_F(ManyLines, OfEveryFormat) {
  constexpr std::size_t count = 120'000;
  Lines lines;
  RandomStream random(7, "text rows");
  Eigen::Matrix3Xd points(3, count);
  for (std::size_t i = 0; i < count; ++i) {
    auto point = points.col(static_cast<Eigen::Index>(i));
    for (double& x : point) x = random.normal();
    lines.push_back(fmt::format("{} {} {}", point.x(), point.y(), point.z()));
  }
  const std::string pcd = fmt::format(
      "VERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {0}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 "
      "0\nPOINTS {0}\nDATA ascii\n",
      count);
  const std::string ply = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\nend_header\n",
      count);
  const std::string pts = fmt::format("{}\n", count);
  const std::string two_scans = fmt::format("{}\n", count / 3);
  for (const auto& [name, header] :
       {std::pair<std::string, std::string>{"p.pcd", pcd}, {"p.ply", ply}, {"p.xyz", ""}, {"p.pts", pts}}) {
    const auto read = read_cloud(folder_.write(name, header + text_of(lines)), {}, {});
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->cloud.points, points) << name;
    const auto header_lines = static_cast<std::size_t>(std::count(header.begin(), header.end(), '\n'));
    for (const std::size_t at : {std::size_t{3}, count / 2, count - 1}) {
      Lines wrong = lines;
      wrong[at] = "1 2 x3";
      EXPECT_THAT(refusal(name, header + text_of(wrong)),
                  ::testing::StartsWith(fmt::format("{}:{}: column 3: found \"x3\"", name, header_lines + at + 1)));
      for (const auto& [line, width] : {std::pair{"1 2", 2}, {"1 2 3 4", 4}}) {
        wrong[at] = line;
        EXPECT_THAT(refusal(name, header + text_of(wrong)),
                    ::testing::StartsWith(fmt::format("{}:{}: the line has {}", name, header_lines + at + 1, width)));
      }
    }
    Lines more = lines;
    more.push_back("1 2 3");
    EXPECT_EQ(refusal(name, header + text_of(more)) == "accepted", name == "p.xyz") << "more points than promised";
  }
  Lines scans = lines;
  scans.insert(scans.begin() + count / 3, fmt::format("{}", count - count / 3));
  const auto read = read_cloud(folder_.write("p.pts", two_scans + text_of(scans)), {}, {});
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->cloud.points, points);
}

}  // namespace
}  // namespace artcal
