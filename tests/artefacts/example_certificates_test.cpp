// Every certificate in examples/certificates is one that the program reads, and says what it says on paper.
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefacts/artefact/artefact_file.h"
#include "artefacts/artefact/artefact_type.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;

const std::filesystem::path folder = std::filesystem::path(ARTCAL_SOURCE_DIR) / "examples" / "certificates";

Artefact certificate(const std::string& name) {
  const auto file = read_artefact_file(folder / name);
  EXPECT_TRUE(file) << file.error().text();
  return file ? file->artefact : Artefact{};
}

TEST(ExampleCertificates, AreReadAndLabelledAndCoverEveryType) {
  std::set<ArtefactType> types;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") {
      continue;
    }
    const Artefact artefact = certificate(entry.path().filename());
    EXPECT_NE(artefact.type, ArtefactType::Other) << entry.path();
    EXPECT_THAT(artefact.note, HasSubstr("ade up")) << entry.path();
    types.insert(artefact.type);
  }
  EXPECT_EQ(types.size(), 8u) << "of " << artefact_type_names();
}

TEST(ExampleCertificates, SpherePlateHasItsRuleAtEachBall) {
  const Artefact plate = certificate("sphere-plate.toml");
  ASSERT_EQ(plate.features.size(), 25u);
  EXPECT_NEAR(plate.features[24].at->norm(), 83.0 * 4.0 * std::sqrt(2.0), 0.05);
  // U² = 0.5² + (1.2·0.4695)² µm² at the far corner, 469.5 mm away: U = 0.7533 µm.
  EXPECT_NEAR(plate.features[24].u_at, 0.7533e-3 / 2.0, 1e-7);
  EXPECT_DOUBLE_EQ(plate.features[0].u_at, 0.25e-3);
  EXPECT_DOUBLE_EQ(plate.features[3].u_radius, 0.5 * 0.15e-3) << "half of that of the diameter";
  EXPECT_DOUBLE_EQ(plate.u_expansion, 0.5e-6);
  EXPECT_EQ(plate.certificate.valid_until, "2028-03-01");
}

TEST(ExampleCertificates, PublicBallBarIsConvertedToTwentyDegrees) {
  const Artefact bar = certificate("public-ball-bar.toml");
  ASSERT_EQ(bar.distances.size(), 4u);
  // 500.09940 mm at 20.05 degC, steel: 0.05 K · 11.5e-6/K · 500 mm = 0.2876 µm less at 20 degC.
  EXPECT_NEAR(bar.distances[0].value, 500.0991124, 1e-7);
  EXPECT_EQ(bar.distances[3].value, 500.46535) << "measured at 20 degC";
  // 0.5 µm and 500 mm · 0.05 K · 0.5e-6/K = 0.0125 µm.
  EXPECT_NEAR(bar.distances[0].u, std::hypot(0.5e-3, 0.0125e-3), 1e-8);
  EXPECT_DOUBLE_EQ(bar.distances[3].u, 0.5e-3);
  EXPECT_FALSE(bar.features[0].radius) << "the diameter is unknown";
}

TEST(ExampleCertificates, StepGaugeAlternatesItsFaces) {
  const Artefact gauge = certificate("step-gauge.toml");
  ASSERT_EQ(gauge.features.size(), 32u);
  EXPECT_EQ(gauge.features[0].normal->x(), -1.0);
  EXPECT_EQ(gauge.features[1].normal->x(), 1.0);
  // U = 0.2 + 0.5·0.62 µm at the last face.
  EXPECT_NEAR(gauge.features[31].u_at, 0.5 * (0.2e-3 + 0.5e-6 * 620.0), 1e-8);
}

TEST(ExampleCertificates, TheOthersSayTheirOneThing) {
  EXPECT_DOUBLE_EQ(certificate("ball-bar.toml").distances.at(0).u, 0.4e-3);
  EXPECT_DOUBLE_EQ(certificate("granite-plane.toml").features.at(0).form.value(), 0.0032);
  EXPECT_DOUBLE_EQ(certificate("granite-plane.toml").features.at(0).u_form, 0.45e-3);
  EXPECT_DOUBLE_EQ(certificate("sphere.toml").features.at(0).u_radius, 0.05e-3);
  EXPECT_EQ(certificate("seat-plate.toml").features.size(), 6u);
  EXPECT_DOUBLE_EQ(certificate("gauge-block.toml").distances.at(0).value, 500.00021);
  EXPECT_DOUBLE_EQ(certificate("telescoping-bar.toml").features.at(0).u, 0.6e-3);
}

}  // namespace
}  // namespace artcal
