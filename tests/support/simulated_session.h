#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "acquisition/recording/recording.h"
#include "artefacts/artefact/artefact.h"
#include "core/normal_vector.h"
#include "core/random.h"
#include "core/rigid.h"
#include "tests/support/arms.h"
#include "tests/support/forward_kinematics.h"

/// Sessions of an arm on artefacts, made up for tests with the arm's equations from forward_kinematics.h alone:
/// neither the pass nor virtual_probing.h has a part in them.
namespace artcal::testing {

/// Errors of a real arm on top of a nominal one. The last joint's a and d and what only moves the base stay, so
/// that what is held holds the truth.
inline Arm arm_with_errors(Arm arm, RandomStream& random, double mm, double rad) {
  for (Joint& joint : arm.joints) {
    const bool first = &joint == &arm.joints.front();
    const bool last = &joint == &arm.joints.back();
    joint.a += last ? 0.0 : mm * random.normal();
    joint.d += first || last ? 0.0 : mm * random.normal();
    joint.theta += first ? 0.0 : rad * random.normal();
    joint.alpha += rad * random.normal();
  }
  for (Probe& probe : arm.probes) {
    probe.tip_in_last.z() += mm * random.normal();
  }
  return arm;
}

struct SessionNoise {
  double encoder = 2.0 / 3600.0 * std::numbers::pi / 180.0;  ///< rad
  double probing = 0.003;                                    ///< mm
};

inline bool has_joint_errors(const Arm& arm) {
  const auto all = all_parameters(arm);
  return std::any_of(all.begin(), all.end(), [&](const Parameter& parameter) {
    return parameter.is_joint_error() && value(arm, parameter) != 0.0;
  });
}

/// Reads artefacts with a true arm, and writes down what its encoders say.
class Session {
 public:
  Session(const Arm& nominal, const Arm& truth, std::uint64_t seed, SessionNoise noise = {})
      : truth_(truth), numbers_(truth), random_(seed, "session"), noise_(noise) {
    recording_.name = "session";
    recording_.arm = nominal;
    recording_.files.emplace_back("session");
    recording_.joints.resize(static_cast<Eigen::Index>(nominal.joints.size()), 0);
  }

  /// A pose in front of the arm, well within reach.
  Rigid pose() {
    const Eigen::Vector3d direction = random_.direction();
    const Eigen::Vector3d place = random_.uniform(0.25, 0.5) * reach(truth_) * direction;
    return {random_.rotation(), place + Eigen::Vector3d(0.0, 0.0, truth_.joints.front().d)};
  }

  /// `count` readings with the tip's centre at target(i), each in a posture of its own.
  template <typename Target>
  void read(const std::string& artefact, const std::string& placement, const std::string& feature, int count,
            Target&& target, int probe = 0) {
    for (int i = 0; i < count; ++i) {
      const Eigen::Vector3d noise = noise_.probing * normal_vector(random_);
      const Eigen::Vector3d wanted = target(i) + noise;
      Eigen::VectorXd q = posture(wanted, probe);
      for (double& angle : q) angle += noise_.encoder * random_.normal();
      Reading reading;
      reading.artefact = recording_.artefacts.index_of(artefact);
      reading.placement = recording_.placements.index_of(placement);
      reading.feature = recording_.features.index_of(feature);
      reading.orientation = recording_.orientations.index_of("");
      reading.repeat = recording_.repeats.index_of("");
      reading.probe = probe;
      reading.arm_temperature = arm_temperature_;
      reading.line = static_cast<int>(recording_.readings.size()) + 1;
      recording_.readings.push_back(reading);
      recording_.joints.conservativeResize(Eigen::NoChange, recording_.joints.cols() + 1);
      recording_.joints.rightCols<1>() = q;
    }
  }

  /// Readings all over a ball, on the side away from `stand` (unit; what holds the ball).
  void read_ball(const std::string& artefact, const std::string& placement, const std::string& feature, int count,
                 const Eigen::Vector3d& centre, double radius, const Eigen::Vector3d& stand, int probe = 0) {
    const double length = radius + truth_.probes[probe].radius;
    read(
        artefact, placement, feature, count,
        [&](int) {
          const Eigen::Vector3d direction = random_.direction();
          return Eigen::Vector3d(centre + length * (direction.dot(stand) > 0.0 ? -direction : direction));
        },
        probe);
  }

