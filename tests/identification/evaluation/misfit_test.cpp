#include "identification/evaluation/misfit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "identification/evaluation/judgement.h"
#include "identification/identify.h"
#include "tests/support/probing/outcome.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

IdentifyOptions stated(double noise) {
  IdentifyOptions options;
  options.leave_out = false;
  if (noise > 0.0) options.noise.reading = noise;
  return options;
}

std::string refusal(const probing::Bound& bound, const IdentifyOptions& options) {
  const auto result = identify(bound.recording, bound.constraints, options);
  return result ? "" : result.error().text();
}

// One bar of four: no other feature, placement or artefact to compare with.
probing::Session session() { return probing::probe({.kind = probing::Kind::Bar4, .placements = 6, .rough = 0.5}); }

TEST(Misfit, ADiameterForARadiusIsRefused) {
  probing::Session wrong = session();
  for (CertifiedFeature& ball : wrong.artefacts.front().features) *ball.radius *= 2.0;
  const auto bound = probing::bound(wrong, 0.015);
  EXPECT_THAT(refusal(bound, stated(0.015)), HasSubstr("times the stated noise"));
}

// The certificates of all distances are wrong: none stands out beside the others.
TEST(Misfit, WrongCertificatesOfAllDistancesAreRefused) {
  probing::Session wrong = session();
  double sign = 1.0;
  for (CertifiedDistance& distance : wrong.artefacts.front().distances) distance.value += (sign = -sign) * 5.0;
  const auto bound = probing::bound(wrong, 0.015);
  EXPECT_NE(refusal(bound, stated(0.015)), "");
}

TEST(Misfit, SwappedJointsAreRefused) {
  probing::Session wrong = session();
  for (probing::Touch& touch : wrong.touches) std::swap(touch.q[1], touch.q[2]);
  for (const double noise : {0.015, 0.0}) {
    EXPECT_NE(refusal(probing::bound(wrong, noise), stated(noise)), "") << "noise " << noise;
  }
}

// Who acts on a refusal decides by its kind, and takes its parts as they are.
TEST(Misfit, ARefusalHasItsKindAndItsParts) {
  probing::Session wrong = session();
  for (CertifiedFeature& ball : wrong.artefacts.front().features) *ball.radius *= 2.0;
  const auto bound = probing::bound(wrong, 0.015);
  const auto result = identify(bound.recording, bound.constraints, stated(0.015));
  ASSERT_FALSE(result);
  const Error& error = result.error();
  EXPECT_EQ(error.kind, ErrorKind::Misfit);
  EXPECT_THAT(error.message, ::testing::StartsWith(error.found));
  EXPECT_THAT(error.message.substr(error.found.size()), HasSubstr("--accept-misfit"));
  EXPECT_THAT(error.found, Not(HasSubstr("--accept-misfit")));
  EXPECT_THAT(error.found, HasSubstr(error.reason));
  EXPECT_THAT(error.reason, HasSubstr("times the stated noise"));

  const auto sound = probing::bound(session(), 0.015);
  IdentifyOptions options = stated(0.015);
  options.max_iterations = 1;
  const auto unfinished = identify(sound.recording, sound.constraints, options);
  ASSERT_FALSE(unfinished);
  EXPECT_EQ(unfinished.error().kind, ErrorKind::NoConvergence) << unfinished.error().text();

  options = stated(0.015);
  options.hold = {"nothing"};
  EXPECT_EQ(identify(sound.recording, sound.constraints, options).error().kind, ErrorKind::Other);
}

// Of several misfits the first tells most; of one, the message itself without what it begins with.
TEST(Misfit, TheReasonOfSeveralIsTheFirst) {
  const Error several = misfit_error({"the lengths are 5 mm off", "the centres scatter"}, 2, {});
  EXPECT_EQ(several.reason, "the lengths are 5 mm off");
  EXPECT_THAT(several.found, HasSubstr("the lengths are 5 mm off; the centres scatter (2 initial alignments tried)"));
  EXPECT_EQ(misfit_error({"the centres scatter"}, 1, {}).reason, "the centres scatter (1 initial alignment tried)");
}

TEST(Misfit, IsWrittenWhereThatIsAsked) {
  probing::Session wrong = session();
  wrong.touches[7].feature = 1 - std::min(1, wrong.touches[7].feature);
  const auto bound = probing::bound(wrong, 0.015);
  IdentifyOptions options = stated(0.015);
  EXPECT_THAT(refusal(bound, options), HasSubstr("--accept-misfit"));
  options.accept_misfit = true;
  const auto result = identify(bound.recording, bound.constraints, options);
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_THAT(result->misfits, Not(::testing::IsEmpty()));
}

TEST(Misfit, ASoundFitHasNone) {
  for (const double noise : {0.015, 0.0}) {
    const auto bound = probing::bound(session(), noise);
    const auto result = identify(bound.recording, bound.constraints, stated(noise));
    ASSERT_TRUE(result) << result.error().text();
    EXPECT_THAT(result->misfits, ::testing::IsEmpty());
  }
}

// Errors that a model lacks are far above a stated noise of the encoders alone and still no misfit: 0.05 mm of an arm
// of 1.9 m whose noise is said to be 1 um.
TEST(Misfit, UnmodelledErrorsOfASoundArmAreNone) {
  const auto bound =
      probing::bound(probing::probe({.kind = probing::Kind::Bar4, .placements = 6, .noise = 0.05}), 0.001);
  EXPECT_EQ(refusal(bound, stated(0.001)), "");
}

}  // namespace
}  // namespace artcal
