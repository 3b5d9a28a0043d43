#include "artefacts/simulation/plan/plan_keys.h"

#include <cmath>

#include <fmt/format.h>

#include "core/text/decimal_comma.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

using Quantity = std::optional<double> (*)(std::string_view);

double quantity_at(TomlTable& table, std::string_view key, double fallback, Quantity read, std::string_view example) {
  if (!table.has(key)) {
    return fallback;
  }
  const std::string text = table.text(key);
  const auto value = read(text);
  if (!value) {
    table.fail(key, fmt::format("`{}` is {}, expected a number of zero or above with its unit, such as \"{}\"{}", key,
                                in_quotes(text), example, decimal_comma_question(text)));
  }
  return value.value_or(fallback);
}

template <int Size>
std::optional<Eigen::Matrix<double, Size, 1>> vector_at(TomlTable& table, std::string_view key) {
  if (!table.has(key)) {
    return std::nullopt;
  }
  const auto numbers = table.numbers(key);
  if (numbers.size() != Size) {
    table.fail(key, fmt::format("`{}` holds {} numbers, expected {}", key, numbers.size(), Size));
    return std::nullopt;
  }
  return Eigen::Matrix<double, Size, 1>::Map(numbers.data());
}

}  // namespace

double length_at(TomlTable& table, std::string_view key, double fallback) {
  return quantity_at(
      table, key, fallback, [](std::string_view text) { return length_quantity(text); }, "3 um");
}

double angle_at(TomlTable& table, std::string_view key, double fallback) {
  return quantity_at(
      table, key, fallback, [](std::string_view text) { return angle_quantity(text); }, "2 arcsec");
}

int count_at(TomlTable& table, std::string_view key, int fallback, int low, int high) {
  const double number = table.number_or(key, fallback);
  if (number < low || number > high || number != std::floor(number)) {
    table.fail(key, fmt::format("`{}` is {}, expected a whole number from {} to {}", key, number, low, high));
    return fallback;
  }
  return static_cast<int>(number);
}

double number_between(TomlTable& table, std::string_view key, double fallback, double low, double high) {
  const double number = table.number_or(key, fallback);
  if (number < low || number > high) {
    table.fail(key, fmt::format("`{}` is {}, expected a number from {} to {}", key, number, low, high));
    return fallback;
  }
  return number;
}

std::optional<Eigen::Vector2d> pair_at(TomlTable& table, std::string_view key) { return vector_at<2>(table, key); }
std::optional<Eigen::Vector3d> triple_at(TomlTable& table, std::string_view key) { return vector_at<3>(table, key); }

std::optional<Eigen::Vector3d> direction_at(TomlTable& table, std::string_view key) {
  const auto vector = triple_at(table, key);
  if (vector && !(vector->norm() > 1e-6 && vector->norm() < 1e6)) {
    table.fail(key, fmt::format("`{}` is no direction; state x, y and z of an arrow, such as [0, 0, 1]", key));
    return std::nullopt;
  }
  return vector ? std::optional<Eigen::Vector3d>(vector->normalized()) : std::nullopt;
}

}  // namespace artcal
