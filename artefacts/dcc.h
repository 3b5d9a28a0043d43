#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "artefacts/artefact.h"
#include "core/error.h"
#include "core/input_file.h"

namespace artcal {

/// What a part of a certificate is called: its id, its names in all languages, its reference types.
struct DccLabels {
  std::string id;
  std::vector<std::string> names;
  std::vector<std::string> ref_types;
};

/// The uncertainty of one number. A standard uncertainty stands here as U with k = 1.
struct DccUncertainty {
  double U = 0.0;  ///< in the quantity's unit
  double k = 0.0;
  std::optional<double> probability;  ///< of coverage, where it is stated
};

/// A quantity of a certificate as it stands there: one number or a list of them, in its own unit.
struct DccQuantity {
  DccLabels labels;
  std::vector<DccLabels> within;              ///< the lists and the result that it is part of, outermost first
  std::string unit;                           ///< D-SI, such as "\\milli\\metre"
  std::vector<double> values;                 ///< NaN where the certificate says so
  std::vector<DccUncertainty> uncertainties;  ///< one a value; none where none is stated
  int line = 0;

  /// For people: its place and name, its first value.
  [[nodiscard]] std::string text() const;
};

/// A digital calibration certificate (PTB DCC, schema versions 2.x and 3.x).
struct DccCertificate {
  InputFile input;
  std::string schema_version;
  Certificate certificate;              ///< number, laboratory, date; a DCC states no end of validity
  std::string item;                     ///< name of what was calibrated
  bool is_signed = false;               ///< a signature is there; it is not checked
  std::vector<DccQuantity> quantities;  ///< of the results, in the file's order
};

/// Reads a DCC. In hybrid quantities the first representation counts; complex numbers, constants and texts are
/// passed over. Refused: what is no DCC of these versions, a document type or entities of its own, deep nesting,
/// another encoding than UTF-8, a number or a date that is none, more than 16 MiB.
Expected<DccCertificate> read_dcc_file(const std::filesystem::path& path);

/// The one quantity that `key` names: by id, else by name, else by reference type; or by "part/…/name", where parts are
/// ids, names or reference types of what it is in. None or several: a refusal that lists what there is.
Expected<DccQuantity> find_quantity(const DccCertificate& certificate, std::string_view key);

/// All quantities of a certificate in a line, for people; the first dozen if there are more.
std::string list_of_quantities(const DccCertificate& certificate);

/// The factor from a D-SI unit of length to mm; nothing where it is not one that is known here.
std::optional<double> dsi_length_unit(std::string_view unit);

}  // namespace artcal
