#include "core/toml/toml_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace artcal {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

Expected<TomlDocument> parse(const std::string& body) {
  return TomlDocument::parse(TextFile{"f.toml", "schema = \"test/1\"\n" + body, ""}, "test/1");
}

// What finish() says after `use` has read from the root.
template <typename Use>
std::string verdict(const std::string& body, Use use) {
  auto document = parse(body);
  if (!document) {
    return document.error().text();
  }
  use(document->root());
  const auto finished = document->finish();
  return finished ? "fine" : finished.error().text();
}

std::string verdict(const std::string& body) {
  return verdict(body, [](TomlTable&) {});
}

TEST(TomlDocument, ReadsEveryKind) {
  auto document = parse(
      "text = \"µ\"\nwhole = 3\nreal = -2.5e-3\ntruth = true\nrow = [1, 2.5]\nnames = [\"a\", \"b\"]\n"
      "square = [[1, 2], [3, 4]]\n[inner]\nx = 1\n[[many]]\ny = 1\n[[many]]\ny = 2\n");
  ASSERT_TRUE(document);
  TomlTable& root = document->root();
  EXPECT_EQ(root.text("text"), "µ");
  EXPECT_EQ(root.number("whole"), 3.0);
  EXPECT_EQ(root.number("real"), -2.5e-3);
  EXPECT_TRUE(root.truth_or("truth", false));
  EXPECT_THAT(root.numbers("row"), ElementsAre(1.0, 2.5));
  EXPECT_THAT(root.texts("names"), ElementsAre("a", "b"));
  EXPECT_THAT(root.rows("square"), ElementsAre(ElementsAre(1.0, 2.0), ElementsAre(3.0, 4.0)));
  EXPECT_EQ(root.table("inner").number("x"), 1.0);
  auto many = root.tables("many");
  ASSERT_THAT(many, SizeIs(2));
  EXPECT_EQ(many[0].number("y"), 1.0);
  EXPECT_EQ(many[1].number("y"), 2.0);
  EXPECT_TRUE(document->finish()) << document->finish().error().text();
}

TEST(TomlDocument, AbsentKeysGiveTheirFallback) {
  auto document = parse("");
  TomlTable& root = document->root();
  EXPECT_EQ(root.text_or("t", "x"), "x");
  EXPECT_EQ(root.number_or("n", 2.0), 2.0);
  EXPECT_FALSE(root.optional_number("n"));
  EXPECT_TRUE(root.truth_or("b", true));
  EXPECT_THAT(root.texts("list"), IsEmpty());
  EXPECT_THAT(root.rows("list"), IsEmpty());
  EXPECT_THAT(root.tables("list"), IsEmpty());
  EXPECT_FALSE(root.table("inner").has("x"));
  EXPECT_TRUE(document->finish());
}

TEST(TomlDocument, WrongKindsAreNamedWithTheirPlace) {
  EXPECT_EQ(verdict("n = \"1\"", [](TomlTable& t) { t.number("n"); }),
            "f.toml:2:5: `n` is text, expected a finite number");
  EXPECT_EQ(verdict("t = 1", [](TomlTable& t) { t.text("t"); }),
            "f.toml:2:5: `t` is a number, expected text in quotes");
  EXPECT_EQ(verdict("b = 1", [](TomlTable& t) { t.truth_or("b", false); }),
            "f.toml:2:5: `b` is a number, expected true or false");
  EXPECT_EQ(verdict("x = 1979-05-27", [](TomlTable& t) { t.number("x"); }),
            "f.toml:2:5: `x` is a date or time, expected a finite number");
  EXPECT_THAT(verdict("a = 1", [](TomlTable& t) { t.numbers("a"); }), HasSubstr("expected an array of numbers"));
  EXPECT_THAT(verdict("a = [1, \"2\"]", [](TomlTable& t) { t.numbers("a"); }), HasSubstr("finite numbers and nothing"));
  EXPECT_THAT(verdict("a = \"x\"", [](TomlTable& t) { t.texts("a"); }), HasSubstr("an array of texts"));
  EXPECT_THAT(verdict("a = [\"x\", 1]", [](TomlTable& t) { t.texts("a"); }), HasSubstr("an array of texts"));
  EXPECT_THAT(verdict("a = [1]", [](TomlTable& t) { t.rows("a"); }), HasSubstr("an array of arrays"));
  EXPECT_THAT(verdict("a = [[1], [\"x\"]]", [](TomlTable& t) { t.rows("a"); }), HasSubstr("an array of arrays"));
  EXPECT_THAT(verdict("a = 1", [](TomlTable& t) { t.table("a"); }), HasSubstr("expected a table"));
  EXPECT_THAT(verdict("a = [1]", [](TomlTable& t) { t.tables("a"); }), HasSubstr("[[a]]"));
  EXPECT_THAT(verdict("[a]\nx = 1", [](TomlTable& t) { t.tables("a"); }), HasSubstr("[[a]]"));
}

