#include "artefacts/verification/decision/traceability.h"

#include <functional>

#include <gmock/gmock.h>

#include "acquisition/recording/reading_fingerprint.h"
#include "artefacts/verification/iso10360_12/iso10360_12.h"
#include "tests/support/reported_readings.h"

namespace artcal {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::SessionMaterial;

/// One ball, 25 points, judged by simple acceptance: everything conforms whatever a certificate leaves open.
SessionMaterial sound() {
  testing::ReportedReadings readings;
  RandomStream random(1, "traceability");
  readings.touch_ball({"ball", "1", "ball", "", ""}, {500.0, 0.0, 100.0}, 12.5, testing::pattern_25(), 0.001, random);
  Artefact artefact;
  artefact.name = "ball";
  artefact.features = {testing::ball("ball", 25.0)};
  Specification by;
  by.limits = {{Quantity::SizeError, {0.1, 0.0, {}}}, {Quantity::FormError, {0.1, 0.0, {}}}};
  by.rule = DecisionRule::Simple;
  by.plan = TestPlan{};
  return {readings.recording(), {artefact}, by};
}

Verification verified(const std::function<void(SessionMaterial&)>& change, const ArmIdentification* known = nullptr) {
  SessionMaterial material = sound();
  change(material);
  Session session = material.session();
  const Session with{session.recording, session.constraints, session.arm, session.tips, session.specification, known};
  return verify_iso10360_12(with).value();
}

Certificate& certificate_of(SessionMaterial& material) { return material.constraints.artefacts[0].certificate; }

TEST(Traceability, ASoundTestShowsConformity) {
  const Verification result = verified([](SessionMaterial&) {});
  EXPECT_EQ(result.conclusion, Conclusion::ConformityProven);
  EXPECT_THAT(result.missing, IsEmpty());
  EXPECT_THAT(result.waived, IsEmpty());
}

TEST(Traceability, TheDaysAtWhichValidityBeginsAndEnds) {
  const auto conclusion_on = [](const std::string& day) {
    return verified([&](SessionMaterial& m) { m.recording.date = day; }).conclusion;
  };
  EXPECT_EQ(conclusion_on("2026-03-01"), Conclusion::ConformityNotShown);  // the day before the calibration
  EXPECT_EQ(conclusion_on("2026-03-02"), Conclusion::ConformityProven);
  EXPECT_EQ(conclusion_on("2028-03-01"), Conclusion::ConformityProven);
  EXPECT_EQ(conclusion_on("2028-03-02"), Conclusion::ConformityNotShown);  // the day after the last
}

TEST(Traceability, EachDefectIsNamedAndCanBeWaivedByItsName) {
  const auto certificate = [](const std::function<void(Certificate&)>& change) {
    return [change](SessionMaterial& material) { change(certificate_of(material)); };
  };
  const std::vector<std::tuple<std::string, std::string, std::function<void(SessionMaterial&)>>> cases{
      {"certificate_lapsed", "had lapsed: it was valid until 2026-03-09",
       certificate([](Certificate& c) { c.valid_until = "2026-03-09"; })},
      {"certificate_not_yet_valid", "was not yet valid: it was calibrated on 2026-03-11",
       certificate([](Certificate& c) { c.date = "2026-03-11"; })},
      {"certificate_absent", "has no certificate", certificate([](Certificate& c) { c = {}; })},
      {"certificate_absent", "states no number", certificate([](Certificate& c) { c.number.clear(); })},
      {"certificate_absent", "states no date", certificate([](Certificate& c) { c.date.clear(); })},
      {"date_absent", "the recording states no date", [](SessionMaterial& m) { m.recording.date.clear(); }}};
  for (const auto& [name, words, change] : cases) {
    const Verification missing = verified(change);
    EXPECT_EQ(missing.conclusion, Conclusion::ConformityNotShown) << name;
    EXPECT_THAT(missing.missing, ElementsAre(::testing::AllOf(HasSubstr(words), HasSubstr("[" + name + "]"))));
    const Verification waived = verified([&, &change = change, &name = name](SessionMaterial& material) {
      change(material);
      material.specification.waived = {evidence_named(name).value()};
    });
    EXPECT_EQ(waived.conclusion, Conclusion::ConformityProven) << name;
    EXPECT_THAT(waived.waived, ElementsAre(HasSubstr(words))) << name;
    const Verification other = verified([&, &change = change, &name = name](SessionMaterial& material) {
      change(material);
      material.specification.waived = {Evidence::CentreDilution};
    });
    EXPECT_EQ(other.conclusion, Conclusion::ConformityNotShown) << name;
  }
}

// A warning of the documents that a test notes as missing is not said beside it; of an artefact that the test does not
// rest on, it is.
TEST(Traceability, NotesWhatTheDocumentsWarnOfByArtefact) {
  SessionMaterial material = sound();
  certificate_of(material).valid_until = "2026-03-09";
  auto& artefacts = material.constraints.artefacts;
  artefacts[0].reference_temperature = 68.0;
  artefacts.push_back(artefacts[0]);
  artefacts[1].name = "not read";
  material.recording.arm.probes[0].radius = 1e-9;
  material.specification.u_fixture = 1.0;  // implausible too, but nothing that the documents' warnings are about
  const auto warnings = document_warnings(material.recording, artefacts);
  ASSERT_EQ(warnings.size(), 5u) << "two of each artefact, one of the recording";
  for (const bool is_waived : {false, true}) {
    if (is_waived) {
      material.specification.waived = {Evidence::CertificateLapsed, Evidence::PlausibleValues};
    }
    const Verification result = verify_iso10360_12(material.session()).value();
    for (const DocumentWarning& warning : warnings) {
      EXPECT_EQ(is_noted(result, warning), warning.about != (Subject{Subject::Kind::Artefact, 1})) << warning.text;
    }
    EXPECT_FALSE(is_noted(result, {DocumentWarning::Kind::CertificateNotYetValid, {Subject::Kind::Artefact, 0}, ""}));
  }
}

// Ten readings of the identification, of which a test takes some, in another unit and order.
TEST(Traceability, AnArmIsNotJudgedByAnyReadingThatItWasIdentifiedFrom) {
  Recording all;
  RandomStream random(2, "joints");
  all.joints = Eigen::MatrixXd::NullaryExpr(6, 10, [&] { return random.uniform(-3.0, 3.0); });
  ArmIdentification known;
  known.readings = fingerprints_of(all, {});
  const auto judged_by = [&](int shared) {
    return verified(
        [&](SessionMaterial& material) {
          auto& joints = material.recording.joints;
          joints = Eigen::MatrixXd::NullaryExpr(6, 25, [&] { return random.uniform(-3.0, 3.0); });
          for (int i = 0; i < shared; ++i) {
            // Through degrees of nine decimals and back.
            const Eigen::VectorXd degrees = all.joints.col(9 - i) * 180.0 / std::numbers::pi;
            joints.col(2 * i) = (degrees * 1e9).array().round().matrix() * 1e-9 * std::numbers::pi / 180.0;
          }
        },
        &known);
  };
  EXPECT_EQ(judged_by(0).conclusion, Conclusion::ConformityProven);
  for (const int shared : {1, 10}) {
    const Verification result = judged_by(shared);
    EXPECT_EQ(result.conclusion, Conclusion::ConformityNotShown);
    EXPECT_THAT(result.missing, ElementsAre(HasSubstr("[independent_readings]")));
  }
  EXPECT_THAT(judged_by(1).missing, Contains(HasSubstr("1 of the 25 readings")));
}

// Files of earlier versions have the hash of the recording alone.
TEST(Traceability, TheRecordingItselfIsKnownByItsHash) {
  ArmIdentification known;
  known.recording = "c0ffee";
  const auto with_hash = [&](const std::string& hash) {
    return verified([&](SessionMaterial& material) { material.recording.inputs = {{"recording.toml", hash}}; }, &known);
  };
  EXPECT_THAT(with_hash("c0ffee").missing, ElementsAre(HasSubstr("identified from this recording")));
  EXPECT_THAT(with_hash("decaf").missing, IsEmpty());
}

}  // namespace
}  // namespace artcal
