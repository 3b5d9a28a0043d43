// Artefact files and digital certificates that were damaged at random: each is read or refused with one line, and what
// was read holds finite numbers and nothing that cannot be.
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "artefacts/artefact/artefact_file.h"
#include "artefacts/dcc/dcc_length.h"
#include "artefacts/dcc/dcc_read.h"
#include "tests/support/damage.h"
#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

using testing::damaged;

std::string content(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(std::filesystem::path(ARTCAL_SOURCE_DIR) / name).rdbuf();
  return text.str();
}

void expect_one_line(const Error& error, int mutation) {
  EXPECT_EQ(error.text().find('\n'), std::string::npos) << mutation;
  EXPECT_FALSE(error.message.empty()) << mutation;
  EXPECT_LT(error.text().size(), 4000u) << mutation;
}

bool sound(double u) { return std::isfinite(u) && u >= 0.0; }

void expect_sound(const Artefact& artefact, int mutation) {
  for (const CertifiedFeature& feature : artefact.features) {
    EXPECT_TRUE(!feature.at || feature.at->allFinite()) << mutation;
    EXPECT_TRUE(!feature.normal || std::abs(feature.normal->norm() - 1.0) < 1e-12) << mutation;
    EXPECT_TRUE(!feature.radius || (std::isfinite(*feature.radius) && *feature.radius > 0.0)) << mutation;
    EXPECT_TRUE(sound(feature.u_at) && sound(feature.u_radius) && sound(feature.u_form) && sound(feature.u))
        << mutation;
  }
  for (const CertifiedDistance& distance : artefact.distances) {
    EXPECT_TRUE(std::isfinite(distance.value) && distance.value > 0.0) << mutation;
    EXPECT_TRUE(std::isfinite(distance.u) && distance.u > 0.0) << mutation;
  }
}

void damage_artefact(const std::string& name, int times) {
  const testing::TemporaryFolder folder;
  const std::string good = content("examples/certificates/" + name);
  for (const char* certificate : {"ball-bar-dcc-2.4.0.xml", "ball-bar-dcc-3.3.0.xml"}) {
    (void)folder.write(certificate, content(std::string("examples/certificates/") + certificate));
  }
  int accepted = 0;
  for (int i = 0; i < times; ++i) {
    RandomStream random(2026, name, static_cast<std::uint64_t>(i));
    const auto file = read_artefact_file(folder.write(name, damaged(good, random)));
    if (file) {
      expect_sound(file->artefact, i);
      ++accepted;
    } else {
      expect_one_line(file.error(), i);
    }
  }
  EXPECT_GT(accepted, 0) << "damages in comments and names";
  EXPECT_LT(accepted, times / 2);
}

TEST(ArtefactMutation, SpherePlate) { damage_artefact("sphere-plate.toml", 150); }
TEST(ArtefactMutation, StepGauge) { damage_artefact("step-gauge.toml", 150); }
TEST(ArtefactMutation, PublicBallBar) { damage_artefact("public-ball-bar.toml", 200); }
TEST(ArtefactMutation, BallBarOfADigitalCertificate) { damage_artefact("ball-bar-dcc-3.3.0.toml", 200); }

TEST(DccMutation, EndsInACertificateOrOneLine) {
  const testing::TemporaryFolder folder;
  for (const char* name :
       {"tests/reference/dcc/siliziumkugel_2_4_0.xml", "examples/certificates/ball-bar-dcc-3.3.0.xml"}) {
    const std::string good = content(name);
    for (int i = 0; i < 150; ++i) {
      RandomStream random(2026, name, static_cast<std::uint64_t>(i));
      const auto certificate = read_dcc_file(folder.write("c.xml", damaged(good, random)));
      if (!certificate) {
        expect_one_line(certificate.error(), i);
        continue;
      }
      for (const DccQuantity& quantity : certificate->quantities) {
        EXPECT_EQ(quantity.representations.empty(), quantity.fault.has_value()) << i;
        for (const DccNumbers& numbers : quantity.representations) {
          EXPECT_FALSE(numbers.values.empty()) << i;
          EXPECT_EQ(numbers.units.size(), numbers.values.size()) << i;
          EXPECT_TRUE(numbers.uncertainties.empty() || numbers.uncertainties.size() == numbers.values.size()) << i;
        }
        if (const auto lengths = lengths_of(quantity); !lengths) {
          expect_one_line(lengths.error(), i);
        }
        EXPECT_FALSE(quantity.text().empty()) << i;
      }
    }
  }
}

}  // namespace
}  // namespace artcal
