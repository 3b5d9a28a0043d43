#include "acquisition/arm/exchange/calibration_yaml.h"

#include <array>
#include <cmath>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "core/files/text_file.h"
#include "core/number_range.h"
#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr std::size_t largest_file = std::size_t{1} << 16;  // has less than 1 kB; YAML's readers are slow with much

std::string mark_in(const std::filesystem::path& path, const YAML::Mark& mark) {
  return mark.line < 0 ? path.string() : fmt::format("{}:{}:{}", path.string(), mark.line + 1, mark.column + 1);
}

Expected<double> number_at(const std::filesystem::path& path, const YAML::Node& frame, const std::string& name,
                           const char* key) {
  const YAML::Node found = frame[key];
  double number = 0.0;
  if (!found || !found.IsScalar() || !YAML::convert<double>::decode(found, number) || !is_in_range(number)) {
    return bad_input(fmt::format("`{}` of {} is {}, expected a number (m, rad)", key, in_quotes(name),
                                 found && found.IsScalar() ? in_quotes(found.Scalar()) : "not there"),
                     mark_in(path, found ? found.Mark() : frame.Mark()));
  }
  return number;
}

Expected<JointChain> chain_of(const std::filesystem::path& path, const YAML::Node& root) {
  const YAML::Node kinematics = root.IsMap() ? root["kinematics"] : YAML::Node();
  if (!kinematics || !kinematics.IsMap()) {
    return bad_input(
        "the file has no map `kinematics`, expected a Universal Robots kinematics file as ur_calibration writes it",
        path.string());
  }
  JointChain chain;
  chain.name = path.stem().string();
  chain.tip = "flange";
  for (const char* name : {"shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3"}) {
    const YAML::Node frame = kinematics[name];
    if (!frame || !frame.IsMap()) {
      return bad_input(fmt::format("`kinematics` has no frame {}", in_quotes(name)), mark_in(path, kinematics.Mark()));
    }
    std::array<double, 6> numbers{};
    constexpr std::array keys{"x", "y", "z", "roll", "pitch", "yaw"};
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const auto number = number_at(path, frame, name, keys[i]);
      if (!number) {
        return tl::unexpected(number.error());
      }
      numbers[i] = *number;
    }
    ChainJoint& joint = chain.joints.emplace_back();
    joint.name = name;
    joint.parent_from_joint = {rotation_of_roll_pitch_yaw({numbers[3], numbers[4], numbers[5]}),
                               units::metre * Eigen::Vector3d(numbers[0], numbers[1], numbers[2])};
  }
  return chain;
}

}  // namespace

Expected<JointChain> read_calibration_yaml(const std::filesystem::path& path) {
  const auto file = read_text_file(path, largest_file);
  if (!file) {
    return tl::unexpected(file.error());
  }
  try {
    return chain_of(path, YAML::Load(file->text));
  } catch (const YAML::Exception& error) {
    return bad_input(fmt::format("this is no YAML that can be read ({})", truncated(200, error.msg)),
                     mark_in(path, error.mark));
  }
}

}  // namespace artcal
