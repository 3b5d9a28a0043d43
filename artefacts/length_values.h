#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "artefacts/artefact_values.h"

namespace artcal {

/// Lengths in mm, and their standard uncertainties where they came along from a digital certificate.
struct LengthValues {
  std::vector<double> values;
  std::vector<double> u;  ///< mm, one a value; none where none came along

  [[nodiscard]] std::optional<double> u_of(std::size_t i) const {
    return u.empty() ? std::nullopt : std::optional(u[i]);
  }
};

/// Reads an array of numbers in the file's unit, or a reference to the file's digital certificate: { dcc = "name" }, or
/// names of several quantities, with { …, item = 2 } for one number of a list.
LengthValues read_lengths(TomlTable& table, std::string_view key, const ArtefactValues& values);

/// The same for one number; there is always one value, whatever is noted as wrong.
LengthValues read_length(TomlTable& table, std::string_view key, const ArtefactValues& values);

}  // namespace artcal
