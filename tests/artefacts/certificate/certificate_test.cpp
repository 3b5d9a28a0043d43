#include "artefacts/certificate/certificate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "acquisition/recording/recording_file.h"
#include "artefacts/artefact/artefact_file.h"
#include "artefacts/constraints/bound_recording.h"
#include "artefacts/constraints/document_warnings.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

std::string bar(const std::string& certificate) {
  return "schema = \"artcal-artefact/1\"\nname = \"bar\"\nunits = { length = \"mm\" }\n[certificate]\n" + certificate +
         "\n[[feature]]\nname = \"A\"\nkind = \"point\"\n[[feature]]\nname = \"B\"\nkind = \"point\"\n"
         "[[feature]]\nname = \"C\"\nkind = \"point\"\n";
}

class CertificateTest : public ::testing::Test {
 protected:
  std::string refusal(const std::string& certificate) {
    const auto file = read_artefact_file(folder_.write("bar.toml", bar(certificate)));
    return file ? "accepted" : file.error().text().substr(folder_.path().string().size() + 1);
  }
  // The warnings that reach a result, for a recording with such a line.
  std::vector<std::string> warnings(const std::string& certificate, const std::string& date_line) {
    (void)folder_.write("bar.toml", bar(certificate));
    testing::ExampleRecording example;
    example.recording = date_line + "artefacts = [\"bar.toml\"]\n" + example.recording;
    auto recording = read_recording(example.write(folder_));
    EXPECT_TRUE(recording) << recording.error().text();
    const auto bound = bind_recording(std::move(*recording));
    EXPECT_TRUE(bound) << bound.error().text();
    return texts_of(document_warnings(bound->recording, bound->constraints.artefacts));
  }
  testing::TemporaryFolder folder_;
};

TEST_F(CertificateTest, IsReadWithDatesBareOrInQuotes) {
  const auto file = read_artefact_file(folder_.write(
      "bar.toml",
      bar("number = \"4711\"\nlaboratory = \"Laboratory <b>\"\ndate = \"2026-03-02\"\nvalid_until = 2028-02-29")));
  ASSERT_TRUE(file) << file.error().text();
  EXPECT_EQ(file->artefact.certificate.number, "4711");
  EXPECT_EQ(file->artefact.certificate.laboratory, "Laboratory <b>");
  EXPECT_EQ(file->artefact.certificate.date, "2026-03-02");
  EXPECT_EQ(file->artefact.certificate.valid_until, "2028-02-29");
}

TEST_F(CertificateTest, RefusesDaysThatTheCalendarDoesNotHave) {
  EXPECT_THAT(refusal("date = \"2026-02-31\""), StartsWith("bar.toml:5:8: `date` is \"2026-02-31\", expected a day"));
  EXPECT_THAT(refusal("date = 2026-02-31"), HasSubstr("this is not valid TOML"));
  for (const char* date :
       {"2026-2-3", "02.03.2026", "2026-13-01", "2027-02-29", "1066-10-14", "", "2026-03-02T10:00"}) {
    EXPECT_THAT(refusal("date = \"" + std::string(date) + "\""), HasSubstr("expected a day of the calendar")) << date;
  }
  EXPECT_THAT(refusal("date = 20260302"), HasSubstr("is a number, expected a date such as 2026-03-02"));
}

TEST_F(CertificateTest, RefusesAnEndBeforeTheBeginning) {
  EXPECT_THAT(refusal("date = 2026-03-02\nvalid_until = 2026-03-01"),
              StartsWith("bar.toml:6:15: the certificate is valid until 2026-03-01, which is before"));
}

TEST_F(CertificateTest, RefusesNamesThatATerminalWouldObey) {
  EXPECT_THAT(refusal("laboratory = \"\\u001b[2J\""), HasSubstr("another control character"));
}

TEST_F(CertificateTest, ThatLapsedBeforeTheReadingsIsWarnedOf) {
  const std::string lapsed = "number = \"4711\"\nvalid_until = 2026-03-09";
  EXPECT_THAT(
      warnings(lapsed, "date = 2026-03-10\n"),
      ElementsAre("the certificate \"4711\" of the artefact \"bar\" had lapsed: it was valid until 2026-03-09, the "
                  "readings are of 2026-03-10"));
  EXPECT_THAT(warnings(lapsed, "date = 2026-03-09\n"), IsEmpty()) << "the last day counts";
  EXPECT_THAT(warnings(lapsed, ""), IsEmpty()) << "the day is not known";
}

TEST_F(CertificateTest, OfAfterTheReadingsIsWarnedOf) {
  EXPECT_THAT(warnings("date = 2026-03-11", "date = 2026-03-10\n"),
              ElementsAre(HasSubstr("was calibrated on 2026-03-11")));
}

}  // namespace
}  // namespace artcal
