// A joint stated against the ground, as FANUC states J3 (ros-industrial/fanuc_experimental, issue 17): planted by 4 x 4
// matrices.
#include "identification/identify.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.h"
#include "tests/support/forward_kinematics.h"
#include "tests/support/recordings.h"
#include "tests/support/tracked.h"

namespace artcal {
namespace {

// Lengths and tilts of a robot of FANUC's kind, axes 2 and 3 parallel.
Arm fanuc() {
  constexpr double right = std::numbers::pi / 2;
  Arm arm;
  arm.name = "coupled";
  arm.joints = {{.a = 150.0, .d = 525.0, .alpha = right},
                {.a = 790.0, .theta = right},
                {.a = 250.0, .alpha = right},
                {.d = 835.0, .alpha = -right},
                {.alpha = right},
                {.d = 100.0}};
  arm.probes.push_back({"tip", {60.0, 20.0, 80.0}, 0.0, false});
  return arm;
}

Arm off_nominal(const Arm& nominal, std::uint64_t seed) {
  RandomStream random(seed, "coupled");
  Arm arm = test::off_nominal(nominal, random);
  arm.joints[1].beta = 0.8e-3;
  return arm;
}

TEST(MechanicalCoupling, IsAConventionThatIdentificationKnows) {
  for (const double coupling : {1.0, -1.0}) {
    Arm nominal = fanuc();
    nominal.joints[2].mechanical_coupling = coupling;
    const test::Bound bound = test::tracked(off_nominal(nominal, 1), nominal, 120, 1e-2);
    IdentifyOptions options;
    options.leave_out = false;
    const Identification result = test::identified(bound, options);
    EXPECT_NEAR(result.noise, 1e-2, 2e-3);
    EXPECT_EQ(result.arm.joints[2].mechanical_coupling, coupling);
  }
}

// The small error of a gear beside it stays what it is, a few ppm.
TEST(MechanicalCoupling, StandsApartFromCouplingErrors) {
  Arm nominal = fanuc();
  nominal.joints[2].mechanical_coupling = 1.0;
  Arm truth = off_nominal(nominal, 2);
  truth.joints[2].errors.coupling = 300e-6;
  const test::Bound bound = test::tracked(truth, nominal, 200, 1e-3);
  IdentifyOptions options;
  options.leave_out = false;
  options.model = {ParameterGroup::Coupling};
  const Identification result = test::identified(bound, options);
  EXPECT_NEAR(test::identified_value(result, "coupling3"), 300e-6, 5e-6);
}

}  // namespace
}  // namespace artcal
