#include "artefacts/length_values.h"

#include <cmath>

#include <fmt/format.h>

#include "artefacts/dcc.h"
#include "core/in_quotes.h"

namespace artcal {
namespace {

constexpr std::string_view known_units = "\\metre with no prefix or \\kilo, \\deci, \\centi, \\milli, \\micro, \\nano";

// Appends a quantity's numbers; a sentence where they are no lengths with sound uncertainties.
std::string append(const DccQuantity& quantity, LengthValues& lengths) {
  const auto unit = dsi_length_unit(quantity.unit);
  if (!unit) {
    return fmt::format("the certificate's quantity {} is in {}, which is no unit of length known here, expected {}",
                       in_quotes(quantity.text()), in_quotes(quantity.unit), known_units);
  }
  for (const double value : quantity.values) {
    if (!std::isfinite(value)) {
      return fmt::format("the certificate's quantity {} holds a NaN, no number", in_quotes(quantity.text()));
    }
    lengths.values.push_back(value * *unit);
  }
  for (const DccUncertainty& uncertainty : quantity.uncertainties) {
    if (!(uncertainty.U > 0.0) || !(uncertainty.k > 0.0)) {
      return fmt::format(
          "the certificate's quantity {} has U = {} and k = {}; an uncertainty of zero or less is not one",
          in_quotes(quantity.text()), uncertainty.U, uncertainty.k);
    }
    lengths.u.push_back(uncertainty.U / uncertainty.k * *unit);
  }
  return {};
}

void choose_item(TomlTable& reference, LengthValues& lengths) {
  const double item = reference.number("item");
  if (item != std::floor(item) || item < 1.0 || item > static_cast<double>(lengths.values.size())) {
    reference.fail("item", fmt::format("item is {}, expected a number from 1 to {}", item, lengths.values.size()));
    return;
  }
  const auto index = static_cast<std::size_t>(item) - 1;
  lengths.values = {lengths.values[index]};
  if (!lengths.u.empty()) {
    lengths.u = {lengths.u[index]};
  }
}

LengthValues from_certificate(TomlTable& table, std::string_view key, const ArtefactValues& values) {
  TomlTable reference = table.table(key);
  LengthValues lengths;
  const auto names = reference.is_text("dcc") ? std::vector{reference.text("dcc")} : reference.texts("dcc");
  if (names.empty()) {
    reference.fail("dcc", "expected the certificate's quantity, such as { dcc = \"diameter A\" }");
  } else if (values.dcc == nullptr) {
    reference.fail("dcc", "the file names no digital certificate; write dcc = \"certificate.xml\" at its top");
    return lengths;
  }
  for (const auto& name : names) {
    const auto quantity = find_quantity(*values.dcc, name);
    const std::string wrong = quantity ? append(*quantity, lengths) : quantity.error().message;
    if (!wrong.empty()) {
      reference.fail("dcc", wrong);
      return {};
    }
  }
  if (!lengths.u.empty() && lengths.u.size() != lengths.values.size()) {
    reference.fail("dcc", "of these quantities some have an uncertainty in the certificate and some have none");
    lengths.u.clear();
  }
  if (reference.has("item")) {
    choose_item(reference, lengths);
  }
  return lengths;
}

}  // namespace

LengthValues read_lengths(TomlTable& table, std::string_view key, const ArtefactValues& values) {
  if (table.is_table(key)) {
    return from_certificate(table, key, values);
  }
  LengthValues lengths{table.numbers(key), {}};
  for (double& value : lengths.values) {
    value *= values.length;
  }
  return lengths;
}

LengthValues read_length(TomlTable& table, std::string_view key, const ArtefactValues& values) {
  if (!table.is_table(key)) {
    return {{table.number(key) * values.length}, {}};
  }
  LengthValues lengths = from_certificate(table, key, values);
  if (lengths.values.size() != 1) {
    table.fail(key, fmt::format("the certificate's quantity holds {} numbers, expected one; choose it with item = 1 …",
                                lengths.values.size()));
    return {{1.0}, {}};
  }
  return lengths;
}

}  // namespace artcal
