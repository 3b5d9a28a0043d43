// Events become readings: by a chain that this file multiplies out itself.
#include "app/stream/recording_session.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <Eigen/Geometry>

#include "core/units.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

constexpr int joints = 4;
constexpr double a[joints] = {0.0, 400.0, 350.0, 60.0};
constexpr double d[joints] = {250.0, 0.0, 30.0, 0.0};
constexpr double alpha[joints] = {90.0, 10.0, -75.0, 90.0};

Arm small_arm() {
  Arm arm;
  for (int j = 0; j < joints; ++j) {
    Joint joint;
    joint.a = a[j];
    joint.d = d[j];
    joint.alpha = alpha[j] * units::degree;
    arm.joints.push_back(joint);
  }
  arm.probes.resize(1);
  arm.probes[0].tip_in_last = {0.0, 0.0, 90.0};
  arm.probes[0].radius = 3.0;
  return arm;
}

// Rz(q) Tz(d) Tx(a) Rx(alpha), q in deg.
Eigen::Vector3d tip(const std::vector<double>& q) {
  Eigen::Isometry3d chain = Eigen::Isometry3d::Identity();
  for (int j = 0; j < joints; ++j) {
    chain = chain * Eigen::AngleAxisd(q[static_cast<std::size_t>(j)] * units::degree, Eigen::Vector3d::UnitZ()) *
            Eigen::Translation3d(a[j], 0.0, d[j]) *
            Eigen::AngleAxisd(alpha[j] * units::degree, Eigen::Vector3d::UnitX());
  }
  return chain * Eigen::Vector3d(0.0, 0.0, 90.0);
}

StreamFormat columns(bool with_xyz) {
  StreamFormat format;
  format.joints = {"1", "2", "3", "4"};
  format.joint_scale.assign(joints, units::degree);
  if (with_xyz) format.xyz = {"5", "6", "7"};
  return format;
}

std::vector<Artefact> plate() {
  Artefact artefact;
  artefact.name = "plate";
  for (const char* name : {"A", "B", "C"}) {
    CertifiedFeature feature;
    feature.name = name;
    feature.kind = FeatureKind::Point;
    artefact.features.push_back(feature);
  }
  artefact.distances.push_back({0, 1, 100.0, 0.001});
  return {artefact};
}

RecordingSession session(StreamFormat format) {
  return {small_arm(), 0, plate(), std::move(format), LabelSequence(plate(), {})};
}

std::vector<double> posture(int i) {
  return {10.0 + 31.0 * i, -40.0 + 17.0 * (i % 5), 25.0 - 23.0 * (i % 7), 5.0 + 41.0 * (i % 3)};
}

std::string line_of(const std::vector<double>& q) { return fmt::format("{}", fmt::join(q, ",")); }

// Eight readings whose coordinates are those of their angles, turned and moved, the angles then as `spoil` leaves them.
template <typename Spoil>
std::vector<std::string> mistakes_with(const Spoil& spoil) {
  RecordingSession taken = session(columns(true));
  const Eigen::Isometry3d other_frame =
      Eigen::Translation3d(700.0, -30.0, 12.0) * Eigen::AngleAxisd(1.2, Eigen::Vector3d(1.0, 2.0, -1.0).normalized());
  for (int i = 0; i < 8; ++i) {
    std::vector<double> q = posture(i);
    const Eigen::Vector3d at = other_frame * tip(q);
    spoil(q);
    (void)taken.feed(fmt::format("{},{},{},{}", line_of(q), at.x(), at.y(), at.z()));
    (void)taken.operate("next placement");  // so that touches are not compared with one another
  }
  return taken.mistakes();
}

TEST(RecordingSession, FindsOrderSignAndUnitOfJointsAtTheFirstReadings) {
  EXPECT_THAT(mistakes_with([](std::vector<double>&) {}), IsEmpty());
  EXPECT_THAT(mistakes_with([](std::vector<double>& q) { std::swap(q[1], q[2]); }),
              ElementsAre(HasSubstr("with q2 and q3 exchanged they deviate by")));
  EXPECT_THAT(mistakes_with([](std::vector<double>& q) { q[2] = -q[2]; }),
              ElementsAre(HasSubstr("with the sign of q3 reversed they")));
  EXPECT_THAT(mistakes_with([](std::vector<double>& q) {
                for (double& v : q) v = -v;
              }),
              ElementsAre(HasSubstr("with all signs reversed they")));
  EXPECT_THAT(mistakes_with([](std::vector<double>& q) {
                for (double& v : q) v *= units::degree;
              }),
              ElementsAre(HasSubstr("with the angles read as radians they")));
  EXPECT_THAT(mistakes_with([](std::vector<double>& q) {
                for (double& v : q) v *= units::degree;
                std::swap(q[0], q[3]);
              }),
              ElementsAre(HasSubstr("with the angles read as radians and q1 and q4 exchanged they")));
  EXPECT_THAT(mistakes_with([](std::vector<double>& q) { q[1] += 40.0; }), ElementsAre(HasSubstr("check order")));
}