// In m it would be infinite in mm, and an arm of that size is written with NaN for its lengths.
TEST(TomlDocument, WhatLeavesTheRangeOfADoubleWithItsUnitIsRefused) {
  EXPECT_THAT(verdict("d = 0.61e308", [](TomlTable& t) { t.number("d"); }), HasSubstr("a number of at most 1e100"));
  EXPECT_NE(verdict("d = [1e101]", [](TomlTable& t) { t.numbers("d"); }), "fine");
  EXPECT_EQ(verdict("d = -1e99", [](TomlTable& t) { t.number("d"); }), "fine");
}

TEST(TomlDocument, NanAndInfinityAreRefused) {
  for (const char* value : {"nan", "inf", "-inf"}) {
    EXPECT_THAT(verdict(std::string("n = ") + value, [](TomlTable& t) { t.number("n"); }),
                HasSubstr("a finite number"));
    EXPECT_NE(verdict(std::string("n = [") + value + "]", [](TomlTable& t) { t.numbers("n"); }), "fine");
    EXPECT_NE(verdict(std::string("n = [[") + value + "]]", [](TomlTable& t) { t.rows("n"); }), "fine");
  }
}

TEST(TomlDocument, MissingKeysSayInWhichTable) {
  EXPECT_THAT(verdict("", [](TomlTable& t) { t.number("n"); }), HasSubstr("`n` is missing, expected a finite number"));
  EXPECT_THAT(verdict("[inner]\nx = 1", [](TomlTable& t) { t.table("inner").number("n"); }),
              HasSubstr("`n` is missing in [inner]"));
  EXPECT_THAT(verdict("", [](TomlTable& t) { t.table("inner").number("n"); }), HasSubstr("`n` is missing in [inner]"));
}

TEST(TomlDocument, AnUnknownTableIsNamedWithWhatItCouldHaveBeen) {
  const auto reader = [](TomlTable& t) {
    t.number_or("seed", 1.0);
    if (t.tables("placement").empty()) {
      t.fail("placement", "the artefacts stand nowhere");
    }
  };
  const std::string wrong = verdict("[[placements]]\nx = 1", reader);
  EXPECT_THAT(wrong,
              StartsWith("f.toml:2:3: \"placements\" is not a key that is known here (of the table [[placements]])"));
  EXPECT_THAT(wrong, HasSubstr("The nearest that is known is \"placement\". There could be: \"seed\", \"placement\""));
  EXPECT_THAT(verdict("[other]\nx = 1", reader), HasSubstr("stand nowhere")) << "nothing like it was looked for";
}

TEST(TomlDocument, ForeignFilesAreNamedForWhatTheyAre) {
  for (const auto& [text, kind] : {std::pair("a,b,c\n1,2,3\n", "a table of values (CSV)"),
                                   {"<?xml version=\"1.0\"?>\n<robot name=\"r\"/>", "(URDF)"},
                                   {"<html></html>", "XML or HTML"},
                                   {"{\"kind\": 1}", "JSON"},
                                   {"what is this", "not valid TOML"}}) {
    const auto parsed = TomlDocument::parse({"f", text, ""}, "artcal-recording/1");
    ASSERT_FALSE(parsed);
    EXPECT_THAT(parsed.error().message, HasSubstr(kind));
    EXPECT_THAT(parsed.error().message, HasSubstr("schema = \"artcal-recording/1\""));
  }
  const auto comma = TomlDocument::parse({"f", "schema = \"artcal-arm/1\"\nd = 3,5\n", ""}, "artcal-arm/1");
  EXPECT_THAT(comma.error().message, HasSubstr("decimal comma? Write \"3,5\" with a point: 3.5"));
}

TEST(TomlDocument, UnknownKeysAreRefusedWhereverTheyStand) {
  EXPECT_THAT(verdict("nmae = 1"), StartsWith("f.toml:2:1: \"nmae\" is not a key that is known here"));
  EXPECT_THAT(verdict("[a]\nb = 1", [](TomlTable& t) { t.table("a"); }), HasSubstr("f.toml:3:1: \"b\""));
  EXPECT_THAT(verdict("[[a]]\nb = 1\n[[a]]\nc = 1",
                      [](TomlTable& t) {
                        for (auto& row : t.tables("a")) {
                          row.number_or("b", 0.0);
                        }
                      }),
              HasSubstr("f.toml:5:1: \"c\""));
}

TEST(TomlDocument, TheFirstErrorStands) {
  EXPECT_THAT(verdict("a = 1\nb = 2\nunknown = 3",
                      [](TomlTable& t) {
                        t.text("b");
                        t.text("a");
                      }),
              HasSubstr("`b`"));
}

TEST(TomlDocument, SchemaIsChecked) {
  const auto without = TomlDocument::parse(TextFile{"f.toml", "a = 1", ""}, "test/1");
  ASSERT_FALSE(without);
  EXPECT_THAT(without.error().text(), HasSubstr("write schema = \"test/1\""));
  const auto other = TomlDocument::parse(TextFile{"f.toml", "schema = \"other/1\"", ""}, "test/1");
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().text(), "f.toml:1:10: schema is \"other/1\", expected \"test/1\"");
  EXPECT_FALSE(TomlDocument::parse(TextFile{"f.toml", "schema = 1", ""}, "test/1"));
}

