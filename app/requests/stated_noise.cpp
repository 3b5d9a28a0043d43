#include "app/requests/stated_noise.h"

#include <fmt/format.h>

#include "core/plausible.h"
#include "core/text/decimal_comma.h"
#include "core/text/in_quotes.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

/// What is known of a kind of quantity.
struct NoiseKind {
  std::optional<double> (*read)(std::string_view);
  bool (*is_plausible)(double);
  const char* range;
  const char* example;
};

Expected<double> read_noise(const std::string& text, const char* option, ZeroNoise zero, const NoiseKind& kind) {
  const auto value = kind.read(text);
  const bool may_be_zero = zero == ZeroNoise::Allowed;
  if (!value || !(*value > 0.0 || (may_be_zero && *value == 0.0))) {
    return wrong_usage(fmt::format("{} is {}, expected {} with its unit, such as \"{}\"{}", option, in_quotes(text),
                                   may_be_zero ? "0 or a number above zero" : "a number above zero", kind.example,
                                   decimal_comma_question(text)));
  }
  if (*value > 0.0 && !kind.is_plausible(*value)) {
    return wrong_usage(fmt::format("{} is {}, expected {}a standard deviation of {}; is the unit right?", option,
                                   in_quotes(text), may_be_zero ? "0 or " : "", kind.range));
  }
  return *value;
}

}  // namespace

Expected<double> stated_length_noise(const std::string& text, const char* option, ZeroNoise zero) {
  return read_noise(text, option, zero, {length_quantity, plausible::is_length_u, plausible::length_range, "3 um"});
}

Expected<double> stated_angle_noise(const std::string& text, const char* option, ZeroNoise zero) {
  return read_noise(text, option, zero, {angle_quantity, plausible::is_angle_u, plausible::angle_range, "2 arcsec"});
}

}  // namespace artcal
