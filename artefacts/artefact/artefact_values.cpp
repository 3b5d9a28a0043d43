#include "artefacts/artefact/artefact_values.h"

#include <cmath>

#include <fmt/format.h>

#include "core/plausible.h"
#include "core/text/decimal_comma.h"
#include "core/text/in_quotes.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

constexpr double largest_k = 10.0;

// U as a number in the file's unit, or as a text such as "0.8 um"; mm.
double read_length_or_quantity(TomlTable& table, const ArtefactValues& values, std::string_view key) {
  if (!table.is_text(key)) {
    return table.number(key) * values.length;
  }
  const std::string text = table.text(key);
  const auto quantity = length_quantity(text);
  if (!quantity) {
    table.fail(key, fmt::format("`{}` is {}, expected a length with its unit, such as \"0.8 um\", or a number in the "
                                "file's unit of length{}",
                                key, in_quotes(text), decimal_comma_question(text)));
  }
  return quantity.value_or(1.0);
}

double read_quantity(TomlTable& table, std::string_view key, std::optional<double> (*read)(std::string_view),
                     std::string_view example) {
  const std::string text = table.text(key);
  const auto quantity = read(text);
  if (!quantity) {
    table.fail(key, fmt::format("`{}` is {}, expected a number of zero or more with its unit, such as \"{}\"{}", key,
                                in_quotes(text), example, decimal_comma_question(text)));
  }
  return quantity.value_or(1.0);
}

std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
  std::string result;
  for (auto at = text.find(from); at != std::string_view::npos; at = text.find(from)) {
    result += std::string(text.substr(0, at)) + std::string(to);
    text.remove_prefix(at + from.size());
  }
  return result + std::string(text);
}

// How people write a rule: with or without signs of multiplication, as powers or superscripts.
std::string without_decoration(std::string text) {
  for (const auto& [from, to] : {std::pair<std::string_view, std::string_view>{"²", "^2"},
                                 {"√", "sqrt"},
                                 {"·", ""},
                                 {"*", ""},
                                 {" ", ""},
                                 {"U=", ""}}) {
    text = replaced(text, from, to);
  }
  return text;
}

bool read_rule_form(TomlTable& table) {
  const std::string stated = table.text("rule");
  const std::string form = without_decoration(stated);
  if (form != "a+bL" && form != "sqrt(a^2+(bL)^2)") {
    table.fail("rule",
               fmt::format("the rule is {}, expected \"a + b*L\" or \"sqrt(a^2 + (b*L)^2)\"", in_quotes(stated)));
  }
  return form != "a+bL";
}

double read_factor(TomlTable& table, std::string_view key) {
  const double k = table.number(key);
  if (k > largest_k) {
    table.fail(key,
               fmt::format("a coverage factor of {} is none (is it the probability in percent?), expected k as the "
                           "certificate states it, such as 2",
                           k));
  }
  return k;
}

UncertaintyRule read_rule(TomlTable table, const ArtefactValues& values) {
  UncertaintyRule rule;
  const bool constant = table.has("U");
  if (constant) {
    rule.a = read_length_or_quantity(table, values, "U");
  } else {
    rule.in_squares = read_rule_form(table);
    rule.a = read_quantity(table, "a", length_quantity, "0.5 um");
    rule.b = read_quantity(table, "b", ratio_quantity, "1.2 um/m");
  }
  rule.k = read_factor(table, "k");
  if (rule.a <= 0.0 || rule.k <= 0.0) {
    table.fail(constant ? "U" : "a",
               "an uncertainty of zero or less is not one: state it and its k as the certificate does");
  }
  return rule;
}

// U of the certificate by its k, or by the k that the artefact file adds where the certificate has none.
double u_of_certificate(TomlTable& table, const CertifiedUncertainty& certified, const std::string& k_key) {
  if (certified.k > 0.0) {
    return *certified.U / certified.k;
  }
  if (!table.has(k_key)) {
    table.fail(k_key, fmt::format("the digital certificate states a relative uncertainty, U = {:.4g} mm, without its "
                                  "coverage factor; state `{}` as the certificate's text does",
                                  *certified.U, k_key));
    return *certified.U;
  }
  const double k = read_factor(table, k_key);
  if (k <= 0.0) {
    table.fail(k_key, "a coverage factor of zero or less is none");
  }
  return *certified.U / (k > 0.0 ? k : 1.0);
}

