// A program of somebody else: where is the tip of a two-joint arm? With the folder of the installed examples as its
// argument it reads readings, identifies an arm from them and verifies that arm, all in memory.
#include <artcal/acquisition/arm/arm_file.h>
#include <artcal/acquisition/arm/forward_kinematics.h>
#include <artcal/acquisition/recording/recording_file.h>
#include <artcal/acquisition/recording/tip_centres.h>
#include <artcal/artefacts/constraints/bound_recording.h>
#include <artcal/artefacts/verification/decision/specification_file.h>
#include <artcal/artefacts/verification/verify.h>
#include <artcal/core/random.h>
#include <artcal/identification/identify.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace {

bool refuse(const artcal::Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  return false;
}

artcal::Expected<artcal::BoundRecording> bind(artcal::Recording&& recording) {
  return artcal::bind_recording(std::move(recording));
}

bool calibrates(const std::string& examples) {
  const auto readings = artcal::read_recording(examples + "/ball-bar/recording.toml").and_then(bind);
  if (!readings) {
    return refuse(readings.error());
  }
  artcal::IdentifyOptions options;
  options.noise = readings->recording.noise;
  options.leave_out = false;
  const auto identified = artcal::identify(readings->recording, readings->constraints, options);
  if (!identified) {
    return refuse(identified.error());
  }
  const auto test = artcal::read_recording(examples + "/iso10360-12/recording.toml").and_then(bind);
  const auto specification = artcal::read_specification_file(examples + "/iso10360-12/specification.toml");
  if (!test || !specification) {
    return refuse(test ? specification.error() : test.error());
  }
  const auto tips = artcal::tip_centres(test->recording, identified->arm);
  if (!tips) {
    return refuse(tips.error());
  }
  const auto verdict =
      artcal::verify({test->recording, test->constraints, identified->arm, *tips, specification->specification},
                     artcal::Standard::Iso10360_12);
  if (!verdict) {
    return refuse(verdict.error());
  }
  std::printf("%zu readings identified %zu parameters; %zu values verified\n", readings->recording.readings.size(),
              identified->free.size(), verdict->verification.values.size());
  return identified->free.size() >= 21 && verdict->verification.values.size() >= 105;
}

}  // namespace

int main(int argc, char** argv) {
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
  const bool calibrated = argc < 2 || calibrates(argv[1]);
  return right && refused && calibrated && !artcal::arm_file_text(arm, std::nullopt).empty() ? 0 : 1;
}
