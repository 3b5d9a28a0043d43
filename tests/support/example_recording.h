#pragma once

#include <string>
#include <string_view>

#include "tests/support/temporary_folder.h"

namespace artcal::testing {

/// A recording of a two-joint arm on disk, each file of which a test may replace before it is read.
struct ExampleRecording {
  std::string arm =
      "schema = \"artcal-arm/1\"\nname = \"two\"\nconvention = \"standard\"\n"
      "units = { length = \"mm\", angle = \"deg\" }\n"
      "[[joint]]\na = 100\nd = 200\ntheta = 0\nalpha = 90\n"
      "[[joint]]\na = 300\nd = 0\ntheta = 0\nalpha = 0\n"
      "[[probe]]\nname = \"ball\"\nl = 50\nradius = 3\n";
  std::string readings = "placement,feature,q1,q2\np1,A,10,20\np1,B,30,40\np2,A,-50,60\np2,B,70,-80\np2,C,90,100\n";
  std::string recording =
      "schema = \"artcal-recording/1\"\narm = \"arm.toml\"\nreadings = [\"readings.csv\"]\n"
      "units = { joint = \"deg\", length = \"mm\" }\n";

  /// Writes the three files; the path of recording.toml.
  [[nodiscard]] std::filesystem::path write(const TemporaryFolder& folder) const {
    (void)folder.write("arm.toml", arm);
    (void)folder.write("readings.csv", readings);
    return folder.write("recording.toml", recording);
  }
};

/// `text` with its one occurrence of `from` replaced; aborts where there is none, so that no test
/// quietly tests the unchanged file.
inline std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos || text.find(from, at + 1) != std::string::npos) {
    std::abort();
  }
  return text.replace(at, from.size(), to);
}

}  // namespace artcal::testing