void check_standard_uncertainty(TomlTable& table, std::string_view key, double u) {
  if (!plausible::is_length_u(u)) {
    table.fail(key, fmt::format("a standard uncertainty U/k of {:.6g} mm, expected {}; is the unit right?", u,
                                plausible::length_range));
  }
}

}  // namespace

double UncertaintyRule::standard_uncertainty(double length) const {
  return (in_squares ? std::hypot(a, b * length) : a + b * length) / k;
}

void read_rules(TomlTable table, ArtefactValues& values) {
  for (auto& [key, rule] : {std::pair{"at", &values.at_rule}, std::pair{"distance", &values.distance_rule},
                            std::pair{"diameter", &values.diameter_rule}}) {
    if (table.has(key)) {
      *rule = read_rule(table.table(key), values);
    }
  }
}

double read_standard_uncertainty(TomlTable& table, const ArtefactValues& values, const std::string& U_key,
                                 const std::string& k_own) {
  const double expanded = read_length_or_quantity(table, values, U_key);
  const double k = read_factor(table, table.has(k_own) ? k_own : "k");
  if (expanded <= 0.0 || k <= 0.0) {
    table.fail(U_key, "an uncertainty of zero or less is not one: state U and k as the certificate does");
    return 1.0;
  }
  check_standard_uncertainty(table, U_key, expanded / k);
  return expanded / k;
}

std::optional<double> read_uncertainty(TomlTable& table, const ArtefactValues& values, const std::string& U_key,
                                       const std::string& k_own, const std::optional<UncertaintyRule>& rule,
                                       double length, const CertifiedUncertainty& certified) {
  if (table.has(U_key) && rule) {
    table.fail(U_key,
               fmt::format("`{}` is stated here, and [uncertainty] has a rule for it; state one of them", U_key));
  }
  if (table.has(U_key) && certified.U) {
    table.fail(U_key, fmt::format("`{}` is stated here, and the digital certificate has it; leave it out", U_key));
  }
  if (certified.U) {
    const double u = u_of_certificate(table, certified, table.has(k_own) ? k_own : "k");
    check_standard_uncertainty(table, U_key, u);
    return u;
  }
  if (table.has(U_key)) {
    return read_standard_uncertainty(table, values, U_key, k_own);
  }
  if (!rule && !certified.unread.empty()) {
    table.fail(U_key, fmt::format("the digital certificate states an uncertainty in a form that is not read here, {}; "
                                  "state `{}` and `{}` as the certificate does",
                                  certified.unread, U_key, k_own));
  }
  if (!rule) {
    return std::nullopt;
  }
  check_standard_uncertainty(table, U_key, rule->standard_uncertainty(length));
  return rule->standard_uncertainty(length);
}

TemperatureConversion conversion_at(TomlTable& table, std::string_view key, double temperature,
                                    const ArtefactValues& values) {
  const double difference = temperature - values.reference_temperature;
  if (difference == 0.0) {
    return {};
  }
  if (!values.expansion) {
    table.fail(key, fmt::format("the value holds at {} degC and the reference temperature is {} degC, but without "
                                "expansion_per_K it cannot be converted",
                                temperature, values.reference_temperature));
  } else if (std::abs(difference) > 100.0) {
    table.fail(key, fmt::format("{} degC is no temperature at which artefacts are calibrated", temperature));
  }
  return {1.0 / (1.0 + values.expansion.value_or(0.0) * difference), std::abs(difference) * values.u_expansion,
          temperature};
}

TemperatureConversion read_conversion(TomlTable& table, const ArtefactValues& values) {
  const auto temperature = table.optional_number("temperature_C");
  return temperature ? conversion_at(table, "temperature_C", *temperature, values) : TemperatureConversion{};
}

}  // namespace artcal
