#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "artefacts/artefact/artefact.h"
#include "core/error.h"
#include "core/files/input_file.h"

namespace artcal {

/// What a part of a certificate is called: its id, its names in all languages, its reference types; of names and of
/// types the first hundred.
struct DccLabels {
  std::string id;
  std::vector<std::string> names;
  std::vector<std::string> ref_types;
};

/// The uncertainty of one number, in its unit. A standard uncertainty stands here as U with k = 1.
struct DccUncertainty {
  double U = 0.0;
  double k = 0.0;                     ///< 0: the certificate states no coverage factor (a relative uncertainty alone)
  std::optional<double> probability;  ///< of coverage, where it is stated
};

/// A number or a list of numbers as it stands in a certificate.
struct DccNumbers {
  std::vector<double> values;                 ///< NaN where the certificate says so
  std::vector<double> half_digits;            ///< half a unit of the last digit that each value is written with
  std::vector<std::string> units;             ///< D-SI, such as "\\milli\\metre"; one a value
  std::vector<std::string> labels;            ///< of each value; none where they have none
  std::vector<DccUncertainty> uncertainties;  ///< one a value; none where none is stated or none is read
  std::string unread_uncertainty;             ///< the element of an uncertainty that is stated but not read, else empty
};

/// A quantity of a certificate.
struct DccQuantity {
  DccLabels labels;
  /// Of the lists and the result that it is part of, outermost first; all quantities of a list share its labels.
  std::vector<std::shared_ptr<const DccLabels>> within;
  std::vector<DccNumbers> representations;  ///< the same in several units (si:hybrid), or one; none with a `fault`
  std::optional<Error> fault;               ///< why its numbers are not read; the other quantities are
  int line = 0;

  /// For people: its place and name, its first value.
  [[nodiscard]] std::string text() const;
  /// The first representation. REQUIRES: there is no fault.
  [[nodiscard]] const DccNumbers& numbers() const { return representations.front(); }
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

}  // namespace artcal
