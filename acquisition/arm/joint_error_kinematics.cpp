#include "acquisition/arm/joint_error_kinematics.h"

#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "acquisition/arm/chain_walk.h"
#include "acquisition/arm/gravity_torques.h"

namespace artcal {
namespace {

// Each pass leaves of the sag's error what a joint's torque changes by its own sag, some 1e-3 of it.
constexpr int sag_passes = 5;
// An angle that a caller forgot becomes no silent zero.
constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, max_joints, max_joints>;
using Tips = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, max_joints>;

constexpr std::size_t index_of(ParameterKind kind) {
  return static_cast<std::size_t>(kind) - static_cast<std::size_t>(ParameterKind::Cosine1);
}

/// How the reading's own numbers multiply each error of a joint, by ParameterKind from Cosine1 to Coupling.
std::array<double, 6> factors_of(const JointReading& reading, std::size_t i) {
  const double sine = reading.sines[2 * i];
  const double cosine = reading.sines[2 * i + 1];
  const bool has_angles = !reading.q.empty();
  return {cosine,
          sine,
          cosine * cosine - sine * sine,
          2.0 * sine * cosine,
          has_angles ? reading.q[i] : not_known,
          i == 0       ? 0.0
          : has_angles ? reading.q[i - 1]
                       : not_known};
}

void put_turned(double* sines, const JointReading& reading, std::size_t i, double turn) {
  const double sine = std::sin(turn);
  const double cosine = std::cos(turn);
  sines[2 * i] = reading.sines[2 * i] * cosine + reading.sines[2 * i + 1] * sine;
  sines[2 * i + 1] = reading.sines[2 * i + 1] * cosine - reading.sines[2 * i] * sine;
}

}  // namespace

Eigen::Vector3d ForwardKinematics::walk_frames(const Posture& posture, Frames& frames) const {
  return walk(posture.sines.data(), posture.travels.data(), posture.grown(),
              [&](std::size_t i, const Frame& frame) { frames.at[i] = frame; });
}

WeighedChain ForwardKinematics::weighed(const Frames& frames, const Eigen::Vector3d& tip) const {
  WeighedChain chain;
  chain.joints = links_.size();
  for (std::size_t i = 0; i < chain.joints; ++i) {
    chain.axes[i] = frames.at[i].z;
    chain.points[i] = frames.at[i].z_at;
    chain.weights[i] = errors_[i].weight;
  }
  chain.points[chain.joints] = tip;
  return chain;
}

ForwardKinematics::Posture ForwardKinematics::posture_of(const JointReading& reading) const {
  Posture posture;
  posture.temperature_offset = std::isnan(reading.temperature) ? 0.0 : reading.temperature - reference_temperature_;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const JointErrors& size = errors_[i].size;
    posture.expansion_factor[i] = 1.0 + size.expansion * posture.temperature_offset;
    if (links_[i].is_prismatic) {
      assert(!reading.q.empty());
      posture.travels[i] = (1.0 + size.gain) * reading.q[i];
      put_turned(posture.sines.data(), reading, i, 0.0);
      continue;
    }
    assert(!reading.q.empty() || (size.gain == 0.0 && size.coupling == 0.0));
    const auto by = factors_of(reading, i);
    posture.turns[i] = size.cosine[0] * by[0] + size.sine[0] * by[1] + size.cosine[1] * by[2] + size.sine[1] * by[3] +
                       (size.gain != 0.0 ? size.gain * by[4] : 0.0) +
                       (size.coupling != 0.0 ? size.coupling * by[5] : 0.0);
    put_turned(posture.sines.data(), reading, i, posture.turns[i]);
  }
  for (int pass = 0; sags_ && pass < sag_passes; ++pass) {
    Frames frames;
    const Eigen::Vector3d tip = walk_frames(posture, frames);
    posture.torques = weighed(frames, tip).torques();
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const double sag = links_[i].sign * errors_[i].size.compliance * posture.torques[i];
      put_turned(posture.sines.data(), reading, i, posture.turns[i] + sag);
    }
  }
  return posture;
}

/// What the derivatives need of one posture: the tip by each joint angle φ = θ + sign·q', the sag's answer included,
/// and by the torques that a parameter changes beside.
struct ForwardKinematics::Slopes {
  Tips by_angle;   // B⁻¹ included
  Tips by_torque;  // the same times the compliances

  [[nodiscard]] Eigen::Vector3d of(const WeighedChain::Torques& change) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < by_torque.cols(); ++i) {
      sum += change[static_cast<std::size_t>(i)] * by_torque.col(i);
    }
    return sum;
  }
};

ForwardKinematics::Slopes ForwardKinematics::slopes_of(const Frames& frames, const WeighedChain& chain) const {
  const auto count = static_cast<Eigen::Index>(links_.size());
  const Eigen::Vector3d& tip = chain.points[links_.size()];
  Slopes slopes{Tips(3, count), Tips::Zero(3, count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Frame& frame = frames.at[static_cast<std::size_t>(i)];
    slopes.by_angle.col(i) = frame.z.cross(tip - frame.z_at);
  }
  if (!sags_) {
    return slopes;
  }
  Square answer = Square::Identity(count, count);
  for (Eigen::Index j = 0; j < count; ++j) {
    const Frame& frame = frames.at[static_cast<std::size_t>(j)];
    const auto change = chain.change({static_cast<std::size_t>(j) + 1, frame.z, frame.z_at});
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto joint = static_cast<std::size_t>(i);
      answer(i, j) -= errors_[joint].size.compliance * change[joint];
    }
  }
  slopes.by_angle = answer.transpose().partialPivLu().solve(slopes.by_angle.transpose()).transpose().eval();
  for (Eigen::Index i = 0; i < count; ++i) {
    slopes.by_torque.col(i) = errors_[static_cast<std::size_t>(i)].size.compliance * slopes.by_angle.col(i);
  }
  return slopes;
}

