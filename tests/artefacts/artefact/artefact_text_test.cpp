#include "artefacts/artefact/artefact_text.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "artefacts/artefact/artefact_file.h"
#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

Artefact read_back(const Artefact& artefact) {
  const testing::TemporaryFolder folder;
  const std::string text = artefact_file_text(artefact, {"a comment", "and another"});
  const auto file = read_artefact_file(folder.write("written.toml", text));
  if (!file) throw std::runtime_error(file.error().text() + "\n" + text);
  return file->artefact;
}

void expect_same(const Artefact& a, const Artefact& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.type, b.type);
  EXPECT_EQ(a.frame, b.frame);
  EXPECT_EQ(a.note, b.note);
  EXPECT_EQ(a.material, b.material);
  EXPECT_EQ(a.supports, b.supports);
  EXPECT_EQ(a.expansion, b.expansion);
  EXPECT_EQ(a.expansion_is_known, b.expansion_is_known);
  EXPECT_EQ(a.u_expansion, b.u_expansion);
  EXPECT_EQ(a.reference_temperature, b.reference_temperature);
  EXPECT_EQ(a.certificate.number, b.certificate.number);
  EXPECT_EQ(a.certificate.laboratory, b.certificate.laboratory);
  EXPECT_EQ(a.certificate.date, b.certificate.date);
  EXPECT_EQ(a.certificate.valid_until, b.certificate.valid_until);
  ASSERT_EQ(a.features.size(), b.features.size());
  for (std::size_t i = 0; i < a.features.size(); ++i) {
    const CertifiedFeature& f = a.features[i];
    const CertifiedFeature& g = b.features[i];
    EXPECT_EQ(f.name, g.name);
    EXPECT_EQ(f.kind, g.kind);
    EXPECT_EQ(f.at, g.at) << f.name;
    EXPECT_EQ(f.u_at, g.u_at) << f.name;
    EXPECT_EQ(f.normal.has_value(), g.normal.has_value());
    if (f.normal && g.normal) {
      EXPECT_LT((*f.normal - *g.normal).norm(), 1e-15);
    }
    EXPECT_EQ(f.radius, g.radius);
    EXPECT_EQ(f.u_radius, g.u_radius);
    EXPECT_EQ(f.form, g.form);
    EXPECT_EQ(f.u_form, g.u_form);
    EXPECT_EQ(f.u, g.u);
  }
  ASSERT_EQ(a.distances.size(), b.distances.size());
  for (std::size_t i = 0; i < a.distances.size(); ++i) {
    EXPECT_EQ(a.distances[i].first, b.distances[i].first);
    EXPECT_EQ(a.distances[i].second, b.distances[i].second);
    EXPECT_EQ(a.distances[i].value, b.distances[i].value);
    EXPECT_EQ(a.distances[i].u, b.distances[i].u);
  }
}

TEST(ArtefactText, EveryExampleCertificateReadsBackAsItWas) {
  int read = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(ARTCAL_SOURCE_DIR) + "/examples/certificates")) {
    if (entry.path().extension() == ".toml") {
      SCOPED_TRACE(entry.path().filename().string());
      const auto file = read_artefact_file(entry.path());
      ASSERT_TRUE(file) << file.error().text();
      expect_same(file->artefact, read_back(file->artefact));
      ++read;
    }
  }
  EXPECT_GE(read, 10);
}

TEST(ArtefactText, NamesThatTryToBeMoreStayNames) {
  Artefact artefact;
  artefact.name = "a \"quoted\" \\ name = [1]";
  artefact.features.resize(1);
  artefact.features[0].name = "]] # \"";
  artefact.features[0].at = Eigen::Vector3d(0.1, 1.0 / 3.0, -1e-9);
  artefact.features[0].u_at = 1.0 / 3000.0;
  expect_same(artefact, read_back(artefact));
}

}  // namespace
}  // namespace artcal
