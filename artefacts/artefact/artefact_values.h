#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/toml/toml_document.h"

namespace artcal {

struct DccCertificate;

/// An expanded uncertainty that depends on the length: U = a + b·L, or U = √(a² + (b·L)²).
struct UncertaintyRule {
  double a = 0.0;           ///< mm, above zero
  double b = 0.0;           ///< mm per mm
  double k = 0.0;           ///< coverage factor of U
  bool in_squares = false;  ///< the second form

  /// U/k at a length in mm.
  [[nodiscard]] double standard_uncertainty(double length) const;
};

/// No artefact is larger; what seems to be is in another unit. mm.
constexpr double largest_length = 1e5;

/// What all values of one artefact file are read with.
struct ArtefactValues {
  double length = 1.0;  ///< the file's unit, mm
  double reference_temperature = 20.0;
  std::optional<double> expansion;  ///< 1/K
  double u_expansion = 0.0;         ///< 1/K
  std::optional<UncertaintyRule> at_rule, distance_rule, diameter_rule;
  const DccCertificate* dcc = nullptr;  ///< the digital certificate that the file names, if it does
};

/// Reads [uncertainty]: rules for `at`, `distance` and `diameter`.
void read_rules(TomlTable table, ArtefactValues& values);

/// U and k, stated under the keys `U` and `k` as a certificate does, to u = U/k in mm. U is a number in the file's unit
/// or a text with its own unit. `k_own` is asked for before `k`.
double read_standard_uncertainty(TomlTable& table, const ArtefactValues& values, const std::string& U_key,
                                 const std::string& k_own = "k");

/// What a digital certificate says of a value's uncertainty.
struct CertifiedUncertainty {
  std::optional<double> U;  ///< expanded, mm; nothing where none is stated or none is read
  double k = 0.0;           ///< its coverage factor; 0 where the certificate does not state it
  std::string unread;       ///< what states an uncertainty that is not read; else empty

  [[nodiscard]] std::optional<double> u() const { return U ? std::optional(*U / (k > 0.0 ? k : 1.0)) : std::nullopt; }
};

/// The standard uncertainty of a value: that which came along from a digital certificate, with `k` of the artefact file
/// where the certificate has none; or U and k beside it; or what the file's rule says at `length`; nothing where there
/// is none of them. Two of them are an error, and so is none where the certificate states one that is not read: it
/// would be taken as zero.
std::optional<double> read_uncertainty(TomlTable& table, const ArtefactValues& values, const std::string& U_key,
                                       const std::string& k_own, const std::optional<UncertaintyRule>& rule,
                                       double length, const CertifiedUncertainty& certified);

/// A factor on lengths that were stated at a temperature of their own, and what it adds to their uncertainty.
struct TemperatureConversion {
  double factor = 1.0;
  double relative_u = 0.0;            ///< standard uncertainty of the factor: |T − reference|·u(α)
  std::optional<double> temperature;  ///< at which they were stated, where it is not the reference, °C
};

/// From `temperature` (°C) to the reference; what is wrong with it is noted at `key`. Away from the reference
/// temperature it needs an expansion.
TemperatureConversion conversion_at(TomlTable& table, std::string_view key, double temperature,
                                    const ArtefactValues& values);

/// Reads `temperature_C` of a value; without it nothing is converted.
TemperatureConversion read_conversion(TomlTable& table, const ArtefactValues& values);

}  // namespace artcal
