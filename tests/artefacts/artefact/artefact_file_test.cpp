#include "artefacts/artefact/artefact_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files/hash.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;
using testing::replaced;
using ::testing::SizeIs;
using ::testing::StartsWith;

// A bar with two seats, one ball and a plate's two points; each test changes one thing of it.
constexpr std::string_view bar =
    "schema = \"artcal-artefact/1\"\n"
    "name = \"bar\"\n"
    "units = { length = \"mm\" }\n"
    "expansion_per_K = 11.5e-6\n"
    "reference_temperature_C = 22\n"
    "[[feature]]\nname = \"A\"\nkind = \"point\"\n"
    "[[feature]]\nname = \"B\"\nkind = \"point\"\n"
    "[[feature]]\nname = \"ball\"\nkind = \"sphere\"\ndiameter = 25.4\n"
    "[[feature]]\nname = \"P\"\nkind = \"point\"\nat = [0, 0, 0]\n"
    "[[feature]]\nname = \"Q\"\nkind = \"point\"\nat = [3, 4, 0]\n"
    "[[distance]]\nbetween = [\"A\", \"B\"]\nvalue = 500.1\nU = 0.002\nk = 2\n";

class ArtefactFileTest : public ::testing::Test {
 protected:
  Expected<ArtefactFile> read(std::string_view text) { return read_artefact_file(folder_.write("bar.toml", text)); }
  // The message from the file's name on.
  std::string refusal(std::string_view text) {
    const auto artefact = read(text);
    return artefact ? "accepted" : artefact.error().text().substr(folder_.path().string().size() + 1);
  }
  // The refusal of the bar with one of its texts replaced.
  std::string refusal(std::string_view from, std::string_view to) {
    return refusal(replaced(std::string(bar), from, to));
  }
  std::string refusal_with(std::string_view more) { return refusal(std::string(bar) + std::string(more)); }
  testing::TemporaryFolder folder_;
};

TEST_F(ArtefactFileTest, ReadsWhatACertificateSays) {
  const auto file = read(bar);
  ASSERT_TRUE(file) << file.error().text();
  const Artefact& artefact = file->artefact;
  EXPECT_EQ(file->input.sha256, sha256(bar));
  EXPECT_EQ(artefact.name, "bar");
  EXPECT_EQ(artefact.frame, CoordinateFrame::Artefact);
  ASSERT_THAT(artefact.features, SizeIs(5));
  EXPECT_EQ(artefact.features[2].kind, FeatureKind::Sphere);
  EXPECT_DOUBLE_EQ(artefact.features[2].radius.value(), 12.7);
  EXPECT_FALSE(artefact.features[0].at);
  EXPECT_EQ(artefact.features[4].at, Eigen::Vector3d(3, 4, 0));
  ASSERT_THAT(artefact.distances, SizeIs(1));
  EXPECT_EQ(artefact.distances[0].first, 0);
  EXPECT_EQ(artefact.distances[0].second, 1);
  EXPECT_EQ(artefact.distances[0].value, 500.1);
  EXPECT_EQ(artefact.distances[0].u, 0.001) << "U/k";
  EXPECT_TRUE(artefact.expansion_is_known);
  EXPECT_EQ(artefact.expansion, 11.5e-6);
  EXPECT_EQ(artefact.reference_temperature, 22.0);
}

TEST_F(ArtefactFileTest, TakesWhatIsNotSaidFromTheDefaults) {
  const auto file = read(
      "schema = \"artcal-artefact/1\"\nnote = \"found in a drawer\"\nunits = { length = \"mm\" }\n"
      "[[feature]]\nname = \"A\"\nkind = \"point\"\n");
  ASSERT_TRUE(file) << file.error().text();
  EXPECT_EQ(file->artefact.name, "bar") << "the file's own name";
  EXPECT_EQ(file->artefact.reference_temperature, 20.0);
  EXPECT_FALSE(file->artefact.expansion_is_known);
  EXPECT_EQ(file->artefact.expansion_factor(50.0), 1.0);
}

