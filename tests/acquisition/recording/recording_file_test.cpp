#include "acquisition/recording/recording_file.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files/hash.h"
#include "core/random.h"
#include "core/units.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::replaced;
using ::testing::StartsWith;

class RecordingFile : public ::testing::Test {
 protected:
  Expected<Recording> read() { return read_recording(example.write(folder_)); }
  // The message without the folder.
  std::string refusal() {
    const auto recording = read();
    return recording ? "accepted" : recording.error().text().substr(folder_.path().string().size() + 1);
  }
  // The same with a line added to recording.toml.
  std::string refusal_of(std::string_view line) {
    const std::string before = example.recording;
    example.recording += line;
    std::string text = refusal();
    example.recording = before;
    return text;
  }
  testing::ExampleRecording example;
  testing::TemporaryFolder folder_;
};

TEST_F(RecordingFile, ReadsTheArmAndItsReadings) {
  const auto recording = read();
  ASSERT_TRUE(recording) << recording.error().text();
  EXPECT_EQ(recording->name, "recording");
  EXPECT_EQ(recording->arm.name, "two");
  EXPECT_EQ(recording->readings.size(), 5u);
  EXPECT_DOUBLE_EQ(recording->joints(1, 4), 100.0 * units::degree);
  EXPECT_FALSE(recording->noise.is_given());
  EXPECT_EQ(recording->identify.loss, "none");
  EXPECT_THAT(recording->warnings, IsEmpty());
}

TEST_F(RecordingFile, NamesEveryFileItRestsOn) {
  const auto recording = read();
  ASSERT_TRUE(recording);
  ASSERT_EQ(recording->inputs.size(), 3u);
  EXPECT_EQ(recording->inputs[0].sha256, sha256(example.recording));
  EXPECT_EQ(recording->inputs[1].sha256, sha256(example.arm));
  EXPECT_EQ(recording->inputs[2].sha256, sha256(example.readings));
}

TEST_F(RecordingFile, ReadsWhatIsOptional) {
  example.recording = "name = \"Monday\"\nartefacts = [\"bar.toml\"]\n" + example.recording +
                      "[noise]\nencoder = \"2 arcsec\"\nprobing = \"3 um\"\n"
                      "[identify]\nhold = [\"a2\"]\nfree = [\"d2\"]\nloss = \"huber\"\n";
  const auto recording = read();
  ASSERT_TRUE(recording) << recording.error().text();
  EXPECT_EQ(recording->name, "Monday");
  EXPECT_THAT(recording->artefact_paths, ElementsAre((folder_.path() / "bar.toml").string()));
  EXPECT_DOUBLE_EQ(*recording->noise.encoder, 2.0 * units::arcsecond);
  EXPECT_DOUBLE_EQ(*recording->noise.probing, 0.003);
  EXPECT_FALSE(recording->noise.reading);
  EXPECT_THAT(recording->identify.hold, ElementsAre("a2"));
  EXPECT_THAT(recording->identify.free, ElementsAre("d2"));
  EXPECT_EQ(recording->identify.loss, "huber");
}

TEST_F(RecordingFile, SaysWhatIsToBeDoneWithIt) {
  const std::string bare = example.recording;
  const auto asks = [&](const std::string& more) {
    example.recording = bare + more;
    const auto recording = read();
    EXPECT_TRUE(recording) << more;
    return recording ? std::pair(recording->identify.asked, recording->verify.standard)
                     : std::pair(false, std::string());
  };
  EXPECT_EQ(asks(""), std::pair(true, std::string()));
  EXPECT_EQ(asks("[identify]\n"), std::pair(true, std::string()));
  EXPECT_EQ(asks("[verify]\nstandard = \"b89.4.22\"\n"), std::pair(false, std::string("b89.4.22")));
  EXPECT_EQ(asks("[identify]\n[verify]\nstandard = \"sphere-plate\"\n"), std::pair(true, std::string("sphere-plate")));
  example.recording = bare;
  EXPECT_THAT(refusal_of("[verify]\n"), HasSubstr("standard"));
  EXPECT_THAT(refusal_of("[verify]\nstandard = \"iso10360-2\"\n"), HasSubstr("standard is \"iso10360-2\", expected"));
  EXPECT_THAT(refusal_of("[verify]\nstandard = \"b89.4.22\"\nlimit = 1\n"), HasSubstr("\"limit\" is not a key"));
}

TEST_F(RecordingFile, TheDateIsADayOrNotStated) {
  EXPECT_EQ(read()->date, "");
  example.recording = "date = 2026-03-10\n" + example.recording;
  EXPECT_EQ(read()->date, "2026-03-10");
  example.recording = testing::replaced(example.recording, "2026-03-10", "\"2026-02-31\"");
  EXPECT_THAT(refusal(), HasSubstr("`date` is \"2026-02-31\", expected a day of the calendar"));
}

