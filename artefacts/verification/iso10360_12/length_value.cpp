#include "artefacts/verification/iso10360_12/length_value.h"

namespace artcal {

TestValue length_value(const Session& session, const Artefact& artefact, const CertifiedDistance& certified,
                       const MeasuredLength& measured) {
  TestValue value;
  value.artefact = artefact.name;
  value.first = artefact.features[static_cast<std::size_t>(certified.first)].name;
  value.second = artefact.features[static_cast<std::size_t>(certified.second)].name;
  value.temperature = mean_temperature(session, measured.readings);
  value.certified = certified.value;
  value.stated = artefact.stated(certified);
  value.measured = measured.length / expansion_factor_or_one(artefact, value.temperature);
  value.value = value.measured - value.certified;
  value.budget.calibration = certified.u;
  value.budget.alignment = session.specification.u_alignment;
  value.budget.fixture = session.specification.u_fixture;
  value.budget = with_thermal(value.budget, value.certified, thermal_state(session, artefact, value.temperature));
  value.place = place_of(measured.middle_in_base, session.recording, session.arm, measured.readings);
  return value;
}

}  // namespace artcal