TEST(RecordingSession, NamesATouchThatIsFarFromTheEarlierOnes) {
  RecordingSession taken = session(columns(false));
  (void)taken.feed("10,-40,25,5");
  EXPECT_THAT(taken.feed("10.001,-40,25,5").note,
              AllOf(StartsWith("0.0"), HasSubstr(" mm from the earlier touches"), Not(HasSubstr("+"))));
  EXPECT_THAT(taken.feed("25,-40,25,5").message, HasSubstr("did the artefact move? Undo it if so"));
  EXPECT_TRUE(taken.operate("undo").removes_last);
  EXPECT_EQ(taken.feed("10.002,-40,25,5").message, "");
  (void)taken.operate("next feature");
  const auto step = taken.feed("60,-40,25,5");
  EXPECT_EQ(step.label, "plate 1 B");
  EXPECT_THAT(step.message, HasSubstr("certified 100.000 mm; is it another feature"));
}

TEST(RecordingSession, TellsWhatAllReadingsDetermineAndTakesAnUndoneOneOutOfIt) {
  RecordingSession taken = session(columns(false));
  taken.predict(SessionInformation(small_arm(), plate(), 1e-5, 0.003), 0.02);
  std::string note;
  for (int i = 0; i < 12; ++i) note = taken.feed(line_of(posture(i))).note;
  EXPECT_THAT(note, ::testing::ContainsRegex("rank [1-9][0-9]* of 19, u of a length .*, goal 20 µm"));
  (void)taken.operate("undo");
  EXPECT_EQ(taken.feed(line_of(posture(11))).note, note);
}

TEST(RecordingSession, ThinsByTheTimeOfEventsAndTakesAnArmThatHoldsStillOnce) {
  StreamFormat format = columns(false);
  format.time = "5";
  format.at_rest_within = 0.02 * units::degree;
  RecordingSession taken = session(format);
  std::size_t rows = 0;
  const auto feed = [&](double q1, double time) {
    rows += taken.feed(fmt::format("{},-40,25,5,{}", q1, time)).row.empty() ? 0 : 1;
  };
  for (int i = 0; i < 100; ++i) feed(10.0 + 0.1 * i, 0.001 * i);  // moves
  EXPECT_EQ(rows, 0U);
  for (int i = 0; i < 1000; ++i) feed(20.0 + 0.001 * (i % 3), 0.1 + 0.001 * i);  // holds still for a second
  EXPECT_EQ(rows, 1U);
  EXPECT_EQ(taken.passed_over().at("the arm is not at rest"), 100U + 200U);
  format.at_rest_within = 0.0;
  RecordingSession flooded = session(format);
  for (int i = 0; i < 10'000; ++i) {
    rows += flooded.feed(fmt::format("{},-40,25,5,{}", 0.01 * i, 0.0001 * i)).row.empty() ? 0 : 1;
  }
  EXPECT_EQ(rows, 1U + 20U);
}

TEST(RecordingSession, GoesOnAfterTheRowsOfAnEarlierRunAndRefusesOthers) {
  RecordingSession first = session(columns(false));
  const std::string one = first.feed(line_of(posture(1))).row;
  (void)first.operate("feature B");
  const std::string two = first.feed(line_of(posture(2))).row;
  RecordingSession again = session(columns(false));
  ASSERT_TRUE(again.resume({one, two}).has_value());
  EXPECT_EQ(again.feed(line_of(posture(1))).row, "");
  EXPECT_THAT(again.feed(line_of(posture(3))).row, ::testing::StartsWith("plate,1,B,"));
  EXPECT_FALSE(session(columns(false)).resume({"plate,1,A,1,2,3"}).has_value());
  EXPECT_FALSE(session(columns(false)).resume({"plate,1,A,1,2,3,x"}).has_value());
}

TEST(RecordingSession, LinesOfBrokenDevicesAreCountedAndNeverTaken) {
  RecordingSession taken = session(columns(false));
  for (const char* line : {"nan,1,2,3", "inf,1,2,3", "1,2,3", "1,2,3,", "1,2,3,4x", "1;2;3;4", "\x01\x02", ",,,"}) {
    EXPECT_EQ(taken.feed(line).row, "") << line;
  }
  EXPECT_EQ(taken.cut_off("1,2,3,4").row, "");
  for (int i = 0; i < 1000; ++i) (void)taken.feed(fmt::format("{}x,1,2,3", i));
  EXPECT_LE(taken.passed_over().size(), 22U);
  for (const char* name : {"!placement \xff\xfe", "!placement a\x1b[2J", "!placement", "!\xff"}) {
    EXPECT_EQ(taken.feed(name).row, "");
  }
  EXPECT_THAT(taken.feed("1,2,3,4").row, ::testing::StartsWith("plate,1,A,1.0"));
}

}  // namespace
}  // namespace artcal
