#include "identification/inspection/finding.h"

#include <algorithm>
#include <iterator>

namespace artcal {

std::string_view name_of(FindingKind kind) {
  switch (kind) {
    case FindingKind::RepeatedReadings: return "repeated_readings";
    case FindingKind::AngleUnit: return "angle_unit";
    case FindingKind::JointsExchanged: return "joints_exchanged";
    case FindingKind::JointSign: return "joint_sign";
    case FindingKind::JointOffset: return "joint_offset";
    case FindingKind::EncoderSlipped: return "encoder_slipped";
    case FindingKind::EncoderWrapped: return "encoder_wrapped";
    case FindingKind::FeaturesExchanged: return "features_exchanged";
    case FindingKind::WrongFeature: return "wrong_feature";
    case FindingKind::ArtefactMoved: return "artefact_moved";
    case FindingKind::PlacementNamesReused: return "placement_names_reused";
    case FindingKind::AnotherArmState: return "another_arm_state";
    case FindingKind::LengthUnit: return "length_unit";
    case FindingKind::PositionsAsSteps: return "positions_as_steps";
    case FindingKind::TipRadius: return "tip_radius";
    case FindingKind::BallDiameter: return "ball_diameter";
    case FindingKind::NoArmFits: return "no_arm_fits";
    case FindingKind::PlacementContradicts: return "placement_contradicts";
    case FindingKind::ImplausibleValue: return "implausible_value";
    case FindingKind::Certificate: return "certificate";
    case FindingKind::CentreNotDetermined: return "centre_not_determined";
    case FindingKind::NoDate: return "no_date";
    case FindingKind::NoCertificateNumber: return "no_certificate_number";
    case FindingKind::ElbowOnOneSide: break;
  }
  return "elbow_on_one_side";
}

void add_explanation(Findings& findings, Findings explanation) {
  for (const Finding& explaining : explanation) {
    if (explaining.kind == FindingKind::LengthUnit) {
      std::erase_if(findings, [&](const Finding& finding) {
        return finding.kind == FindingKind::ImplausibleValue && finding.where == explaining.where;
      });
    }
  }
  std::move(explanation.begin(), explanation.end(), std::back_inserter(findings));
}

std::string artefact_path(const Recording& recording, std::size_t artefact) {
  return artefact < recording.artefact_paths.size() ? recording.artefact_paths[artefact] : "";
}

}  // namespace artcal