Eigen::Vector3d ForwardKinematics::put_with_errors(const JointReading& reading, double* derivative) const {
  const Posture posture = posture_of(reading);
  Frames frames;
  const Eigen::Vector3d tip = walk_frames(posture, frames);
  const WeighedChain chain = weighed(frames, tip);
  const Slopes slopes = slopes_of(frames, chain);
  // What moves all that is further out moves the tip, and with the torques the joints.
  const auto put_motion = [&](int column, const WeighedChain::Motion& motion) {
    if (column >= 0) {
      const Eigen::Vector3d moved = motion.turn.cross(tip - motion.at) + motion.shift;
      put(derivative, column, sags_ ? Eigen::Vector3d(moved + slopes.of(chain.change(motion))) : moved);
    }
  };
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  const Frame& last = frames.at[links_.size()];
  const double tip_expansion_factor = posture.expansion_factor[links_.size() - 1];
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const Link& link = links_[i];
    const Frame& frame = frames.at[i];
    const double expansion_factor = posture.expansion_factor[i];
    const std::size_t after_link = convention_ == Convention::Standard ? i + 1 : i;
    put_motion(link.column_a, {after_link, none, none, expansion_factor * frame.x});
    put_motion(link.column_d, {i + 1, none, none, expansion_factor * frame.z});
    put(derivative, link.column_theta, slopes.by_angle.col(static_cast<Eigen::Index>(i)));
    put_motion(link.column_alpha, {after_link, frame.x, frame.x_at, none});
    if (link.has_beta) {
      put_motion(link.column_beta, {after_link, frame.y, frame.x_at, none});
    }
    const auto& columns = errors_[i].columns;
    const auto by = factors_of(reading, i);
    if (link.is_prismatic) {
      const double travel = reading.q.empty() ? not_known : reading.q[i];
      put_motion(columns[index_of(ParameterKind::Gain)], {i + 1, none, none, link.sign * travel * frame.z});
    }
    for (std::size_t kind = 0; kind < by.size() && !link.is_prismatic; ++kind) {
      assert(columns[kind] < 0 || kind < index_of(ParameterKind::Gain) || !reading.q.empty());
      put(derivative, columns[kind], link.sign * by[kind] * slopes.by_angle.col(static_cast<Eigen::Index>(i)));
    }
    put(derivative, columns[index_of(ParameterKind::Compliance)],
        posture.torques[i] * slopes.by_angle.col(static_cast<Eigen::Index>(i)));
    if (const int column = columns[index_of(ParameterKind::Expansion)]; column >= 0) {
      const bool ends = i + 1 == links_.size();
      const Eigen::Vector3d tip_in_base =
          tip_in_last_.x() * last.x + tip_in_last_.y() * last.y + tip_in_last_.z() * last.z;
      const WeighedChain::Motion along_x{after_link, none, none, posture.temperature_offset * link.a * frame.x};
      const WeighedChain::Motion along_z{i + 1, none, none,
                                         posture.temperature_offset * (link.d * frame.z + (ends ? tip_in_base : none))};
      put(derivative, column,
          along_x.shift + along_z.shift + slopes.of(chain.change(along_x)) + slopes.of(chain.change(along_z)));
    }
  }
  const std::array<Eigen::Vector3d, 3> tip_axes{last.x, last.y, last.z};
  for (std::size_t k = 0; k < 3; ++k) {
    put_motion(column_tip_[k], {links_.size(), none, none, tip_expansion_factor * tip_axes[k]});
  }
  return tip;
}

Eigen::Vector3d ForwardKinematics::put_by_joints_with_errors(const JointReading& reading, double* derivative) const {
  const Posture posture = posture_of(reading);
  Frames frames;
  const Eigen::Vector3d tip = walk_frames(posture, frames);
  const WeighedChain chain = weighed(frames, tip);
  const Slopes slopes = slopes_of(frames, chain);
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < links_.size(); ++i) {
    const JointErrors& size = errors_[i].size;
    if (links_[i].is_prismatic) {
      const Eigen::Vector3d shift = links_[i].sign * (1.0 + size.gain) * frames.at[i].z;
      put(derivative, static_cast<int>(i),
          sags_ ? Eigen::Vector3d(shift + slopes.of(chain.change({i + 1, none, none, shift}))) : shift);
      continue;
    }
    const auto by = factors_of(reading, i);
    const double turn = 1.0 + size.gain - size.cosine[0] * by[1] + size.sine[0] * by[0] - 2.0 * size.cosine[1] * by[3] +
                        2.0 * size.sine[1] * by[2];
    Eigen::Vector3d slope = links_[i].sign * turn * slopes.by_angle.col(static_cast<Eigen::Index>(i));
    if (i + 1 < links_.size()) {
      slope +=
          links_[i + 1].sign * errors_[i + 1].size.coupling * slopes.by_angle.col(static_cast<Eigen::Index>(i) + 1);
    }
    put(derivative, static_cast<int>(i), slope);
  }
  return tip;
}

}  // namespace artcal
