// A ball that was scanned instead of touched in single points: what it says of form is what was planted, neither
// made smaller by leaving points out nor larger by taking foreign ones in.
#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "acquisition/recording/recording_file.h"
#include "artefacts/constraints/bound_recording.h"
#include "artefacts/scans/scan_readings.h"
#include "artefacts/verification/iso10360_12/iso10360_12.h"
#include "core/random.h"
#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using V = Eigen::Vector3d;

constexpr double ball_radius = 12.7;
constexpr double tip_radius = 3.0;
const V centre(420.0, -310.0, 150.0);

/// Where the tip's centre was on a ball on a stem, by the arm's own software.
struct Planted {
  double noise = 0.01;                                                  ///< along the radius, mm
  std::function<double(const V&)> form = [](const V&) { return 0.0; };  ///< by direction, mm
  double larger = 0.0;                                                  ///< the ball's radius than certified, mm
  int points = 6000;
  std::uint64_t seed = 1;

  [[nodiscard]] std::string text() const {
    RandomStream random(seed, "scanned ball");
    std::string text = "x y z\n";
    const auto add = [&](const V& at) { text += fmt::format("{} {} {}\n", at.x(), at.y(), at.z()); };
    for (int i = 0; i < points;) {
      const V direction = random.direction();
      if (direction.z() > -0.8) {
        add(centre + (ball_radius + tip_radius + larger + form(direction) + noise * random.normal()) * direction);
        ++i;
      }
    }
    for (int i = 0; i < points / 10; ++i) {  // the stem, and a tip in the air
      const double turn = random.uniform(0.0, 6.2832);
      add(centre + V(7.2 * std::cos(turn), 7.2 * std::sin(turn), -random.uniform(14.0, 45.0)));
    }
    for (int i = 0; i < 20; ++i) {
      const V direction = random.direction();
      add(centre + random.uniform(1.6, 5.0) * (ball_radius + tip_radius) * direction);
    }
    return text;
  }
};

struct Scanned {
  Verification verification;
  Recording recording;

  [[nodiscard]] double value(Quantity quantity) const {
    const TestValue* worst = worst_of(verification, quantity);
    return worst == nullptr ? std::nan("") : worst->value;
  }
};

Expected<Scanned> scanned(const Planted& planted, ScanUse use = ScanUse::WholeBalls, const std::string& more = "",
                          const Specification& by = {}) {
  const testing::TemporaryFolder folder;
  (void)folder.write("scan.txt", planted.text());
  (void)folder.write(
      "ball.toml",
      "schema = \"artcal-artefact/1\"\nname = \"ball\"\nunits = { length = \"mm\" }\n[[feature]]\nname = "
      "\"ball\"\nkind = \"sphere\"\ndiameter = 25.4\nform = 0.0001\nU_diameter = 0.0002\nk_diameter = 2\n");
  const auto path = folder.write("recording.toml",
                                 "schema = \"artcal-recording/1\"\nartefacts = [\"ball.toml\"]\nunits = { length = "
                                 "\"mm\" }\n[[probe]]\nradius = 3\n"
                                 "[[scan]]\nfile = \"scan.txt\"\nplacement = \"1\"\n" +
                                     more);
  Scanned result;
  auto recording = read_recording(path);
  if (!recording) return tl::unexpected(recording.error());
  auto bound = bind_recording(std::move(*recording), {use, nullptr});
  if (!bound) return tl::unexpected(bound.error());
  result.recording = std::move(bound->recording);
  const auto tips = tip_centres(result.recording);
  if (!tips) return tl::unexpected(tips.error());
  auto verification = verify_iso10360_12({result.recording, bound->constraints, result.recording.arm, *tips, by});
  if (!verification) return tl::unexpected(verification.error());
  result.verification = std::move(*verification);
  return result;
}

TEST(ScannedBall, FormIsThatOfTheNoise) {
  for (const double noise : {0.003, 0.02, 0.1, 0.25}) {
    Planted planted;
    planted.noise = noise;
    const auto result = scanned(planted);
    ASSERT_TRUE(result) << result.error().text();
    const double range = 2.0 * 1.959964 * noise;  // of the middle 95 % of a normal distribution
    EXPECT_NEAR(result->value(Quantity::FormErrorD95) / range, 1.0, 0.04) << noise;
    EXPECT_NEAR(result->value(Quantity::SizeErrorAll), 0.0, 2.0 * 5.0 * noise / std::sqrt(6000.0)) << noise;
  }
}