  /// Readings of a plane through `at` with the outward normal `normal`, within `extent` of `at`.
  void read_plane(const std::string& artefact, const std::string& placement, const std::string& feature, int count,
                  const Eigen::Vector3d& at, const Eigen::Vector3d& normal, double extent, int probe = 0) {
    read(
        artefact, placement, feature, count,
        [&](int) {
          const Eigen::Vector3d across = normal.cross(random_.direction()).normalized();
          return Eigen::Vector3d(at + extent * std::sqrt(random_.uniform()) * across +
                                 truth_.probes[probe].radius * normal);
        },
        probe);
  }

  /// Of the arm, from now on, °C; it stands in the readings.
  void set_arm_temperature(double temperature) { arm_temperature_ = temperature; }

  [[nodiscard]] const Arm& truth() const { return truth_; }
  RandomStream& random() { return random_; }
  Recording& recording() { return recording_; }

 private:
  Eigen::Vector3d tip(const Eigen::VectorXd& q, int probe) const {
    if (!has_joint_errors_) return rigid_tip(q, probe);
    const double temperature_offset =
        std::isnan(arm_temperature_) ? 0.0 : arm_temperature_ - truth_.reference_temperature;
    return tip_with_errors(numbers_, std::vector<double>(q.begin(), q.end()), probe, temperature_offset);
  }

  Eigen::Vector3d rigid_tip(const Eigen::VectorXd& q, int probe) const {
    return tip_in_base(numbers_, std::vector<double>(q.begin(), q.end()), probe);
  }

  // Damped Gauss-Newton with differences, from random starts; joint errors change the slope by little.
  Eigen::VectorXd posture(const Eigen::Vector3d& wanted, int probe) {
    Eigen::VectorXd q(static_cast<Eigen::Index>(truth_.joints.size()));
    for (int start = 0; start < 200; ++start) {
      for (double& angle : q) angle = random_.uniform(-std::numbers::pi, std::numbers::pi);
      for (int iteration = 0; iteration < 60; ++iteration) {
        const Eigen::Vector3d miss = wanted - tip(q, probe);
        if (miss.norm() < 1e-10) return q;
        Eigen::Matrix3Xd slope(3, q.size());
        for (Eigen::Index j = 0; j < q.size(); ++j) {
          const Eigen::VectorXd step = 1e-6 * Eigen::VectorXd::Unit(q.size(), j);
          slope.col(j) = (rigid_tip(q + step, probe) - rigid_tip(q - step, probe)) / 2e-6;
        }
        const Eigen::Matrix3d normal = slope * slope.transpose() + miss.norm() * Eigen::Matrix3d::Identity();
        const Eigen::VectorXd step = slope.transpose() * normal.ldlt().solve(miss);
        q += step * std::min(1.0, 0.5 / step.cwiseAbs().maxCoeff());
      }
    }
    throw std::runtime_error("the simulated arm does not reach its target");
  }

  Arm truth_;
  ArmNumbers<double> numbers_;
  RandomStream random_;
  SessionNoise noise_;
  Recording recording_;
  double arm_temperature_ = Reading::not_read;
  bool has_joint_errors_ = testing::has_joint_errors(truth_);
};

inline CertifiedFeature feature_of(std::string name, FeatureKind kind) {
  CertifiedFeature feature;
  feature.name = std::move(name);
  feature.kind = kind;
  return feature;
}

/// Error of random lengths in the working volume, both ends at random postures, mm rms: what an identified arm is
/// judged by. By the independent kinematics.
inline double length_rms(const Arm& truth, const Arm& arm, int count = 2000) {
  const ArmNumbers<double> true_numbers(truth);
  const ArmNumbers<double> numbers(arm);
  RandomStream random(1, "lengths in the volume");
  double squares = 0.0;
  for (int i = 0; i < count; ++i) {
    Eigen::Vector3d true_apart = Eigen::Vector3d::Zero();
    Eigen::Vector3d apart = Eigen::Vector3d::Zero();
    for (const double end : {-1.0, 1.0}) {
      std::vector<double> q(truth.joints.size());
      for (double& angle : q) angle = random.uniform(-std::numbers::pi, std::numbers::pi);
      true_apart += end * tip_in_base(true_numbers, q, 0);
      apart += end * tip_in_base(numbers, q, 0);
    }
    squares += std::pow(apart.norm() - true_apart.norm(), 2);
  }
  return std::sqrt(squares / count);
}

}  // namespace artcal::testing
