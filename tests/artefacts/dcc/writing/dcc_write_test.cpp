// What we write is valid against the schemas of DCC 3.3.0 and D-SI 2.2.1, by xmllint, and reads back as what it was.
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "artefacts/dcc/dcc_read.h"
#include "artefacts/dcc/writing/dcc_data_file.h"
#include "artefacts/dcc/writing/dcc_write.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::replaced;

DccDocument document() {
  DccDocument document;
  document.data = {"K-2026-017",
                   "DE",
                   "2026-03-10",
                   "2026-03-11",
                   "laboratory",
                   {"A. Person", "B. Person"},
                   {"Laboratory & Sons", "Street", "1", "01234", "Town", "DE", "a@example.org"},
                   {"Customer", "", "", "", "City", "AT", ""},
                   {"Arm", "Maker", "M1", "17"}};
  document.program_version = "1.2.3";
  document.statements = {"Identified from <script>alert(1)</script> & \"more\" ]]>"};
  document.methods = {{"Identification", "Least squares"}};
  document.results = {
      {"Parameters",
       "As identified",
       {{"a1", "artcal_parameter", "\\milli\\metre", 1.0 / 3.0, DccUncertainty{2e-7, 2.0, 0.95}, {}, ""},
        {"theta1", "artcal_parameter", "\\radian", -1.5e-300, DccUncertainty{1e-5, 2.0, {}}, {}, ""},
        {"d1", "", "\\milli\\metre", 300.0, {}, {}, ""}}},
      {"Errors",
       "",
       {{"E1", "", "\\micro\\metre", 12.0, {}, DccConformity::Pass, "MPE = 30 um, simple acceptance"},
        {"E2", "", "\\micro\\metre", 40.0, {}, DccConformity::Fail, "MPE = 30 um"},
        {"E3", "", "\\micro\\metre", 30.0, {}, DccConformity::NotShown, ""}}}};
  return document;
}

// Whether xmllint finds the file valid, and what it says if not.
bool is_valid(const std::filesystem::path& file) {
  const std::filesystem::path schemas =
      std::filesystem::path(ARTCAL_SOURCE_DIR) / "tests" / "reference" / "dcc" / "schema-3.3.0";
  const std::string command = "cd '" + schemas.string() +
                              "' && XML_CATALOG_FILES=catalog.xml xmllint --nonet --noout --schema " + "dcc.xsd '" +
                              file.string() + "' 2>&1";
  return std::system(command.c_str()) == 0;
}

TEST(DccWrite, IsValidAndReadsBackAsWhatItWas) {
  const testing::TemporaryFolder folder;
  const auto path = folder.write("c.xml", dcc_xml(document()));
  EXPECT_TRUE(is_valid(path));
  const auto certificate = read_dcc_file(path);
  ASSERT_TRUE(certificate) << certificate.error().text();
  EXPECT_EQ(certificate->certificate.number, "K-2026-017");
  EXPECT_EQ(certificate->certificate.laboratory, "Laboratory & Sons");
  EXPECT_EQ(certificate->certificate.date, "2026-03-11");
  EXPECT_EQ(certificate->item, "Arm");
  EXPECT_FALSE(certificate->is_signed);
  ASSERT_EQ(certificate->quantities.size(), 6u);
  EXPECT_EQ(certificate->quantities[0].numbers().values[0], 1.0 / 3.0) << "every digit";
  EXPECT_EQ(certificate->quantities[0].numbers().uncertainties[0].U, 2e-7);
  EXPECT_EQ(certificate->quantities[1].numbers().values[0], -1.5e-300);
  EXPECT_TRUE(certificate->quantities[2].numbers().uncertainties.empty());
}

// The test would notice: the same file with a date that is none, or an element out of place, is not valid.
TEST(DccWrite, TheSchemaIsReallyAsked) {
  const testing::TemporaryFolder folder;
  const std::string xml = dcc_xml(document());
  EXPECT_FALSE(is_valid(folder.write("d.xml", replaced(xml, "2026-03-11", "2026-02-31"))));
  EXPECT_FALSE(is_valid(folder.write("e.xml", replaced(xml, "<dcc:release>1.2.3</dcc:release>", ""))));
}

TEST(DccWrite, SaysThatItIsUnsigned) {
  EXPECT_THAT(dcc_xml(document()), HasSubstr("These are unsigned data, written by the program artcal. They are not a "
                                             "calibration certificate"));
}

TEST(DccWrite, EscapesWhatIsHostile) {
  DccDocument hostile = document();
  hostile.data.item.name = "<script>&\x1b[2J\x01 \"name\" \u202e]]>";
  hostile.data.number = "  17\n18 ";
  hostile.results[0].entries[0].ref_type = "a\" onload=\"x";
  const std::string xml = dcc_xml(hostile);
  EXPECT_THAT(xml, Not(HasSubstr("<script")));
  EXPECT_THAT(xml, HasSubstr("&lt;script&gt;&amp; [2J \"name\" ]]&gt;"));
  const testing::TemporaryFolder folder;
  const auto path = folder.write("c.xml", xml);
  EXPECT_TRUE(is_valid(path));
  EXPECT_EQ(read_dcc_file(path).value().certificate.number, "17 18");
}

constexpr std::string_view data =
    "schema = \"artcal-dcc-data/1\"\nnumber = \"K-17\"\ncountry = \"DE\"\nbegin = 2026-03-10\nend = 2026-03-11\n"
    "location = \"laboratory\"\nresponsible = [\"A. Person\"]\n"
    "[laboratory]\nname = \"L\"\ncity = \"Town\"\ncountry = \"DE\"\n"
    "[customer]\nname = \"C\"\ncity = \"City\"\ncountry = \"AT\"\ne_mail = \"c@example.org\"\n"
    "[item]\nname = \"Arm\"\nserial_number = \"17\"\n";

std::string refusal(const std::string& text) {
  const testing::TemporaryFolder folder;
  const auto read = read_dcc_data(folder.write("data.toml", text));
  return read ? "accepted" : read.error().text();
}

TEST(DccData, IsRead) {
  const testing::TemporaryFolder folder;
  const auto read = read_dcc_data(folder.write("data.toml", data));
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->data.number, "K-17");
  EXPECT_EQ(read->data.end, "2026-03-11");
  EXPECT_EQ(read->data.customer.country, "AT");
  EXPECT_EQ(read->data.item.serial_number, "17");
}

TEST(DccData, IsRefusedRatherThanMadeUp) {
  for (const char* line :
       {"number = \"K-17\"\n", "begin = 2026-03-10\n", "location = \"laboratory\"\n", "responsible = [\"A. Person\"]\n",
        "name = \"L\"\n", "city = \"City\"\n", "serial_number = \"17\"\n", "name = \"Arm\"\n"}) {
    EXPECT_NE(refusal(replaced(std::string(data), line, "")), "accepted") << line;
  }
  EXPECT_THAT(refusal(replaced(std::string(data), "\"K-17\"", "\" \"")), HasSubstr("`number` is empty"));
  EXPECT_THAT(refusal(replaced(std::string(data), "\"AT\"", "\"Austria\"")), HasSubstr("two capital letters"));
  EXPECT_THAT(refusal(replaced(std::string(data), "end = 2026-03-11", "end = 2026-03-09")),
              HasSubstr("before it begins"));
  EXPECT_THAT(refusal(replaced(std::string(data), "\"laboratory\"", "\"garage\"")),
              HasSubstr("`location` is \"garage\""));
  EXPECT_THAT(refusal(replaced(std::string(data), "\"A. Person\"", "")), HasSubstr("expected the responsible persons"));
}

}  // namespace
}  // namespace artcal
