// A program of somebody else: where is the tip of a two-joint arm?
#include <artcal/acquisition/arm/arm_file.h>
#include <artcal/acquisition/arm/forward_kinematics.h>
#include <artcal/acquisition/recording/recording_file.h>
#include <artcal/core/random.h>
#include <artcal/identification/identify.h>

#include <array>
#include <cmath>
#include <cstdio>

int main() {
  artcal::Arm arm;
  arm.joints.resize(2);
  arm.joints[0].a = 300.0;
  arm.joints[1].a = 200.0;
  arm.probes.resize(1);

  const artcal::ForwardKinematics kinematics(arm, artcal::parameters_of(arm), 0);
  std::array<double, 4> sines{};
  artcal::joint_sines(std::array{0.0, std::acos(0.0)}, sines);
  const Eigen::Vector3d tip_in_base = kinematics.tip_in_base(sines);
  std::printf("%.3f %.3f %.3f\n", tip_in_base.x(), tip_in_base.y(), tip_in_base.z());

  // An identification without a reading: refused as a value, with Ceres linked behind it.
  artcal::Recording recording;
  recording.arm = arm;
  const auto nothing = artcal::identify(recording, {});
  if (nothing) {
    return 2;
  }

  // Files, and with them every library behind the headers.
  const auto missing = artcal::read_recording("no-such-recording.toml");
  const bool refused = !missing && missing.error().code == artcal::ErrorCode::BadInput;
  const bool right = (tip_in_base - Eigen::Vector3d(300.0, 200.0, 0.0)).norm() < 1e-12;
  return right && refused && !artcal::arm_file_text(arm, std::nullopt).empty() ? 0 : 1;
}
