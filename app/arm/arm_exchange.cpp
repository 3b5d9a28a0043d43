#include "app/arm/arm_exchange.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/arm/arm_file.h"
#include "acquisition/arm/exchange/calibration_yaml.h"
#include "acquisition/arm/exchange/urdf_text.h"
#include "acquisition/arm/parallel_axes.h"
#include "app/arm/written_arm.h"
#include "app/output/output.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// Which joint of the file is which of the arm, so that a person sees what the columns q1 … qn are.
std::string joints_text(const JointChain& chain) {
  std::vector<std::string> moving, fixed;
  for (const ChainJoint& joint : chain.joints) {
    const std::string name = truncated(40, joint.name);
    if (joint.is_fixed) {
      fixed.push_back(name);
      continue;
    }
    moving.push_back(fmt::format("  q{}  {}{}\n", moving.size() + 1, name,
                                 joint.type == JointType::Prismatic ? " (prismatic)" : ""));
  }
  return fmt::format("{}  tip  {}\n{}", fmt::join(moving, ""), truncated(40, chain.tip),
                     fixed.empty() ? "" : fmt::format("fixed joints, part of the links: {}\n", fmt::join(fixed, ", ")));
}

std::string base_text(const Rigid& base_from_arm) {
  const Eigen::Vector3d& at = base_from_arm.translation;
  const Eigen::Vector3d angles = roll_pitch_yaw_of(base_from_arm.rotation);
  return fmt::format(
      "the arm's base frame is not the file's: it lies there at {:.9g}, {:.9g}, {:.9g} mm, roll, pitch, yaw {:.9g}, "
      "{:.9g}, {:.9g} rad\n",
      at.x(), at.y(), at.z(), angles.x(), angles.y(), angles.z());
}

// What the arm's file does not hold, as --tip-orientation of an export takes it.
std::string tip_text(const Eigen::Matrix3d& last_from_tip) {
  constexpr double same = 1e-12;
  if ((last_from_tip - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < same) {
    return "";
  }
  const Eigen::Vector3d angles = roll_pitch_yaw_of(last_from_tip);
  return fmt::format(
      "the tip's orientation in the last joint's frame is no part of an arm's file; arm export --urdf "
      "--tip-orientation "
      "{:.17g},{:.17g},{:.17g} writes it\n",
      angles.x(), angles.y(), angles.z());
}

std::string import_text(const JointChain& chain, const Arm& arm) {
  const std::string parallel = parallel_axes(arm);
  return fmt::format(
      "arm {}: {} joints, reach {:.6g} mm\n{}{}", in_quotes(arm.name), arm.joints.size(), reach(arm),
      joints_text(chain),
      parallel.empty() ? "" : fmt::format("Hayati's angle `beta` between nearly parallel {}\n", parallel));
}

}  // namespace

Expected<int> ArmImport::run() const {
  const std::filesystem::path path = input;
  if (auto checked = check_outputs({output}, {InputFile{path, ""}}); !checked) {
    return tl::unexpected(checked.error());
  }
  const std::string extension = path.extension().string();
  const bool is_yaml = extension == ".yaml" || extension == ".yml";
  if (is_yaml && !(ends.base.empty() && ends.tip.empty())) {
    return wrong_usage("--base and --tip name links of a URDF; a kinematics file has none");
  }
  const auto chain = is_yaml ? read_calibration_yaml(path) : read_urdf(path, ends);
  if (!chain) {
    return tl::unexpected(chain.error());
  }
  const auto made = arm_of_chain(*chain, own_base);
  if (!made) {
    return bad_input(made.error().message, input);
  }
  const std::string said =
      import_text(*chain, made->arm) + (own_base ? base_text(made->base_from_arm) : "") + tip_text(made->last_from_tip);
  return give_arm(output, quiet, arm_file_text(made->arm, std::nullopt), said);
}

Expected<int> ArmExport::run() const {
  if (!urdf) {
    return wrong_usage("say what to export to: --urdf");
  }
  const auto file = read_arm_file(input);
  if (!file) {
    return tl::unexpected(file.error());
  }
  const auto made = rounding.rounded_arm(file->arm);
  if (!made) {
    return tl::unexpected(made.error());
  }
  if (!tip_orientation.empty() &&
      (tip_orientation.size() != 3 || !Eigen::Vector3d::Map(tip_orientation.data()).allFinite())) {
    return wrong_usage("--tip-orientation takes three angles: roll, pitch, yaw in rad");
  }
  const Eigen::Matrix3d last_from_tip =
      tip_orientation.empty()
          ? Eigen::Matrix3d(Eigen::Matrix3d::Identity())
          : rotation_of_roll_pitch_yaw({tip_orientation[0], tip_orientation[1], tip_orientation[2]});
  const auto text = urdf_text(made->arm, last_from_tip);
  if (!text) {
    return bad_input(text.error().message, input);
  }
  if (auto checked = check_outputs({output}, {file->input}); !checked) {
    return tl::unexpected(checked.error());
  }
  return give_arm(output, quiet, *text, made->said);
}

CLI::App* ArmImport::add_to(CLI::App& parser) {
  CLI::App* command = parser.add_subcommand(
      "import", "an arm from a URDF or from a Universal Robots kinematics file (calibration.yaml)");
  command->add_option("file", input, "robot.urdf or calibration.yaml")->required()->type_name("FILE");
  command->add_option("-o,--output", output, "arm.toml to write; printed where it is not given")->type_name("ARM");
  command->add_option("--base", ends.base, "link of a URDF that is the base; its root if not given")->type_name("LINK");
  command->add_option("--tip", ends.tip, "link of a URDF that is the tip; its only leaf if not given")
      ->type_name("LINK");
  command->add_flag("--own-base", own_base, "lay the base frame on the first axis");
  command->add_flag("--quiet,-q", quiet, "print nothing but errors");
  command->footer("Example:\n  artcal arm import robot.urdf --tip tool0 -o arm.toml");
  return command;
}

CLI::App* ArmExport::add_to(CLI::App& parser) {
  CLI::App* command = parser.add_subcommand("export", "an arm as a URDF");
  command->add_option("arm", input, "arm.toml")->required()->type_name("ARM");
  command->add_flag("--urdf", urdf, "as a URDF");
  command
      ->add_option("--tip-orientation", tip_orientation,
                   "roll, pitch, yaw of the tip's frame in the last joint's frame, rad; zeros if not given")
      ->delimiter(',')
      ->type_name("R,P,Y");
  rounding.add_to(*command);
  command->add_option("-o,--output", output, "file to write; printed where it is not given")->type_name("FILE");
  command->add_flag("--quiet,-q", quiet, "print nothing but errors");
  command->footer("Example:\n  artcal arm export arm.toml --urdf -o arm.urdf");
  return command;
}

}  // namespace artcal
