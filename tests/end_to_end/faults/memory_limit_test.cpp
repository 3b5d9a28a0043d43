// Compressed points can stand for a thousand times their file: every command that reads a scan limits them.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/end_to_end/archive.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;

class MemoryLimit : public testing::ArchiveTest {};

std::string four_bytes(std::size_t number) {
  std::string bytes;
  for (int shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>(number >> shift & 0xff);
  }
  return bytes;
}

// 1,000 points (0, 0, 0) of doubles as LZF: two zeros, then copies of the byte before, each of 264 bytes or what is
// left.
std::string thousand_equal_points() {
  constexpr std::size_t points = 1000;
  constexpr std::size_t size = points * 24;
  std::string body("\1\0\0", 3);
  for (std::size_t left = size - 2; left > 0;) {
    const std::size_t run = left > 264 && left < 267 ? 200 : std::min<std::size_t>(left, 264);
    body += run > 8 ? std::string{'\xe0', static_cast<char>(run - 9), '\0'}
                    : std::string{static_cast<char>((run - 2) << 5), '\0'};
    left -= run;
  }
  return fmt::format(
             "# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {}\nHEIGHT 1\n"
             "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA binary_compressed\n",
             points, points) +
         four_bytes(body.size()) + four_bytes(size) + body;
}

TEST_F(MemoryLimit, EveryCommandThatReadsAScanLimitsItsMemory) {
  take("ball-bar");
  write("ball-bar/scan.pcd", thousand_equal_points());
  write("ball-bar/recording.toml",
        "schema = \"artcal-recording/1\"\narm = \"arm.toml\"\nartefacts = [\"bar.toml\"]\n"
        "units = { joint = \"deg\", length = \"mm\" }\n[[scan]]\nfile = \"scan.pcd\"\nplacement = \"1\"\n");
  const std::string recording = "ball-bar/recording.toml";
  for (std::vector<std::string> command :
       {std::vector<std::string>{"identify", recording},
        {"coupling", recording},
        {"points", recording},
        {"verify", recording, "--standard", "iso10360-12"},
        {"uncertainty", recording, "--monte-carlo"},
        {"plan", "ball-bar/arm.toml", "--artefact", "ball-bar/bar.toml", "--encoder-noise", "2 arcsec",
         "--probing-noise", "3 um", "--measured", recording},
        {"batch", recording, "--store", "s.sqlite"},
        {"fit", "ball-bar/scan.pcd", "--shape", "sphere", "--unit", "mm"},
        {"segment", "ball-bar/scan.pcd", "--artefact", "ball-bar/bar.toml", "--unit", "mm"}}) {
    command.insert(command.end(), {"--max-memory", "50000", "-q"});
    const testing::Ended refused = run(command);
    EXPECT_EQ(refused.exit_code, 3) << command[0];
    EXPECT_THAT(refused.err, HasSubstr("or allow more with --max-memory")) << command[0];
    command[command.size() - 2] = "60kB";
    EXPECT_THAT(run(command).err, HasSubstr("points are the same")) << command[0];
  }
}

}  // namespace
}  // namespace artcal
