#include "core/text/decimal_number.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace artcal {
namespace {

TEST(DecimalNumber, ReadsWholeTextsOnly) {
  const std::vector<std::pair<std::string, double>> numbers{
      {"0", 0.0},       {"1", 1.0},       {"-1", -1.0},       {"+1", 1.0},        {"1.", 1.0},    {".5", 0.5},
      {"-.5", -0.5},    {"007", 7.0},     {"1.5e3", 1.5e3},   {"1.5E+03", 1.5e3}, {"2e-3", 2e-3}, {"+2.5e-3", 2.5e-3},
      {"1e100", 1e100}, {"1e308", 1e308}, {"1e-308", 1e-308}, {"0e999999", 0.0}};
  for (const auto& [text, value] : numbers) {
    const auto read = decimal_number(text);
    ASSERT_TRUE(read) << text;
    EXPECT_EQ(*read, value) << text;
  }
  EXPECT_TRUE(std::signbit(*decimal_number("-0")));
  for (const std::string text :
       {"",     " ",     "+",     "-",     ".",     "e",     "e5",    "1e",     "1e+",    " 1",
        "1 ",   "\t1",   "1\r",   "1,5",   "1.5.2", "1 2",   "++1",   "+-1",    "-+1",    "--1",
        "0x10", "0x1p3", "1d3",   "1_000", "1'000", "1mm",   "1e400", "-1e400", "1e-400", "1e99999999999999999999",
        "٣",    "½",     "1e5.5", "one",   "#1",    "+nan ", "1f"}) {
    EXPECT_FALSE(decimal_number(text)) << text;
  }
  EXPECT_FALSE(decimal_number(std::string_view("1\0", 2)));
  EXPECT_FALSE(decimal_number(std::string_view()));
}

// What was not measured is marked so in scans; whoever wants a quantity refuses it by is_in_range().
TEST(DecimalNumber, ReadsWhatIsNotFinite) {
  for (const std::string text : {"nan", "NaN", "-nan", "NAN"}) {
    ASSERT_TRUE(decimal_number(text)) << text;
    EXPECT_TRUE(std::isnan(*decimal_number(text))) << text;
  }
  for (const std::string text : {"inf", "Inf", "+inf", "infinity"}) {
    EXPECT_EQ(decimal_number(text), std::numeric_limits<double>::infinity()) << text;
  }
  EXPECT_EQ(decimal_number("-inf"), -std::numeric_limits<double>::infinity());
}

// The view ends where it ends, whatever stands behind it.
TEST(DecimalNumber, DoesNotReadBehindItsEnd) {
  const std::string text = "1234.5";
  EXPECT_EQ(decimal_number(std::string_view(text).substr(0, 3)), 123.0);
  EXPECT_EQ(decimal_number(std::string_view(text).substr(3, 1)), 4.0);
}

TEST(DecimalNumber, ReadsVeryLongNumbersToTheLastDigit) {
  EXPECT_EQ(decimal_number("0." + std::string(400, '0') + "1e401"), 1.0);
  EXPECT_EQ(decimal_number("1" + std::string(400, '0') + "e-400"), 1.0);
  EXPECT_EQ(decimal_number("0.1" + std::string(5000, '0')), 0.1);
  // Halfway between 1 and the next double, and a last digit that decides.
  const std::string halfway = "1.00000000000000011102230246251565404236316680908203125";
  EXPECT_EQ(decimal_number(halfway), 1.0);
  EXPECT_EQ(decimal_number(halfway + std::string(3000, '0') + "1"), std::nextafter(1.0, 2.0));
}

// Texts of the characters that numbers have, in any order: what strtod reads in whole and no rule above excludes.
TEST(DecimalNumber, AgreesWithStrtodOnOddTexts) {
  constexpr std::string_view alphabet = "0123456789019..-+eE, xn";
  std::mt19937 random(7);  // the same numbers on every machine
  int numbers = 0;
  for (int i = 0; i < 300'000; ++i) {
    std::string text(1 + random() % 9, ' ');
    for (char& c : text) {
      c = alphabet[random() % alphabet.size()];
    }
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    const bool whole =
        end == text.c_str() + text.size() && text.front() != ' ' && text.find_first_of("xX") == std::string::npos &&
        std::isfinite(value) &&
        (value != 0.0 || text.substr(0, text.find_first_of("eE")).find_first_of("123456789") == std::string::npos);
    const auto read = decimal_number(text);
    ASSERT_EQ(read.has_value(), whole) << text;
    if (whole) {
      ASSERT_EQ(*read, value) << text;
      ++numbers;
    }
  }
  EXPECT_GT(numbers, 30'000);
}

}  // namespace
}  // namespace artcal
