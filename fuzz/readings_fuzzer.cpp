#include "acquisition/recording/readings_file.h"
#include "core/units.h"
#include "fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  Recording recording;
  recording.arm.joints.resize(2);
  recording.arm.probes.resize(2);
  recording.arm.probes[0].name = "ball";
  recording.arm.probes[1].name = "star";
  const auto path = fuzzing::folder().write("readings.csv", fuzzing::bytes_of(data, size));
  const auto read = read_readings(path, {units::degree, 1.0}, recording);
  if (!read) {
    fuzzing::require_sentence(read.error());
    return 0;
  }
  fuzzing::require(!recording.readings.empty() && recording.joints.allFinite());
  fuzzing::require(recording.joints.cols() == static_cast<Eigen::Index>(recording.readings.size()));
  (void)suspicious_angles(recording, units::degree);
  return 0;
}