TEST_F(ArtefactFileTest, ConvertsEveryLengthFromItsUnit) {
  const auto file = read(
      "schema = \"artcal-artefact/1\"\nunits = { length = \"in\" }\nframe = \"base\"\n"
      "[[feature]]\nname = \"b\"\nkind = \"sphere\"\ndiameter = 1\nat = [1, 2, 3]\n"
      "[[feature]]\nname = \"c\"\nkind = \"sphere\"\ndiameter = 1\nat = [1, 2, 13]\n"
      "[[feature]]\nname = \"wire\"\nkind = \"anchor\"\nU = 0.01\nk = 4\n"
      "[[distance]]\nbetween = [\"b\", \"c\"]\nvalue = 10\nU = 0.02\nk = 2\n");
  ASSERT_TRUE(file) << file.error().text();
  const Artefact& artefact = file->artefact;
  EXPECT_EQ(artefact.frame, CoordinateFrame::Base);
  EXPECT_DOUBLE_EQ(artefact.features[0].radius.value(), 12.7);
  EXPECT_TRUE(artefact.features[0].at->isApprox(Eigen::Vector3d(25.4, 50.8, 76.2), 1e-15));
  EXPECT_DOUBLE_EQ(artefact.features[2].u, 0.0635);
  EXPECT_DOUBLE_EQ(artefact.distances[0].value, 254.0);
  EXPECT_DOUBLE_EQ(artefact.distances[0].u, 0.254);
}

TEST_F(ArtefactFileTest, RefusesTwoFeaturesOfOneName) {
  EXPECT_THAT(refusal("name = \"B\"", "name = \"A\""), StartsWith("bar.toml:6:"));
  EXPECT_THAT(refusal("name = \"B\"", "name = \"A\""), HasSubstr("two features are called \"A\""));
}

TEST_F(ArtefactFileTest, RefusesAFeatureWithoutAName) {
  EXPECT_THAT(refusal("name = \"B\"", "name = \"\""), StartsWith("bar.toml:10:8: the feature's name is empty"));
  EXPECT_THAT(refusal("name = \"B\"\n", ""), StartsWith("bar.toml:9:1: `name` is missing in [feature]"));
}

TEST_F(ArtefactFileTest, RefusesAnArtefactWithoutFeatures) {
  EXPECT_THAT(refusal("schema = \"artcal-artefact/1\"\nunits = { length = \"mm\" }\n"),
              HasSubstr("the artefact has no feature, expected at least one table headed [[feature]]"));
}

TEST_F(ArtefactFileTest, RefusesADistanceThatNamesAnUnknownFeature) {
  EXPECT_THAT(refusal("[\"A\", \"B\"]", "[\"A\", \"C\"]"),
              StartsWith("bar.toml:25:11: the distance names the feature \"C\", which the artefact does not have"));
}

TEST_F(ArtefactFileTest, RefusesADistanceThatIsNotBetweenTwoFeatures) {
  for (const char* between : {"[\"A\"]", "[\"A\", \"A\"]", "[\"A\", \"B\", \"P\"]", "[]"}) {
    EXPECT_THAT(refusal("[\"A\", \"B\"]", between), StartsWith("bar.toml:25:11: a distance lies between two features"))
        << between;
  }
  EXPECT_THAT(refusal("[\"A\", \"B\"]", "\"A\""), HasSubstr("`between` in [distance] is text"));
}

TEST_F(ArtefactFileTest, RefusesADistanceStatedTwice) {
  EXPECT_THAT(refusal_with("[[distance]]\nbetween = [\"B\", \"A\"]\nvalue = 500.2\nU = 0.002\nk = 2\n"),
              StartsWith("bar.toml:30:11: the distance between \"B\" and \"A\" is stated twice"));
}

