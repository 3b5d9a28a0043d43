#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "acquisition/recording/recording.h"

namespace artcal {

/// A mistake of measuring, or of what was written down about it.
enum class FindingKind {
  RepeatedReadings,      ///< the same posture twice: rows repeated, tables that overlap
  AngleUnit,             ///< joint angles in degrees that are radians, or the other way round
  JointsExchanged,       ///< columns of joint angles in another order
  JointSign,             ///< a joint that counts the other way round
  JointOffset,           ///< a joint's zero that is another than the arm's file says
  EncoderSlipped,        ///< a joint that has another zero from some reading on
  EncoderWrapped,        ///< a joint that has another zero above some angle
  FeaturesExchanged,     ///< two features of a placement have each other's names
  WrongFeature,          ///< readings on one feature are written under the name of another
  ArtefactMoved,         ///< one placement's name for two poses of the artefact
  PlacementNamesReused,  ///< two tables with one name for two placements
  AnotherArmState,       ///< a table that was read by another arm, or by the arm in another state
  LengthUnit,            ///< certified lengths or the arm's lengths in another unit
  PositionsAsSteps,      ///< positions from the first feature, stated as distances from one to the next
  TipRadius,             ///< a tip radius that is forgotten, or the diameter
  BallDiameter,          ///< a ball's diameter that is its radius, or the other way round
  NoArmFits,             ///< no arm fits, and no single mistake explains it
  PlacementContradicts,  ///< a placement that does not fit the arm that all others fit
  ImplausibleValue,      ///< an uncertainty, a limit, a temperature in another unit
  Certificate,           ///< a certificate that had lapsed, or was not yet valid
  CentreNotDetermined,   ///< touches on a ball that do not determine its centre
  NoDate,                ///< the recording does not say when it was made
  NoCertificateNumber,   ///< an artefact's certificate has no number
  ElbowOnOneSide,        ///< a placement read with the elbow on one side only
};

/// As JSON writes it: repeated_readings, angle_unit, ….
std::string_view name_of(FindingKind kind);

/// One sentence that says what was found where, and what to do.
struct Finding {
  FindingKind kind = FindingKind::RepeatedReadings;
  std::string where;  ///< "readings.csv:12", or a file; empty where it is no single place
  std::string text;
  bool is_input_warning = false;  ///< the warnings say it too: the recording's or those of its documents

  /// "where: text".
  [[nodiscard]] std::string sentence() const { return where.empty() ? text : where + ": " + text; }
};

using Findings = std::vector<Finding>;

/// Adds what explains the readings. Values of a file that are implausible only because its unit is another are that
/// mistake's, and are not named beside it.
void add_explanation(Findings& findings, Findings explanation);

/// Where a finding about an artefact is: its file; empty where the artefact was not read from one.
std::string artefact_path(const Recording& recording, std::size_t artefact);

}  // namespace artcal