// A bump on a tenth of what was scanned: 95 % of the points cannot do without half of it.
Planted with_bump(double height, double noise) {
  Planted planted;
  planted.noise = noise;
  planted.form = [height](const V& direction) { return direction.x() > 0.8 ? height : 0.0; };
  return planted;
}

TEST(ScannedBall, ABumpIsSeenWhateverTheNoise) {
  for (const double noise : {0.001, 0.005, 0.02}) {
    for (const double height : {0.1, 0.3}) {
      const auto result = scanned(with_bump(height, noise));
      ASSERT_TRUE(result) << result.error().text();
      // The sphere leans towards the bump and takes a part of it.
      EXPECT_GT(result->value(Quantity::FormErrorD95), 0.6 * height) << noise;
      EXPECT_LT(result->value(Quantity::FormErrorD95), height + 5.0 * noise) << noise;
    }
  }
}

// Octants in and out by turns: no sphere takes any of it.
TEST(ScannedBall, AnOutOfRoundBallShowsItsForm) {
  for (const double noise : {0.002, 0.02}) {
    for (const double range : {0.05, 0.2}) {
      Planted planted;
      planted.noise = noise;
      planted.form = [range](const V& d) { return d.x() * d.y() * d.z() > 0.0 ? 0.5 * range : -0.5 * range; };
      const auto result = scanned(planted);
      ASSERT_TRUE(result) << result.error().text();
      EXPECT_GT(result->value(Quantity::FormErrorD95), range) << noise;
      EXPECT_LT(result->value(Quantity::FormErrorD95), 1.15 * range + 4.0 * noise) << noise;
    }
  }
}

TEST(ScannedBall, ABallReadTooLargeShowsItsSize) {
  for (const double larger : {-0.1, 0.1}) {
    Planted planted;
    planted.larger = larger;
    const auto result = scanned(planted);
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_NEAR(result->value(Quantity::SizeErrorAll), 2.0 * larger, 0.002);
  }
}

TEST(ScannedBall, WhereItEndsMustBeTold) {
  Planted planted;
  planted.noise = 1.0;
  const auto result = scanned(planted);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::NoSolution);
}

TEST(ScannedBall, LimitsOfSinglePointsAreNotItsOwn) {
  Specification by;
  by.limits = {{Quantity::FormError, {0.1, 0.0, {}}}, {Quantity::FormErrorD95, {0.1, 0.0, {}}}};
  const auto result = scanned({}, ScanUse::WholeBalls, "", by);
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_EQ(worst_of(result->verification, Quantity::FormErrorD95)->verdict, Verdict::ConformityProven);
  EXPECT_EQ(worst_of(result->verification, Quantity::FormError), nullptr);
  EXPECT_THAT(result->verification.missing, Contains(HasSubstr("a scan gives P_Size.Sph.All and P_Form.Sph.D95%")));
}

TEST(ScannedBall, SaysWhatItTookAndHowMuchOfTheBallItSaw) {
  const auto result = scanned({}, ScanUse::WholeBalls, "repeat = \"2\"\n");
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_THAT(result->recording.warnings, Contains(HasSubstr("% of it; the others were not used")));
  EXPECT_EQ(result->verification.values.front().repeat, "2");
  EXPECT_EQ(result->verification.values.front().artefact, "ball");
}

TEST(ScannedBall, FewPointsTellNoForm) {
  const auto result = scanned({}, ScanUse::WholeBalls, "use_every = 400\n");
  EXPECT_THAT(result ? "evaluated" : result.error().text(), HasSubstr("95 % of fewer than 20"));
}

TEST(ScannedBall, IdentificationTakesNoCoordinates) {
  const auto result = scanned({}, ScanUse::SureOfBall);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().text(), HasSubstr("the recording names no arm"));
}

}  // namespace
}  // namespace artcal