TEST_F(ArtefactFileTest, RefusesADistanceThatContradictsTheCoordinates) {
  // P and Q are 5 mm apart; the bound is U, here 0.002 mm.
  const auto distance = [](const char* value) {
    return "[[distance]]\nbetween = [\"P\", \"Q\"]\nvalue = " + std::string(value) + "\nU = 0.002\nk = 2\n";
  };
  EXPECT_EQ(refusal_with(distance("5.0019")), "accepted");
  EXPECT_EQ(refusal_with(distance("4.9981")), "accepted");
  EXPECT_THAT(refusal_with(distance("5.0021")), StartsWith("bar.toml:31:9: the certified distance between \"P\" and "));
  EXPECT_THAT(refusal_with(distance("4.9979")), HasSubstr("is 4.9979 mm, but their certified coordinates are 5 mm"));
}

TEST_F(ArtefactFileTest, RefusesADistanceThatIsHalfKnown) {
  EXPECT_THAT(refusal("[\"A\", \"B\"]", "[\"A\", \"Q\"]"),
              StartsWith("bar.toml:25:11: of the features \"A\" and \"Q\" only one has certified coordinates"));
}

TEST_F(ArtefactFileTest, RefusesADistanceToReadingsThatBringTheirCoordinates) {
  EXPECT_THAT(refusal("name = \"B\"\nkind = \"point\"", "name = \"B\"\nkind = \"coordinates\""),
              HasSubstr("a feature of the kind \"coordinates\" is no single point"));
}

TEST_F(ArtefactFileTest, RefusesAnUncertaintyOfZero) {
  for (const char* u : {"0", "0.0", "-0.002"}) {
    EXPECT_THAT(refusal("U = 0.002", "U = " + std::string(u)),
                StartsWith("bar.toml:27:5: an uncertainty of zero or less is not one: state U and k"))
        << u;
  }
  EXPECT_THAT(refusal("k = 2", "k = 0"), HasSubstr("an uncertainty of zero or less"));
}

TEST_F(ArtefactFileTest, RefusesADistanceWithoutItsUncertainty) {
  EXPECT_THAT(refusal("k = 2\n", ""), StartsWith("bar.toml:24:1: `k` is missing in [distance]"));
  EXPECT_THAT(refusal("U = 0.002\n", ""), StartsWith("bar.toml:24:1: `U` is missing in [distance]"));
  EXPECT_THAT(refusal("value = 500.1\n", ""), StartsWith("bar.toml:24:1: `value` is missing in [distance]"));
}

TEST_F(ArtefactFileTest, RefusesLengthsThatAreNone) {
  EXPECT_THAT(refusal("value = 500.1", "value = -500.1"),
              StartsWith("bar.toml:26:9: a certified distance is not above zero"));
  EXPECT_THAT(refusal("diameter = 25.4", "diameter = 0"), HasSubstr("the diameter of a sphere is not above zero"));
  EXPECT_THAT(refusal("diameter = 25.4\n", ""), HasSubstr("`diameter` is missing in [feature]"));
  EXPECT_THAT(refusal("at = [0, 0, 0]", "at = [0, 0]"), HasSubstr("`at` holds 2 numbers, expected x, y and z"));
}

TEST_F(ArtefactFileTest, RefusesLengthsThatAreInAnotherUnit) {
  EXPECT_THAT(refusal("length = \"mm\"", "length = \"m\""), HasSubstr("is it in the wrong unit?"));
  EXPECT_THAT(refusal("value = 500.1", "value = 500100"),
              HasSubstr("a certified distance of 500100 mm; is it in the wrong"));
  EXPECT_THAT(refusal("at = [3, 4, 0]", "at = [3, 1e99, 1e99]"),
              HasSubstr("mm from the origin; is it in the wrong unit?"));
  EXPECT_THAT(refusal("diameter = 25.4", "diameter = 1e99"), HasSubstr("a ball of 1e+99 mm; is it in the wrong unit?"));
}

TEST_F(ArtefactFileTest, RefusesWordsItDoesNotKnow) {
  EXPECT_THAT(refusal("kind = \"sphere\"", "kind = \"ball\""),
              StartsWith("bar.toml:14:8: the feature's kind is \"ball\", expected \"point\", \"sphere\""));
  EXPECT_THAT(refusal("name = \"bar\"", "frame = \"world\""), HasSubstr("frame is \"world\", expected \"artefact\""));
  EXPECT_THAT(refusal("length = \"mm\"", "length = \"ft\""), HasSubstr("\"ft\" is not a unit known for `length`"));
  EXPECT_THAT(refusal("artefact/1", "artefact/2"), HasSubstr("expected \"artcal-artefact/1\""));
}