// Its rows would count twice; also by another way to the same file.
TEST_F(RecordingFile, ATableThatIsNamedTwiceIsRefused) {
  const std::string folder = folder_.path().filename().string();
  const std::string before = example.recording;
  for (const std::string& again :
       {std::string("readings.csv"), std::string("./readings.csv"), "../" + folder + "/readings.csv"}) {
    example.recording = replaced(before, "[\"readings.csv\"]", "[\"readings.csv\", \"" + again + "\"]");
    EXPECT_THAT(refusal(), HasSubstr("twice; its readings would count twice")) << again;
  }
}

TEST_F(RecordingFile, NoiseIsAQuantityWithItsUnit) {
  example.recording += "[noise]\nreading = \"15 um\"\n";
  EXPECT_DOUBLE_EQ(*read()->noise.reading, 0.015);
}

TEST_F(RecordingFile, OddNoiseIsRefused) {
  EXPECT_EQ(refusal_of("[noise]\nreading = \"15\"\n"),
            "recording.toml:6:11: the noise `reading` is \"15\", expected a number above zero with its unit, such as "
            "\"15 um\"");
  EXPECT_THAT(refusal_of("[noise]\nreading = 0.015\n"), HasSubstr("`reading` in [noise] is a number, expected text"));
  EXPECT_THAT(refusal_of("[noise]\nreading = \"0 um\"\n"), HasSubstr("above zero"));
  EXPECT_THAT(refusal_of("[noise]\nreading = \"-1 um\"\n"), HasSubstr("above zero"));
  EXPECT_THAT(refusal_of("[noise]\nreading = \"2 arcsec\"\n"), HasSubstr("such as \"15 um\""));
  EXPECT_THAT(refusal_of("[noise]\nencoder = \"3 um\"\nprobing = \"3 um\"\n"), HasSubstr("such as \"2 arcsec\""));
  EXPECT_THAT(refusal_of("[noise]\nencoder = \"2 arcsec\"\n"), HasSubstr("belong together"));
  EXPECT_THAT(refusal_of("[noise]\nreading = \"1 um\"\nencoder = \"2 arcsec\"\nprobing = \"1 um\"\n"),
              HasSubstr("not both"));
}

TEST_F(RecordingFile, UnitsMustBeStatedAndKnown) {
  const std::string units = "units = { joint = \"deg\", length = \"mm\" }\n";
  const auto with = [&](std::string_view other) {
    const std::string before = example.recording;
    example.recording = replaced(example.recording, units, other);
    std::string text = refusal();
    example.recording = before;
    return text;
  };
  EXPECT_THAT(with(""), HasSubstr("the unit `joint` is not stated; write joint = \"…\" under [units]"));
  EXPECT_THAT(with("units = { joint = \"deg\" }\n"), HasSubstr("the unit `length` is not stated"));
  EXPECT_THAT(with("units = { joint = \"grad\", length = \"mm\" }\n"), HasSubstr("\"grad\" is not a unit known"));
  EXPECT_THAT(with("units = { joint = \"deg\", length = \"cm\" }\n"), HasSubstr("\"cm\" is not a unit known"));
  EXPECT_THAT(with("units = { joint = \"deg\", length = \"mm\", temperature = \"K\" }\n"), HasSubstr("expected degC"));
  EXPECT_THAT(with("units = { joint = \"deg\", length = \"mm\", force = \"N\" }\n"),
              HasSubstr("\"force\" is not a key"));
}

TEST_F(RecordingFile, UnknownKeysAreRefused) {
  EXPECT_THAT(refusal_of("readngs = []\n"), StartsWith("recording.toml:5:1: \"readngs\" is not a key"));
  EXPECT_THAT(refusal_of("[identify]\nfre = [\"d2\"]\n"), HasSubstr("\"fre\" is not a key"));
  EXPECT_THAT(refusal_of("[identify]\nloss = \"tukey\"\n"), HasSubstr("loss is \"tukey\", expected"));
}