TEST(TomlDocument, SyntaxErrorsNameLineAndColumn) {
  EXPECT_THAT(verdict("a = 1\nb = \n"), StartsWith("f.toml:3:"));
  EXPECT_THAT(verdict("a = 1\na = 2\n"), HasSubstr("not valid TOML"));
  EXPECT_THAT(verdict("a = \"open\n"), HasSubstr("not valid TOML"));
  EXPECT_THAT(verdict("a = \"\x01\"\n"), HasSubstr("not valid TOML"));
}

TEST(TomlDocument, WindowsLineEndsMakeNoDifference) {
  EXPECT_EQ(verdict("a = 1\r\nb = 2\r\n",
                    [](TomlTable& t) {
                      EXPECT_EQ(t.number("a"), 1.0);
                      EXPECT_EQ(t.number("b"), 2.0);
                    }),
            "fine");
}

// Whoever writes such a file wants a crash; a refusal is all it gets.
TEST(TomlDocument, HostileNestingIsRefused) {
  constexpr int deep = 50'000;
  EXPECT_NE(verdict("a = " + std::string(deep, '[') + std::string(deep, ']')), "fine");
  std::string tables;
  std::string dotted = "a";
  for (int i = 0; i < deep; ++i) {
    tables += "{a=";
    dotted += ".a";
  }
  EXPECT_NE(verdict("a = " + tables + "1" + std::string(deep, '}')), "fine");
  EXPECT_NE(verdict(dotted + " = 1"), "fine");
  EXPECT_NE(verdict("[" + dotted + "]"), "fine");
  EXPECT_NE(verdict("[[" + dotted + "]]"), "fine");
  EXPECT_EQ(verdict("x = 1\n" + dotted + " = 1"), "f.toml:3: a key has more parts than any that is known here");
  // Behind what looks like an open string and is none.
  for (const char* before :
       {R"(b = """x"""")", R"(b = '''x''''')", R"(b = "\"")", R"(b = '\')", R"(b.''.c = "'")", R"(b = 1 # ")"}) {
    EXPECT_THAT(verdict(std::string(before) + "\n" + dotted + " = 1"), HasSubstr("f.toml:3: a key has more parts"));
    EXPECT_NE(verdict("c = { " + std::string(before) + ", " + dotted + " = 1 }"), "fine");
  }
}

// Keys that are just short enough, nested as deep as the parser goes.
TEST(TomlDocument, TheDeepestFileDoesNotOverflowTheStack) {
  std::string key = "a";
  for (int i = 1; i < 32; ++i) {
    key += ".a";
  }
  for (const int depth : {10, 100, 127, 128, 200, 255, 256, 1000}) {
    std::string arrays;
    std::string tables;
    std::string closing;
    for (int i = 0; i < depth; ++i) {
      arrays += key + " = [{";
      tables += key + " = {";
      closing += "}]";
    }
    EXPECT_NE(verdict(arrays + closing), "fine");
    EXPECT_NE(verdict(arrays), "fine");
    EXPECT_NE(verdict(tables + std::string(static_cast<std::size_t>(depth), '}')), "fine");
  }
}

TEST(TomlDocument, DotsInTextAndNumbersAreNoKeyParts) {
  const std::string dots(100, '.');
  std::string numbers;
  for (int i = 0; i < 200; ++i) {
    numbers += "1.5, ";
  }
  const auto read_all = [](TomlTable& t) {
    t.text("a");
    t.text("b");
    t.text("c");
    t.numbers("n");
  };
  EXPECT_EQ(verdict("# " + dots + "\na = \"" + dots + "\"\nb = '" + dots + "'\nc = \"\"\"\n\"" + dots +
                        "\"\"\"\"\nn = [" + numbers + "]",
                    read_all),
            "fine");
}

TEST(TomlDocument, LongKeysAreNotPrintedInFull) {
  const std::string key(100'000, 'k');
  const std::string unknown = verdict(key + " = 1");
  EXPECT_THAT(unknown, HasSubstr("is not a key that is known here"));
  EXPECT_LT(unknown.size(), 300u);
  EXPECT_LT(verdict(key + " = 1\n" + key + " = 2\n").size(), 500u);
  EXPECT_LT(verdict("\"" + key).size(), 500u);
}

TEST(TomlDocument, WhereNamesTheKeyOrItsTable) {
  auto document = parse("a = 1\n[inner]\nx = 1\n");
  EXPECT_EQ(document->root().where("a"), "f.toml:2:5");
  EXPECT_EQ(document->root().table("inner").where("x"), "f.toml:4:5");
  EXPECT_EQ(document->root().table("inner").where("absent"), "f.toml:3:1");
  EXPECT_EQ(document->root().table("absent").where("x"), "f.toml");
}

}  // namespace
}  // namespace artcal
