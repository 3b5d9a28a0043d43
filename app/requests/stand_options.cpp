#include "app/requests/stand_options.h"

#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "core/text/decimal_comma.h"
#include "core/text/in_quotes.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

Expected<void> take_height(const std::string& text, const char* option, std::optional<double>& height) {
  if (text.empty()) {
    return {};
  }
  const bool is_below = text.front() == '-';  // quantities have no sign
  const auto size = length_quantity(is_below ? text.substr(1) : text);
  if (!size) {
    return wrong_usage(fmt::format("{} is {}, expected a height in the base frame with its unit, such as \"-700 mm\"{}",
                                   option, in_quotes(text), decimal_comma_question(text)));
  }
  height = is_below ? -*size : *size;
  return {};
}

std::optional<std::array<double, 5>> five_numbers(const std::string& text) {
  std::array<double, 5> numbers{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && (at == end || *at++ != ',')) {
      return std::nullopt;
    }
    const auto [next, error] = std::from_chars(at, end, numbers[i]);
    if (error != std::errc() || !(std::abs(numbers[i]) < 1e7)) {
      return std::nullopt;
    }
    at = next;
  }
  return at == end ? std::optional(numbers) : std::nullopt;
}

}  // namespace

void StandOptions::add_to(CLI::App& parser) {
  parser.add_option("--floor", floor, "height below which no part of a feature may be, such as \"-700 mm\"")
      ->type_name("HEIGHT");
  parser.add_option("--lowest", lowest, "lowest height of a feature's centre that the stand holds")
      ->type_name("HEIGHT");
  parser.add_option("--highest", highest, "highest height of a feature's centre that the stand holds")
      ->type_name("HEIGHT");
  parser
      .add_option(
          "--table", tables,
          "a table or machine that is in the way: a rectangle of the base's x and y and its height, mm, such as "
          "300,1100,-400,400,-50; may be given several times")
      ->allow_extra_args(false)
      ->type_name("X1,X2,Y1,Y2,TOP");
}

Expected<void> StandOptions::add_to(Stand& stand) const {
  for (auto taken : {take_height(floor, "--floor", stand.floor), take_height(lowest, "--lowest", stand.lowest),
                     take_height(highest, "--highest", stand.highest)}) {
    if (!taken) {
      return taken;
    }
  }
  if (stand.lowest && stand.highest && !(*stand.lowest < *stand.highest)) {
    return wrong_usage(
        fmt::format("the highest height, {:g} mm, is not above the lowest, {:g} mm: the stand holds "
                    "nothing",
                    *stand.highest, *stand.lowest));
  }
  for (const std::string& text : tables) {
    const auto numbers = five_numbers(text);
    if (!numbers || !((*numbers)[0] < (*numbers)[1]) || !((*numbers)[2] < (*numbers)[3])) {
      return wrong_usage(
          fmt::format("--table is {}, expected X1,X2,Y1,Y2,TOP in mm, each from less to more, such as "
                      "300,1100,-400,400,-50",
                      in_quotes(text)));
    }
    stand.tables.push_back({{(*numbers)[0], (*numbers)[1]}, {(*numbers)[2], (*numbers)[3]}, (*numbers)[4]});
  }
  return {};
}

}  // namespace artcal