TEST_F(RecordingFile, FilesItNamesMustBeThere) {
  example.recording = replaced(example.recording, "readings.csv", "gone.csv");
  EXPECT_THAT(refusal(), StartsWith("gone.csv: there is no such file"));
  example.recording = replaced(example.recording, "[\"gone.csv\"]", "[]");
  EXPECT_THAT(refusal(), HasSubstr("the recording names no readings"));
  example.recording = replaced(example.recording, "[]", "\"readings.csv\"");
  EXPECT_THAT(refusal(), HasSubstr("an array of texts"));
  example = {};
  example.recording = replaced(example.recording, "arm.toml", "leg.toml");
  EXPECT_THAT(refusal(), StartsWith("leg.toml: there is no such file"));
  example.recording = replaced(example.recording, "arm = \"leg.toml\"\n", "");
  EXPECT_THAT(refusal(), HasSubstr("`arm` is missing"));
}

TEST_F(RecordingFile, MistakesInTheReadingsComeThrough) {
  example.readings = replaced(example.readings, "p2,A,-50,60", "p2,A,-50,sixty");
  EXPECT_EQ(refusal(), "readings.csv:4:10: column q2: found \"sixty\", expected an angle in deg");
}

TEST_F(RecordingFile, WindowsLineEndsAndTheByteOrderMarkGiveTheSameRecording) {
  const auto plain = read();
  for (std::string* text : {&example.arm, &example.recording, &example.readings}) {
    std::string windows = "\xEF\xBB\xBF";
    for (const char c : *text) {
      windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    }
    *text = windows;
  }
  const auto windows = read();
  ASSERT_TRUE(windows) << windows.error().text();
  EXPECT_EQ(windows->joints, plain->joints);
  EXPECT_EQ(windows->arm.joints[1].a, plain->arm.joints[1].a);
}

TEST_F(RecordingFile, WarnsOfTheWrongUnit) {
  example.recording = replaced(example.recording, "\"deg\"", "\"rad\"");
  const auto recording = read();
  ASSERT_TRUE(recording);
  EXPECT_THAT(recording->warnings, ElementsAre(HasSubstr("look like degrees")));
}

// Random damage to any of the three files: either it is still a recording, or one readable line says what is
// wrong with which file. (Run under the sanitizers, this is a small fuzzer.)
TEST_F(RecordingFile, DamagedFilesAreReadOrRefusedInOneLine) {
  const std::string pieces[] = {"\"",
                                "'",
                                ",",
                                "\n",
                                "\r",
                                "[",
                                "]",
                                "{",
                                "}",
                                "=",
                                ".",
                                "#",
                                "-",
                                "nan",
                                "1e999",
                                "\"\"\"",
                                "µ",
                                "\xff",
                                std::string(1, '\0'),
                                "\x1b",
                                "[[probe]]",
                                "q1",
                                "999999999999999999999"};
  int read_count = 0;
  constexpr int damage_count = 500;
  for (int i = 0; i < damage_count; ++i) {
    RandomStream random(1, "damage", static_cast<std::uint64_t>(i));
    example = {};
    std::string* const files[] = {&example.arm, &example.readings, &example.recording};
    std::string& text = *files[random.bits() % 3];
    for (std::uint64_t n = 1 + random.bits() % 3; n > 0; --n) {
      const std::size_t at = random.bits() % (text.size() + 1);
      const std::size_t length = random.bits() % 8;
      switch (random.bits() % 4) {
        case 0: text.erase(at, length); break;
        case 1: text.insert(at, pieces[random.bits() % std::size(pieces)]); break;
        case 2: text.insert(at, text.substr(random.bits() % (text.size() + 1), length * 4)); break;
        default: text.replace(at, at < text.size() ? 1 : 0, 1, static_cast<char>(random.bits() % 256)); break;
      }
    }
    const auto recording = read();
    read_count += recording ? 1 : 0;
    if (recording) {
      EXPECT_EQ(recording->joints.cols(), static_cast<Eigen::Index>(recording->readings.size()));
      EXPECT_TRUE(recording->joints.allFinite());
    } else {
      const std::string message = recording.error().text();
      EXPECT_LT(message.size(), 600u) << message;
      EXPECT_THAT(message, HasSubstr(folder_.path().string()));
      EXPECT_EQ(
          std::count_if(message.begin(), message.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }), 0)
          << message;
    }
  }
  EXPECT_GT(read_count, damage_count / 100);
  EXPECT_LT(read_count, damage_count / 2);
}

TEST_F(RecordingFile, OtherKindsOfFileAreRefused) {
  example.recording = example.arm;
  EXPECT_EQ(refusal(), "recording.toml:1:10: schema is \"artcal-arm/1\", expected \"artcal-recording/1\"");
  example.recording = "%PDF-1.7\n";
  EXPECT_THAT(refusal(), HasSubstr("not valid TOML"));
  EXPECT_FALSE(read_recording(folder_.path() / "none.toml"));
  EXPECT_FALSE(read_recording(folder_.path()));
}

}  // namespace
}  // namespace artcal
