#include "app/report/numbers.h"

#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal::numbers {
namespace {

using Json = nlohmann::ordered_json;

std::string formatted(const char* format, double value) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "–";
}

}  // namespace

std::string mm(double value) { return formatted("{:.4f}", value); }
std::string signed_mm(double value) { return formatted("{:+.4f}", value); }
std::string micrometres(double mm) { return formatted("{:.1f}", mm / units::micrometre); }
std::string signed_micrometres(double mm) { return formatted("{:+.1f}", mm / units::micrometre); }
std::string deviation_micrometres(double mm, bool is_signed) {
  return is_signed ? signed_micrometres(mm) : micrometres(mm);
}
std::string two_digits(double value) { return formatted("{:.2g}", value); }

std::string shown(const std::string& name) { return truncated(100, name); }

std::string or_dash(const std::string& text) { return text.empty() ? "–" : text; }

DrawnUnit drawn_unit(double largest) { return largest < 0.5 ? DrawnUnit{"µm", 1.0 / units::micrometre} : DrawnUnit{}; }

Json drawn(double value) {
  return std::isfinite(value) ? Json(std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr)) : Json(nullptr);
}

}  // namespace artcal::numbers