TEST_F(ArtefactFileTest, RefusesKeysItDoesNotKnow) {
  EXPECT_THAT(refusal("diameter = 25.4", "diameter = 25.4\ncolour = 3"),
              StartsWith("bar.toml:16:1: \"colour\" is not a key that is known here"));
  EXPECT_THAT(refusal("value = 500.1", "value = 500.1\nvalu = 3"), HasSubstr("\"valu\" is not a key"));
  // A seat's U has no use: saying nothing would let the reader believe that it counts.
  EXPECT_THAT(refusal("name = \"B\"\n", "name = \"B\"\nU = 0.1\nk = 2\n"),
              HasSubstr("is not a key that is known here"));
}

TEST_F(ArtefactFileTest, RefusesAPlaceOfItsOwnWhereEachReadingBringsOne) {
  EXPECT_THAT(refusal("kind = \"point\"\nat = [0, 0, 0]", "kind = \"coordinates\"\nat = [0, 0, 0]"),
              HasSubstr("gets its place from each reading (ref_x, ref_y, ref_z)"));
}

TEST_F(ArtefactFileTest, RefusesAnExpansionThatIsNoSolids) {
  EXPECT_THAT(refusal("11.5e-6", "11.5"), HasSubstr("an expansion of 11.5 per kelvin is no solid's; steel is 11.5e-6"));
  EXPECT_EQ(refusal("11.5e-6", "-0.1e-6"), "accepted") << "some glasses shrink";
}

TEST_F(ArtefactFileTest, RefusesNamesThatATerminalWouldObey) {
  EXPECT_THAT(refusal("name = \"bar\"", "name = \"bar\\nWarning: none\""),
              StartsWith("bar.toml:2:8: `name` is \"bar?Warning: none\", which holds a line end"));
  EXPECT_THAT(refusal("name = \"B\"", "name = \"\\u001b[2J\""), HasSubstr("another control character"));
  EXPECT_EQ(refusal("name = \"bar\"", "note = \"two\\nlines\""), "accepted") << "a note is never shown";
}

TEST_F(ArtefactFileTest, ReadsWhatItIsAndIsMadeOf) {
  const auto file = read(
      "schema = \"artcal-artefact/1\"\ntype = \"plane\"\nunits = { length = \"mm\" }\nmaterial = \"granite\"\n"
      "supports = \"three feet\"\n[[feature]]\nname = \"top\"\nkind = \"plane\"\nform = 0.003\nU_form = \"1 um\"\nk = "
      "2\n"
      "[[feature]]\nname = \"side\"\nkind = \"plane\"\nat = [1, 2, 3]\nnormal = [0, -3, 4]\n");
  ASSERT_TRUE(file) << file.error().text();
  EXPECT_EQ(file->artefact.type, ArtefactType::Plane);
  EXPECT_EQ(file->artefact.material, "granite");
  EXPECT_EQ(file->artefact.supports, "three feet");
  EXPECT_EQ(file->artefact.features[0].form, 0.003);
  EXPECT_DOUBLE_EQ(file->artefact.features[0].u_form, 0.0005);
  EXPECT_FALSE(file->artefact.features[0].normal);
  EXPECT_TRUE(file->artefact.features[1].normal->isApprox(Eigen::Vector3d(0.0, -0.6, 0.8), 1e-15)) << "a unit vector";
}

TEST_F(ArtefactFileTest, WantsAnUnknownDiameterSaid) {
  const auto file = read(replaced(std::string(bar), "diameter = 25.4", "diameter = \"unknown\""));
  ASSERT_TRUE(file) << file.error().text();
  EXPECT_FALSE(file->artefact.features[2].radius);
  EXPECT_THAT(refusal("diameter = 25.4", "diameter = \"?\""), HasSubstr("`diameter` is \"?\", expected a number, or"));
  EXPECT_THAT(refusal("diameter = 25.4", "diameter = \"unknown\"\nU_diameter = 1\nk = 2"),
              HasSubstr("a diameter that is unknown has no uncertainty"));
}

