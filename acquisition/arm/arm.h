#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace artcal {

/// How four numbers place one joint's frame after the one before.
///
/// Standard (Denavit, Hartenberg 1955; Gao 2013 Eq. 1):
///     T(i-1,i) = Rz(θi + sign·qi) · Tz(di) · Tx(ai) · Rx(αi) · Ry(βi)
/// Modified (Craig 1986), where a and alpha are those of the link before, a(i-1) and α(i-1):
///     T(i-1,i) = Rx(α(i-1)) · Tx(a(i-1)) · Ry(β(i-1)) · Rz(θi + sign·qi) · Tz(di)
/// Of a prismatic joint θi stands alone and the length along z is di + sign·qi.
/// β is Hayati's angle for neighbouring axes that are nearly parallel, where d does not exist as a
/// smooth function of the axes; it is zero unless the joint is told to have it.
enum class Convention { Standard, Modified };

/// How a joint moves the links behind it: about its z axis, or along it.
enum class JointType { Revolute, Prismatic };

/// What makes a joint turn by something else than its encoder shows, and its link be of another length. The chain
/// of Convention is that of the angles q' and of the lengths at the arm's temperature T:
///     q'i = qi + gain·qi + (mechanical_coupling + coupling)·q(i-1) + Σ cosine·cos(h·qi) + sine·sin(h·qi)
///           + sign·compliance·τi,  h = 1, 2
///     ai, di and, after the last joint, the tip grow by 1 + expansion·(T − reference temperature)
/// τi is the torque of the weight of all links further out about axis i, in the posture q', a link's mass sitting
/// halfway between a point on its axis and one on the next (after the last: the tip). All are zero for a rigid arm.
/// A prismatic joint has a gain (of its scale) and an expansion only.
struct JointErrors {
  std::array<double, 2> cosine{}, sine{};  ///< of the encoder's first and second harmonic, rad
  double gain = 0.0;                       ///< rad/rad
  double coupling = 0.0;                   ///< to the joint before, rad/rad; of the first joint it means nothing
  double compliance = 0.0;                 ///< rad/(N·mm)
  double expansion = 0.0;                  ///< of the link, 1/K
};

/// One joint. Lengths in mm, angles in rad.
struct Joint {
  double a = 0.0;
  double d = 0.0;
  double theta = 0.0;  ///< offset of the encoder's zero
  double alpha = 0.0;
  double beta = 0.0;
  double sign = 1.0;                                ///< +1, or -1 where the encoder counts against the axis
  bool has_beta = false;                            ///< β is a parameter of this joint
  std::optional<double> lowest = {}, highest = {};  ///< readings at the ends of its travel, where they are stated
  JointErrors errors = {};
  std::optional<double> mass = {};  ///< of the link that the joint carries, kg; where it is stated
  JointType type = JointType::Revolute;
  /// A convention of the machine, not an error: the reading of the joint is not stated against the link before it, and
  /// what the joint turns by is q + mechanical_coupling·q(i-1). 1 where a joint is stated against the ground (FANUC
  /// J3).
  double mechanical_coupling = 0.0;

  [[nodiscard]] bool is_prismatic() const { return type == JointType::Prismatic; }
};

/// What is mounted on the last joint. `tip_in_last` is the centre of the tip ball (or the point of a
/// pointed tip) in the last joint's frame, mm.
struct Probe {
  std::string name = "probe";
  Eigen::Vector3d tip_in_last = Eigen::Vector3d::Zero();
  double radius = 0.0;   ///< of the tip ball, mm
  bool on_axis = false;  ///< stated as `l`: the tip lies on the last frame's z axis, lx = ly = 0
};

/// More joints than any arm has; what walks along an arm keeps its frames on the stack.
inline constexpr int max_joints = 24;

/// An arm of 1 to max_joints joints, with one or several probes. It is data: algorithms read it.
struct Arm {
  std::string name;
  Convention convention = Convention::Standard;
  std::vector<Joint> joints;
  std::vector<Probe> probes;
  Eigen::Vector3d gravity_in_base{0.0, 0.0, -9.80665};  ///< m/s²
  double reference_temperature = 20.0;                  ///< at which a, d and the tips are stated, °C
};

/// Whether every joint states the mass of its link.
bool has_masses(const Arm& arm);

/// Whether any joint is prismatic.
bool has_prismatic_joints(const Arm& arm);

/// Whether the arm's lengths depend on its temperature.
bool expands(const Arm& arm);

/// The length of the arm stretched out, from its first axis to the tip of its longest probe: the sum of |a| and |d|
/// after the first joint's d, and |tip|. Of d along nearly parallel axes that cancel, only what is left of them counts.
/// Where a d is still more than twice what the arm can reach (stretched_length.h), the sum says where Denavit and
/// Hartenberg put the frames, not how long the arm is: the latter counts.
double reach(const Arm& arm);

/// Index of the probe by name, or -1.
int probe_index(const Arm& arm, const std::string& name);

}  // namespace artcal
