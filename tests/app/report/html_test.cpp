#include "app/report/html.h"

#include <gmock/gmock.h>

namespace artcal {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(HtmlText, MarkupStaysText) {
  EXPECT_EQ(html::text("<script>alert('1 & \"2\"')</script>"),
            "&lt;script&gt;alert(&#39;1 &amp; &quot;2&quot;&#39;)&lt;/script&gt;");
  EXPECT_EQ(html::text("Ø 25 µm"), "Ø 25 µm");
}

TEST(HtmlText, NothingInItIsObeyed) {
  EXPECT_EQ(html::text("a\x1b[2Jb"), "a?[2Jb");
  EXPECT_THAT(html::text("a\u202Egnp.exe"), Not(HasSubstr("\u202E")));
}

TEST(HtmlText, AVeryLongOneIsCut) { EXPECT_LT(html::text(std::string(1'000'000, 'x')).size(), 5000u); }

TEST(HtmlCell, WordsStayWholeAndOnlyLongOnesMayBreak) {
  EXPECT_EQ(html::cell("✗ does not conform"), "✗ does not conform");
  EXPECT_EQ(html::cell("Messarm 06"), "Messarm 06");
  EXPECT_EQ(html::cell(std::string(28, 'x')), std::string(28, 'x'));
  EXPECT_EQ(html::cell("a  b "), "a  b ");
  // A path breaks behind its slashes, a name without any sign wherever it must.
  EXPECT_EQ(html::cell("archive/2026-03/arm 17/recording.toml"), "archive/2026-03/arm 17/recording.toml");
  EXPECT_EQ(html::cell("archive/of-many/arms/recording.toml"),
            "archive/<wbr>of-<wbr>many/<wbr>arms/<wbr>recording.<wbr>toml");
  EXPECT_EQ(html::cell(std::string(29, 'x')), "<span class=\"long\">" + std::string(29, 'x') + "</span>");
  EXPECT_EQ(html::cell("ünï∞ünï∞ünï∞ünï∞ünï∞ünï∞ünï∞"), "ünï∞ünï∞ünï∞ünï∞ünï∞ünï∞ünï∞") << "characters, not bytes";
}

TEST(HtmlCell, MarkupStaysText) {
  const std::string cell = html::cell("<script>alert('a&b')</script><img src=\"x\">");
  EXPECT_THAT(cell, Not(HasSubstr("<script")));
  EXPECT_THAT(cell, Not(HasSubstr("<img")));
  EXPECT_THAT(cell, HasSubstr("&amp;"));
}

TEST(HtmlData, NothingInItEndsTheScript) {
  const std::string written = html::data({{"name", "</script><!-- <script> ]]> & \u2028"}, {"value", 0.1}});
  for (const char* mark : {"<", ">", "&", "\u2028"}) {
    EXPECT_THAT(written, Not(HasSubstr(mark)));
  }
  const auto read = nlohmann::json::parse(written);
  EXPECT_EQ(read["name"], "</script><!-- <script> ]]> & \u2028");
  EXPECT_EQ(read["value"], 0.1);
}

TEST(HtmlTable, AColumnThatMayGoGoesWhereItSaysNothing) {
  html::Table table("Lengths", {{"name", false, true}, {"after"}, {"cross-val.", true, false, false, true}});
  table.add({"A", "–", "–"});
  EXPECT_THAT(table.markup(), HasSubstr("after"));
  EXPECT_THAT(table.markup(), Not(HasSubstr("cross-val.")));
  table.add({"B", "1", "2"});
  EXPECT_THAT(table.markup(), HasSubstr("cross-val."));
  EXPECT_THAT(table.markup(), HasSubstr("<td class=\"number\">–</td><td class=\"number\">–</td></tr>"));
}

TEST(HtmlTable, OfManyColumnsNamesEachForANarrowScreen) {
  html::Table narrow("Few", {{"name", false, true}, {"value"}, {"limit"}, {"u"}});
  narrow.add({"A", "1", "2", "3"});
  EXPECT_THAT(narrow.markup(), Not(HasSubstr("--c")));
  html::Table wide("Many", {{"name", false, true},
                            {"gone", true, false, false, true},
                            {"value", true, false, false, false, true},
                            {"limit"},
                            {"u"},
                            {"°C"}});
  wide.add({"A", "–", "1", "2", "3", "20"});
  EXPECT_THAT(wide.markup(), HasSubstr("style=\"--c2:'value';--c3:'limit';--c4:'u';--c5:'°C';\""));
  EXPECT_THAT(wide.markup(), HasSubstr("<td class=\"number answer\">1</td>"));
}

TEST(HtmlTable, HasACaptionAHeadAndNamesItsRows) {
  html::Table table("Values & limits", {{"name", false, true}, {"value"}});
  EXPECT_TRUE(table.empty());
  table.add({"<b>A</b>", "1.5"});
  const std::string markup = table.markup();
  EXPECT_THAT(markup, HasSubstr("<caption>Values &amp; limits</caption>"));
  EXPECT_THAT(markup, HasSubstr("<thead><tr><th scope=\"col\">name</th><th scope=\"col\" class=\"number\">value</th>"));
  EXPECT_THAT(markup, HasSubstr("<th scope=\"row\">&lt;b&gt;A&lt;/b&gt;</th><td class=\"number\">1.5</td>"));
}

}  // namespace
}  // namespace artcal
