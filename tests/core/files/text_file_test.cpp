#include "core/files/text_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files/hash.h"
#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class TextFileTest : public ::testing::Test {
 protected:
  Expected<TextFile> read(std::string_view bytes) { return read_text_file(folder_.write("f.txt", bytes)); }
  std::string refusal(std::string_view bytes) {
    const auto file = read(bytes);
    return file ? "accepted" : file.error().text();
  }
  testing::TemporaryFolder folder_;
};

TEST_F(TextFileTest, KeepsTheTextAndHashesTheBytes) {
  const auto file = read("a,b\r\n1,2\r\n");
  ASSERT_TRUE(file);
  EXPECT_EQ(file->text, "a,b\r\n1,2\r\n");
  EXPECT_EQ(file->sha256, sha256("a,b\r\n1,2\r\n"));
}

TEST_F(TextFileTest, DropsTheByteOrderMarkButHashesIt) {
  const auto file = read("\xEF\xBB\xBFname");
  ASSERT_TRUE(file);
  EXPECT_EQ(file->text, "name");
  EXPECT_EQ(file->sha256, sha256("\xEF\xBB\xBFname"));
}

TEST_F(TextFileTest, RefusesWhatIsNoFile) {
  const auto missing = read_text_file(folder_.path() / "missing.csv");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::BadInput);
  EXPECT_THAT(missing.error().text(), HasSubstr("missing.csv: there is no such file"));
  const auto folder = read_text_file(folder_.path());
  ASSERT_FALSE(folder);
  EXPECT_THAT(folder.error().text(), HasSubstr("folder"));
  EXPECT_FALSE(read_text_file("/dev/null"));
}

TEST_F(TextFileTest, SaysWhatIsTrueOfAPathThatLeadsNowhere) {
  const auto refused = [](const std::filesystem::path& path) { return read_text_file(path).error().message; };
  EXPECT_THAT(refused(folder_.path() / "missing.csv"), HasSubstr("its folder is there, but has none of that name"));
  EXPECT_THAT(refused(folder_.path() / "none" / "missing.csv"), HasSubstr("its folder is not there either"));
  EXPECT_THAT(refused("no such file.toml"), HasSubstr("the current folder has none of that name"));
  EXPECT_THAT(refused("C:\\data\\recording.toml"), HasSubstr("a path of Windows"));
  EXPECT_THAT(refused(folder_.path()), HasSubstr("this is a folder, expected a text file; name the file"));
  EXPECT_THAT(refused("/dev/null"), HasSubstr("a device"));
}

TEST_F(TextFileTest, RefusesEmptyFiles) {
  EXPECT_THAT(refusal(""), HasSubstr("f.txt: the file is empty"));
  EXPECT_THAT(refusal("\xEF\xBB\xBF"), HasSubstr("empty"));
}

TEST_F(TextFileTest, RefusesBinaryContent) {
  EXPECT_THAT(refusal(std::string_view("a\0b", 3)), HasSubstr("zero bytes"));
  EXPECT_THAT(refusal(std::string_view("\xFF\xFEq\0", 4)), HasSubstr("UTF-16"));
}

TEST_F(TextFileTest, RefusesOtherEncodingsAndNamesTheLine) {
  EXPECT_THAT(refusal("fine\n15 \xB5m\n"), HasSubstr("f.txt:2: the byte 0xb5 is not UTF-8"));
  // Overlong, cut short, surrogate, beyond the last code point, a stray continuation.
  for (const char* bad : {"\xC0\x80", "\xE0\x80\x80", "\xE2\x82", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xF5", "\x80"}) {
    EXPECT_THAT(refusal(bad), HasSubstr("not UTF-8"));
  }
}

TEST_F(TextFileTest, TakesEveryUtf8Length) { EXPECT_TRUE(read("a µ € 😀 \xED\x9F\xBF \xF4\x8F\xBF\xBF")); }

TEST_F(TextFileTest, RefusesMoreThanTheLimit) {
  const auto path = folder_.write("long.txt", std::string(101, 'x'));
  EXPECT_TRUE(read_text_file(path, 101));
  const auto file = read_text_file(path, 100);
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().message, HasSubstr("101 bytes"));
}

}  // namespace
}  // namespace artcal
