#include "acquisition/point_cloud/pcd/lzf.h"

#include <gtest/gtest.h>

namespace artcal {
namespace {

// Packed by hand after LibLZF's description of its format.
TEST(Lzf, LiteralsAndRepetitions) {
  EXPECT_EQ(lzf_decompress(std::string_view("\x02"
                                            "abc",
                                            4),
                           3),
            "abc");
  EXPECT_EQ(lzf_decompress(std::string_view("\x02"
                                            "abc"
                                            "\x20\x02",
                                            6),
                           6),
            "abcabc");  // three, three back
  EXPECT_EQ(lzf_decompress(std::string_view("\x00"
                                            "a"
                                            "\xc0\x00",
                                            4),
                           9),
            "aaaaaaaaa");  // eight, one back
  EXPECT_EQ(lzf_decompress(std::string_view("\x01"
                                            "ab"
                                            "\xe0\x00\x01",
                                            6),
                           11),
            "abababababa");  // nine, two back
  EXPECT_EQ(lzf_decompress(std::string_view("\x00"
                                            "a"
                                            "\xe0\xff\x00",
                                            5),
                           265),
            std::string(265, 'a'));
}

TEST(Lzf, LongDistances) {
  std::string packed, whole;
  for (int i = 0; i < 300; ++i) {
    const std::string run(32, static_cast<char>(i));
    packed += '\x1f' + run;
    whole += run;
  }
  packed += std::string("\x7f\xff", 2);  // five from 8192 back
  whole += whole.substr(whole.size() - 8192, 5);
  EXPECT_EQ(lzf_decompress(packed, whole.size()), whole);
}

TEST(Lzf, NothingElse) {
  EXPECT_FALSE(lzf_decompress(std::string_view("\x02"
                                               "ab",
                                               3),
                              3));  // literals end early
  EXPECT_FALSE(lzf_decompress(std::string_view("\x02"
                                               "abc"
                                               "\x20",
                                               5),
                              6));  // no distance
  EXPECT_FALSE(lzf_decompress(std::string_view("\x02"
                                               "abc"
                                               "\xe0\x01",
                                               6),
                              13));  // no distance after a length
  EXPECT_FALSE(lzf_decompress(std::string_view("\x02"
                                               "abc"
                                               "\x20\x03",
                                               6),
                              6));  // before the beginning
  EXPECT_FALSE(lzf_decompress(std::string_view("\x02"
                                               "abc"
                                               "\x20\x02",
                                               6),
                              5));  // too long
  EXPECT_FALSE(lzf_decompress(std::string_view("\x02"
                                               "abc"
                                               "\x20\x02",
                                               6),
                              7));  // too short
  EXPECT_FALSE(lzf_decompress("ab", std::size_t{2'000'000'000}));
  EXPECT_EQ(lzf_decompress("", 0), "");
}

}  // namespace
}  // namespace artcal
