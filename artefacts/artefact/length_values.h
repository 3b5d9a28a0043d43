#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "artefacts/artefact/artefact_values.h"

namespace artcal {

/// Lengths in mm, and what a digital certificate says of their uncertainties.
struct LengthValues {
  std::vector<double> values;
  std::vector<CertifiedUncertainty> certified;  ///< one a value; none where no certificate was asked

  [[nodiscard]] CertifiedUncertainty certified_of(std::size_t i) const {
    return certified.empty() ? CertifiedUncertainty{} : certified[i];
  }
  /// The largest, for all of them together. REQUIRES: the certificate states one for each, or for none.
  [[nodiscard]] CertifiedUncertainty largest_certified() const;
};

/// Reads an array of numbers in the file's unit, or a reference to the file's digital certificate: { dcc = "name" }, or
/// names of several quantities, with { …, item = 2 } for one number of a list, by its place or by its label.
LengthValues read_lengths(TomlTable& table, std::string_view key, const ArtefactValues& values);

/// The same for one number; there is always one value, whatever is noted as wrong.
LengthValues read_length(TomlTable& table, std::string_view key, const ArtefactValues& values);

}  // namespace artcal
