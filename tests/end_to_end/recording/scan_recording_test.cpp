// Scans with joint angles per point: from the files to the arm that made them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "acquisition/arm/arm_file.h"
#include "tests/end_to_end/program.h"
#include "tests/support/arm_scans.h"
#include "tests/support/example_recording.h"
#include "tests/support/forward_kinematics.h"

namespace artcal {
namespace {

using testing::Ended;
using ::testing::HasSubstr;

constexpr int placements = 10;

class ScanRecording : public testing::ProgramTest {
 protected:
  ScanRecording() {
    take("ball-bar");
    write("scans/bar.toml", testing::bar_file({}));
    std::string recording =
        "schema = \"artcal-recording/1\"\narm = \"../ball-bar/arm.toml\"\nartefacts = [\"bar.toml\"]\n"
        "units = { joint = \"deg\", length = \"mm\" }\n";
    for (int i = 0; i < placements; ++i) {
      testing::ArmScanSettings settings;
      settings.seed = static_cast<std::uint64_t>(i + 1);
      settings.wiggle = 1.0;
      write(fmt::format("scans/{}.txt", i), testing::text_of(testing::scan_with_arm(truth_, settings)));
      recording += fmt::format("[[scan]]\nfile = \"{}.txt\"\nplacement = \"{}\"\n", i, i);
    }
    write("scans/recording.toml", recording);
  }

  /// Largest error of a length between two places that the arm has not been scanned at, mm.
  [[nodiscard]] double worst_length(const Arm& arm) const {
    testing::ArmScanSettings settings;
    settings.noise = 0.0;
    double worst = 0.0;
    for (std::uint64_t seed = 101; seed <= 110; ++seed) {
      settings.seed = seed;
      const auto scan = testing::scan_with_arm(truth_, settings);
      for (std::size_t i = 0; i + 210 < scan.joints.size(); i += 30) {
        worst = std::max(worst, std::abs(length(arm, scan, i) - length(truth_, scan, i)));
      }
    }
    return worst;
  }

  Arm truth_ = testing::planted_errors(testing::arm_with_ball_tip(), 1);

 private:
  static double length(const Arm& arm, const testing::ArmScan& scan, std::size_t i) {
    const testing::ArmNumbers<double> numbers(arm);
    const auto tip = [&](std::size_t k) {
      return testing::tip_in_base(numbers, std::vector<double>(scan.joints[k].begin(), scan.joints[k].end()), 0);
    };
    return (tip(i + 210) - tip(i)).norm();
  }
};

TEST_F(ScanRecording, IdentifiesTheArmThatScanned) {
  const Ended ended = run({"identify", "scans/recording.toml", "-o", "found.toml"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out + ended.err, HasSubstr("points became readings"));
  const auto found = read_arm_file(file("found.toml"));
  ASSERT_TRUE(found);
  EXPECT_GT(worst_length(testing::arm_with_ball_tip()), 0.5);
  EXPECT_LT(worst_length(found->arm), 0.03);
}

TEST_F(ScanRecording, VerificationTakesTheArmThatScannedForAGoodOneAndTheNominalOneForABad) {
  Arm truth = truth_;
  truth.probes[0].name = "ball 6 mm";  // as in the recording's arm
  write("truth.toml", arm_file_text(truth, std::nullopt));
  write("scans/specification.toml",
        "schema = \"artcal-specification/1\"\nname = \"made up\"\nunits = { length = \"mm\", limit = \"um\" }\n"
        "[[limit]]\nof = \"E_Uni\"\nB = 20\n");
  const auto lengths = [&](const std::vector<std::string>& arm) {
    std::vector<std::string> command{"verify",          "scans/recording.toml",     "--standard", "iso10360-12",
                                     "--specification", "scans/specification.toml", "--json",     "-"};
    command.insert(command.end(), arm.begin(), arm.end());
    const Ended ended = run(command);
    EXPECT_EQ(ended.exit_code, 1) << ended.err;  // without a plan, whether it is enough is not determined
    return nlohmann::json::parse(ended.out);
  };
  const auto by_truth = lengths({"--arm", "truth.toml"});
  EXPECT_EQ(by_truth["values"].size(), 3u * placements);
  for (const auto& value : by_truth["values"]) {
    EXPECT_EQ(value["verdict"], "conforms") << value.dump();
    // 10 um of noise on 150 points, most of a ball: centres are told to some micrometres.
    EXPECT_LT(std::abs(value["value_mm"].get<double>()), 0.015) << value.dump();
  }
  EXPECT_EQ(lengths({})["conclusion"], "non_conformity_shown");
}

TEST_F(ScanRecording, AMissingScanIsNamed) {
  std::filesystem::remove(file("scans/3.txt"));
  const Ended ended = run({"identify", "scans/recording.toml"});
  EXPECT_EQ(ended.exit_code, 3);
  EXPECT_THAT(ended.err, HasSubstr("3.txt"));
}

}  // namespace
}  // namespace artcal
