// Artefacts whose numbers stand in a digital certificate.
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefacts/artefact/artefact_file.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using testing::replaced;
using ::testing::StartsWith;

const std::filesystem::path folder = std::filesystem::path(ARTCAL_SOURCE_DIR) / "examples" / "certificates";

std::string content(const std::string& name) {
  std::ostringstream text;
  text << std::ifstream(folder / name).rdbuf();
  return text.str();
}

TEST(DccArtefact, IsTheSameFromBothGenerations) {
  for (const char* name : {"ball-bar-dcc-2.4.0.toml", "ball-bar-dcc-3.3.0.toml"}) {
    const auto file = read_artefact_file(folder / name);
    ASSERT_TRUE(file) << file.error().text();
    const Artefact& bar = file->artefact;
    EXPECT_EQ(bar.certificate.number, "EX-2026-0109");
    EXPECT_EQ(bar.certificate.laboratory, "Example Laboratory (made up)");
    EXPECT_EQ(bar.certificate.date, "2026-03-02");
    EXPECT_EQ(bar.certificate.valid_until, "2028-03-01");
    ASSERT_EQ(bar.features.size(), 3u);
    EXPECT_DOUBLE_EQ(bar.features[0].radius.value(), 25.40012 / 2.0);
    EXPECT_DOUBLE_EQ(bar.features[0].u_radius, 0.0003 / 4.0);
    ASSERT_EQ(bar.distances.size(), 3u);
    EXPECT_DOUBLE_EQ(bar.distances[0].value, 499.9981) << "in metres";
    EXPECT_DOUBLE_EQ(bar.distances[0].u, 0.00025);
    EXPECT_DOUBLE_EQ(bar.distances[1].u, 0.0003);
    EXPECT_DOUBLE_EQ(bar.distances[2].value, 1000.0013) << "in micrometres";
    EXPECT_DOUBLE_EQ(bar.distances[2].u, 0.0004);
    ASSERT_TRUE(file->certificate) << "a result rests on it too";
    EXPECT_EQ(file->certificate->sha256.size(), 64u);
  }
}

class DccArtefactTest : public ::testing::Test {
 protected:
  DccArtefactTest() { (void)folder_.write("ball-bar-dcc-3.3.0.xml", content("ball-bar-dcc-3.3.0.xml")); }
  std::string refusal(std::string_view from, std::string_view to) {
    const auto file =
        read_artefact_file(folder_.write("bar.toml", replaced(content("ball-bar-dcc-3.3.0.toml"), from, to)));
    return file ? "accepted" : file.error().text().substr(folder_.path().string().size() + 1);
  }
  testing::TemporaryFolder folder_;
};

TEST_F(DccArtefactTest, SaysWhichQuantityIsNotThere) {
  EXPECT_THAT(refusal("\"diameter B\"", "\"diameter D\""),
              AllOf(StartsWith("bar.toml:"), HasSubstr("has no quantity \"diameter D\"; it has: "),
                    HasSubstr("Spheres/diameter A = 25.40012 \\milli\\metre")));
  EXPECT_THAT(refusal("\"steps\"", "\"length_centreDistance\""), HasSubstr("2 quantities of the certificate"));
}

TEST_F(DccArtefactTest, RefusesAnUncertaintyBesideTheCertificates) {
  EXPECT_THAT(refusal("dcc = \"diameter B\" }", "dcc = \"diameter B\" }\nU_diameter = 1\nk = 2"),
              HasSubstr("`U_diameter` is stated here, and the digital certificate has it"));
}

TEST_F(DccArtefactTest, ChoosesOneNumberOfAList) {
  const std::string from = "value = { dcc = \"Centre distances at 20 °C/first to last\" }";
  EXPECT_THAT(refusal(from, "value = { dcc = \"steps\" }"), HasSubstr("holds 2 numbers, expected one"));
  EXPECT_THAT(refusal(from, "value = { dcc = \"steps\", item = 3 }"),
              HasSubstr("item is 3, expected a number from 1 to 2"));
  EXPECT_THAT(refusal(from, "value = { dcc = \"steps\", item = 2 }"), "accepted") << "a bar that is bent";
}

TEST_F(DccArtefactTest, RefusesOtherQuantitiesThanLengths) {
  const std::string grams = replaced(content("ball-bar-dcc-3.3.0.xml"), "\\micro\\metre", "\\micro\\gram");
  (void)folder_.write("ball-bar-dcc-3.3.0.xml", grams);
  EXPECT_THAT(refusal("\"ball bar of three\"", "\"b\""),
              HasSubstr("is in \"\\micro\\gram\", which is no unit of length"));
}

TEST_F(DccArtefactTest, RefusesUncertaintiesOfZeroInTheCertificate) {
  (void)folder_.write("ball-bar-dcc-3.3.0.xml", replaced(content("ball-bar-dcc-3.3.0.xml"), ">0.8<", ">0<"));
  EXPECT_THAT(refusal("\"ball bar of three\"", "\"b\""), HasSubstr("has U = 0 mm and k = 2"));
}

TEST_F(DccArtefactTest, RefusesAnotherCertificatesNumberOrDate) {
  EXPECT_THAT(refusal("valid_until", "number = \"other\"\nvalid_until"),
              HasSubstr("`number` is \"other\", but the digital certificate says \"EX-2026-0109\""));
  EXPECT_THAT(refusal("valid_until", "date = 2026-03-03\nvalid_until"), HasSubstr("but the digital certificate says"));
}

TEST_F(DccArtefactTest, WantsTheCertificateNamed) {
  EXPECT_THAT(refusal("dcc = \"ball-bar-dcc-3.3.0.xml\"\n", ""),
              HasSubstr("the file names no digital certificate; write dcc"));
  EXPECT_THAT(refusal("dcc = \"ball-bar-dcc-3.3.0.xml\"", "dcc = \"none.xml\""),
              HasSubstr("none.xml: there is no such file"));
}

TEST_F(DccArtefactTest, SaysWhatToWriteWhereACertificateStandsForAnArtefact) {
  const auto file = read_artefact_file(folder_.path() / "ball-bar-dcc-3.3.0.xml");
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().text(), AllOf(HasSubstr("write an artefact file with dcc = \"ball-bar-dcc-3.3.0.xml\""),
                                         HasSubstr("Spheres/diameter A")));
}

}  // namespace
}  // namespace artcal