TEST_F(ArtefactFileTest, RefusesPlanesThatAreHalfKnown) {
  const auto plane = [&](const std::string& more) {
    return refusal_with("[[feature]]\nname = \"face\"\nkind = \"plane\"\n" + more);
  };
  EXPECT_EQ(plane(""), "accepted");
  EXPECT_THAT(plane("at = [0, 0, 9]\n"),
              HasSubstr("has `at`, one of its points, and `normal`; state both, or neither"));
  EXPECT_THAT(plane("normal = [0, 0, 1]\n"), HasSubstr("state both, or neither"));
  EXPECT_THAT(plane("at = [0, 0, 9]\nnormal = [0, 0, 0]\n"), HasSubstr("the normal has no direction"));
  EXPECT_THAT(plane("diameter = 3\n"), HasSubstr("\"diameter\" is not a key that is known here"));
  EXPECT_THAT(plane("[[distance]]\nbetween = [\"A\", \"face\"]\nvalue = 3\nU = 0.001\nk = 2\n"),
              HasSubstr("one is a plane; a distance lies between two planes"));
}

TEST_F(ArtefactFileTest, RefusesUncertaintiesOfWhatIsNotThere) {
  EXPECT_THAT(refusal("name = \"B\"\n", "name = \"B\"\nU_at = 0.1\nk = 2\n"), HasSubstr("but the feature has no `at`"));
  EXPECT_THAT(refusal("diameter = 25.4", "diameter = 25.4\nU_form = 0.1\nk = 2"),
              HasSubstr("but the feature has no `form`"));
  EXPECT_THAT(refusal("diameter = 25.4", "diameter = 25.4\nform = -0.1"), HasSubstr("not below zero"));
}

TEST_F(ArtefactFileTest, RefusesTypesAndTheirContradictions) {
  EXPECT_THAT(refusal("name = \"bar\"", "type = \"bal bar\""),
              StartsWith("bar.toml:2:8: the type is \"bal bar\", expected one of \"ball bar\", "));
  EXPECT_THAT(refusal("name = \"bar\"", "type = \"sphere plate\""), StartsWith("accepted"));
  EXPECT_THAT(
      refusal("name = \"bar\"", "type = \"seat plate\""),
      StartsWith("bar.toml:14:8: the artefact is a seat plate, which has points, but the feature \"ball\" is none"));
}

TEST_F(ArtefactFileTest, RefusesMoreThanItReads) {
  std::string many = "schema = \"artcal-artefact/1\"\nunits = { length = \"mm\" }\n";
  for (int i = 0; i < 1001; ++i) {
    many += fmt::format("[[feature]]\nname = \"{}\"\nkind = \"point\"\n", i);
  }
  EXPECT_THAT(refusal(many), HasSubstr("1001 tables [[feature]], more than the 1000 that are read"));
  EXPECT_THAT(refusal(std::string(bar) + "#" + std::string((std::size_t{16} << 20), 'x')), HasSubstr("split it"));
}

TEST_F(ArtefactFileTest, ShowsHostileNamesHarmlessly) {
  const std::string hostile = "\\u001b[2J" + std::string(5000, 'x');
  const std::string message = refusal("[\"A\", \"B\"]", "[\"A\", \"" + hostile + "\"]");
  EXPECT_LT(message.size(), 200u);
  EXPECT_EQ(message.find('\x1b'), std::string::npos);
}

TEST_F(ArtefactFileTest, RefusesWhatIsNoFile) {
  const auto missing = read_artefact_file(folder_.path() / "none.toml");
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().text(), HasSubstr("none.toml: there is no such file"));
  EXPECT_THAT(refusal("name = \"bar\n"), HasSubstr("this is not valid TOML"));
}

}  // namespace
}  // namespace artcal
