#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace artcal::numbers {

/// Numbers as reports show them; "–" for what is not a number.
std::string mm(double value);               ///< 0.2048
std::string signed_mm(double value);        ///< +0.2048
std::string micrometres(double mm);         ///< 204.8
std::string signed_micrometres(double mm);  ///< +204.8
/// With its sign where it has one: an error; a range or a distance from a point has none.
std::string deviation_micrometres(double mm, bool is_signed);
std::string two_digits(double value);  ///< an uncertainty: 0.031

/// A name from a file, cut where it is longer than a line.
std::string shown(const std::string& name);

/// "–" for an empty text.
std::string or_dash(const std::string& text);

/// The unit in which lengths up to `largest` mm are drawn: micrometres below half a millimetre.
struct DrawnUnit {
  const char* name = "mm";
  double per_mm = 1.0;
};
DrawnUnit drawn_unit(double largest);

/// For a picture: six digits, and null for what is not a number.
nlohmann::ordered_json drawn(double value);

}  // namespace artcal::numbers
