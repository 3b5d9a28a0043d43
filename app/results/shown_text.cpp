#include "app/results/shown_text.h"

#include <cmath>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {

std::string mm_text(double value) { return std::isfinite(value) ? fmt::format("{:.4f}", value) : "-"; }
std::string signed_mm_text(double value) { return std::isfinite(value) ? fmt::format("{:+.4f}", value) : "-"; }
std::string deviation_text(double value, bool is_signed) { return is_signed ? signed_mm_text(value) : mm_text(value); }
std::string shown_name(const std::string& name, std::size_t most) { return truncated(most, name); }

}  // namespace artcal
