#pragma once

#include <optional>
#include <string>
#include <vector>

#include "artefacts/artefact/artefact.h"
#include "artefacts/constraints/document_warnings.h"
#include "artefacts/verification/decision/budget.h"
#include "artefacts/verification/decision/decision.h"
#include "artefacts/verification/decision/specification.h"
#include "artefacts/verification/place.h"
#include "artefacts/verification/point_scatter.h"

namespace artcal {

/// One number that a standard asks for, measured and judged. Lengths in mm at the artefact's reference
/// temperature.
struct TestValue {
  Quantity quantity = Quantity::LengthUni;
  std::string artefact, placement;
  std::string first, second;  ///< features; `second` of lengths only
  std::string repeat;
  double certified = 0.0;  ///< length or diameter; 0 where the value itself is all there is
  StatedValue stated;      ///< of a length: what the certificate says, at its temperature
  double measured = 0.0;
  double value = 0.0;        ///< what is judged
  double temperature = 0.0;  ///< °C; NaN where it was not read
  Budget budget;
  Dilution dilution;
  std::optional<double> limit;
  Verdict verdict = Verdict::NotJudged;
  bool set_aside = false;  ///< measured again under the outlier rule; its verdict does not count
  Place place;
};

enum class Conclusion {
  ConformityProven,     ///< everything that is asked for is there, and the conformity of all of it is proven
  NonConformityProven,  ///< that of at least one value
  ConformityNotShown,   ///< neither: see the verdicts and what is missing
};

/// Evidence that is missing: a line of Verification::missing or, where the specification waives it, of waived.
struct MissingEvidence {
  Evidence evidence = Evidence::CertificateAbsent;
  std::string text;
  bool is_waived = false;
  Subject about = {};

  /// "`text` [certificate_lapsed]".
  [[nodiscard]] std::string line() const;
};

/// An arm verified.
struct Verification {
  std::string standard;
  DecisionRule rule = DecisionRule::Iso14253_2017;
  std::vector<TestValue> values;
  PointScatters scatters{};               ///< of the touches, by their kind
  std::vector<std::string> missing;       ///< what stands in the way of conformity beside the values
  std::vector<std::string> waived;        ///< what would stand there, but the specification waives it
  std::vector<MissingEvidence> evidence;  ///< those of both that lack evidence
  std::vector<std::string> warnings;      ///< what looks wrong but may be right
  Conclusion conclusion = Conclusion::ConformityNotShown;

  [[nodiscard]] PointScatter& scatter(PointKind kind) { return scatters[static_cast<std::size_t>(kind)]; }
};

/// Notes that evidence is missing, among what is missing or, where the specification waives it, among what is waived.
/// The same text is noted once.
void report_missing(Verification& verification, const Specification& specification, Evidence evidence,
                    const std::string& text, const Subject& about = {});

/// Whether what a warning of the documents says is noted as missing or waived.
bool is_noted(const Verification& verification, const DocumentWarning& warning);

/// Fills limit and verdict of a value.
void judge(TestValue& value, const Specification& specification);

/// From the values and what is missing. Nothing missing and no value at all shows nothing.
Conclusion conclude(const Verification& verification);

/// How much of its limit a value uses up; its size, mm, where none is stated. Of limits that grow with the length, the
/// value that uses up most of its own is the worst.
double severity(const TestValue& value);

/// The most severe value of a quantity, or none. Values set aside do not count.
const TestValue* worst_of(const Verification& verification, Quantity quantity);

const char* text_of(Conclusion conclusion);

/// "E_Uni A - B, placement 3, repeat 1".
std::string label_of(const TestValue& value);

}  // namespace artcal
