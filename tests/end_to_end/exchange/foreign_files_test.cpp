// A recording that somebody sent reads no other file of this computer, and no message shows what is in one.
#include <gmock/gmock.h>

#include "tests/end_to_end/archive.h"

namespace artcal {
namespace {

using testing::Ended;
using ::testing::HasSubstr;
using ::testing::Not;

// As /etc/shadow has them.
const std::string secret = "root:$y$j9T$abcdefghijk:19000:0:99999:7:::\nnobody:*:19000:0:99999:7:::\n";

class ForeignFiles : public testing::ArchiveTest {
 protected:
  // A recording in a/b/sent, what it may not read two folders up.
  ForeignFiles() {
    write("secret.csv", secret);
    take("gao2013");
    std::filesystem::create_directories(file("a/b"));
    std::filesystem::rename(file("gao2013"), file("a/b/sent"));
  }
  const std::string recording = "a/b/sent/recording.toml";

  void expect_kept_secret(const std::vector<std::string>& command, const std::string& what) const {
    const Ended ended = run(command);
    EXPECT_EQ(ended.exit_code, 3) << what << ended.err;
    EXPECT_THAT(ended.err + ended.out, Not(HasSubstr("root"))) << what;
    EXPECT_THAT(ended.err + ended.out, Not(HasSubstr("nobody"))) << what;
  }
};

TEST_F(ForeignFiles, AreNotReadUnlessTheUserSaysSo) {
  const std::string sound = text_of(recording);
  for (const char* name : {"readings.csv", "table1.toml", "coordinates.toml"}) {
    std::string text = sound;
    replace_in(text, std::string("\"") + name + "\"", "\"../../../secret.csv\"");
    write(recording, text);
    const Ended ended = run({"identify", recording, "-q"});
    EXPECT_EQ(ended.exit_code, 3);
    EXPECT_THAT(ended.err, HasSubstr("add --allow-outside")) << name;
    expect_kept_secret({"identify", recording, "-q", "--allow-outside"}, name);
    if (std::string(name) != "coordinates.toml") {  // which points does not need
      expect_kept_secret({"points", recording, "-q", "--allow-outside"}, name);
    }
    expect_kept_secret({"batch", "a/b", "--store", "s.sqlite", "--report", "i.html"}, name);
    EXPECT_THAT(text_of("i.html") + dump("s.sqlite"), Not(HasSubstr("19000")));
  }
}

TEST_F(ForeignFiles, AreNotReachedByLinksOrCertificates) {
  std::filesystem::remove(file("a/b/sent/readings.csv"));
  std::filesystem::create_symlink(file("secret.csv"), file("a/b/sent/readings.csv"));
  EXPECT_THAT(run({"identify", recording, "-q"}).err, HasSubstr("--allow-outside"));
  write("a/b/sent/coordinates.toml", "schema = \"artcal-artefact/1\"\ndcc = \"../../../secret.csv\"\n");
  std::filesystem::remove(file("a/b/sent/readings.csv"));
  std::filesystem::copy_file(std::string(ARTCAL_SOURCE_DIR) + "/examples/gao2013/readings.csv",
                             file("a/b/sent/readings.csv"));
  EXPECT_THAT(run({"identify", recording, "-q"}).err, HasSubstr("--allow-outside"));
  expect_kept_secret({"identify", recording, "-q", "--allow-outside"}, "certificate");
}

TEST_F(ForeignFiles, BesideTheRecordingOrBelowTheFolderOfABatchAreRead) {
  std::filesystem::rename(file("a/b/sent/table1.toml"), file("a/b/arm.toml"));
  change(recording, "\"table1.toml\"", "\"../arm.toml\"");
  EXPECT_EQ(run({"identify", recording, "-q", "--no-leave-out"}).exit_code, 0);
  EXPECT_EQ(run({"batch", "a", "--store", "s.sqlite", "-q"}).exit_code, 0);
  const Ended refused = run({"batch", "a/b/sent", "--store", "t.sqlite", "-q"});
  EXPECT_EQ(refused.exit_code, 3) << "found in a folder that does not hold the arm";
  EXPECT_THAT(refused.err, HasSubstr("--allow-outside"));
  EXPECT_EQ(run({"batch", "a/b/sent", "--store", "t.sqlite", "-q", "--allow-outside"}).exit_code, 0);
}

// Whatever takes a table, points, an arm, an artefact or a result: of a file that is none of these nothing is shown.
TEST_F(ForeignFiles, AreNotQuoted) {
  for (const std::string& text : std::vector<std::string>{secret, "user root secretword 12\n" + secret,
                                                          "root,nobody,root\n1,2\n", "root;nobody\n" + secret}) {
    write("f", text);
    write("f.toml", text);
    expect_kept_secret({"fit", "f", "--shape", "sphere", "--unit", "mm"}, "fit");
    expect_kept_secret({"identify", "f.toml"}, "identify");
    expect_kept_secret({"points", recording, "--arm", "f.toml"}, "points");
    expect_kept_secret({"verify", "a/b/sent/recording.toml", "--standard", "sphere-plate", "--specification", "f.toml"},
                       "verify");
    expect_kept_secret({"simulate", "f.toml", "-o", "out"}, "simulate");
    expect_kept_secret({"report", "f", "-o", "out.html"}, "report");
    expect_kept_secret({"segment", "f", "--artefact", "f.toml", "--unit", "mm"}, "segment");
    write("a/b/sent/readings.csv", text);
    expect_kept_secret({"identify", recording}, "readings");
  }
}

}  // namespace
}  // namespace artcal
