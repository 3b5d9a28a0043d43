#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "acquisition/arm/arm.h"
#include "artefacts/virtual_probing/postures.h"
#include "core/normal_vector.h"
#include "core/random.h"
#include "tests/support/arms.h"

namespace artcal::testing {

/// A ball bar in the air, scanned with the tip of an arm sliding over its balls.
struct ArmScanSettings {
  std::uint64_t seed = 1;
  std::vector<double> places{0.0, 250.0, 600.0};  ///< of the balls along the bar, mm
  double ball_radius = 12.7;
  int points = 150;       ///< on each ball
  int stem_points = 30;   ///< on each ball's stem
  int stray_points = 30;  ///< on nothing
  double noise = 0.01;    ///< of each coordinate of a touch, mm
  double wiggle = 0.3;    ///< by which each joint's start differs from ball to ball, rad
};

struct ArmScan {
  std::vector<Eigen::VectorXd> joints;  ///< rad
  std::vector<int> labels;              ///< the ball, or -1
};

inline Arm arm_with_ball_tip() {
  Arm arm = test::gao_arm();
  arm.probes[0].radius = 3.0;
  return arm;
}

/// The arm as it is: every length off by up to 0.3 mm, every angle by up to 0.1 degrees.
inline Arm planted_errors(Arm arm, std::uint64_t seed, double times = 1.0) {
  RandomStream random(seed, "planted");
  const double mm = 0.3 * times;
  const double angle = times * 0.1 * 3.14159265 / 180.0;
  for (Joint& joint : arm.joints) {
    joint.a += random.uniform(-mm, mm);
    joint.d += random.uniform(-mm, mm);
    joint.theta += random.uniform(-angle, angle);
    joint.alpha += random.uniform(-angle, angle);
  }
  arm.probes[0].tip_in_last.z() += random.uniform(-mm, mm);
  return arm;
}

/// The joint angles are those of the true arm; nothing is known here of a nominal one.
class ArmScanSimulation {
 public:
  ArmScanSimulation(const Arm& arm, const ArmScanSettings& settings)
      : arm_(arm), s_(settings), random_(settings.seed, "arm scan") {}

  ArmScan run() {
    for (int attempt = 0; attempt < 100; ++attempt) {
      if (scan_somewhere()) {
        return scan_;
      }
    }
    throw std::runtime_error("the bar is out of reach wherever it stands");
  }

 private:
  using V = Eigen::Vector3d;

  bool scan_somewhere() {
    scan_ = {};
    const V direction = random_.direction();
    const V start = random_.uniform(500.0, 1000.0) * direction;
    const V along = random_.direction();
    const V stem = along.unitOrthogonal();
    Eigen::VectorXd posture(static_cast<Eigen::Index>(arm_.joints.size()));
    for (double& angle : posture) angle = random_.uniform(-3.1, 3.1);
    for (std::size_t ball = 0; ball < s_.places.size(); ++ball) {
      Eigen::VectorXd q = posture;
      for (double& angle : q) angle += random_.uniform(-s_.wiggle, s_.wiggle);
      if (!slide_over(static_cast<int>(ball), start + s_.places[ball] * along, stem, q)) {
        return false;
      }
    }
    return true;
  }

  bool slide_over(int label, const V& centre, const V& stem, Eigen::VectorXd q) {
    const V side = stem.unitOrthogonal();
    const V other = stem.cross(side);
    const double radius = s_.ball_radius + arm_.probes[0].radius;
    const double stem_radius = s_.ball_radius / 3.0 + arm_.probes[0].radius;
    for (int i = 0; i < s_.points; ++i) {  // a spiral from the pole away from the stem
      const double z = 1.0 - 1.3 * (i + 0.5) / s_.points;
      const double turn = 2.4 * std::sqrt(static_cast<double>(i)) * 2.0;
      const double r = std::sqrt(1.0 - z * z);
      if (!touch(centre + radius * (-z * stem + r * (std::cos(turn) * side + std::sin(turn) * other)), label, q)) {
        return false;
      }
    }
    for (int i = 0; i < s_.stem_points; ++i) {
      const double turn = random_.uniform(0.0, 6.28);
      (void)touch(centre + random_.uniform(1.0, 2.5) * radius * stem +
                      stem_radius * (std::cos(turn) * side + std::sin(turn) * other),
                  -1, q);
    }
    for (int i = 0; i < s_.stray_points; ++i) {
      const V direction = random_.direction();
      (void)touch(centre + random_.uniform(1.2, 4.0) * radius * direction, -1, q);
    }
    return true;
  }

  bool touch(const V& tip, int label, Eigen::VectorXd& q) {
    const V noise = normal_vector(random_);
    const auto reached = reach_with_joints(arm_, 0, tip + s_.noise * noise, q);
    if (reached) {
      q = *reached;
      scan_.joints.push_back(q);
      scan_.labels.push_back(label);
    }
    return reached.has_value();
  }

  const Arm& arm_;
  ArmScanSettings s_;
  RandomStream random_;
  ArmScan scan_;
};

inline ArmScan scan_with_arm(const Arm& arm, const ArmScanSettings& settings) {
  return ArmScanSimulation(arm, settings).run();
}

/// A text file of it: coordinates that mean nothing, joint angles in degrees.
inline std::string text_of(const ArmScan& scan) {
  std::string text = "x y z";
  for (Eigen::Index joint = 0; joint < scan.joints.front().size(); ++joint) text += fmt::format(" q{}", joint + 1);
  text += "\n";
  for (std::size_t i = 0; i < scan.joints.size(); ++i) {
    text += fmt::format("{} 0 0", i);
    for (const double q : scan.joints[i]) text += fmt::format(" {:.9f}", q * 180.0 / 3.14159265358979323846);
    text += "\n";
  }
  return text;
}

/// What a certificate says of the bar.
inline std::string bar_file(const ArmScanSettings& settings) {
  std::string text = "schema = \"artcal-artefact/1\"\nname = \"bar\"\nunits = { length = \"mm\" }\n";
  for (std::size_t i = 0; i < settings.places.size(); ++i) {
    text += fmt::format("[[feature]]\nname = \"{}\"\nkind = \"sphere\"\ndiameter = {}\n", static_cast<char>('A' + i),
                        2.0 * settings.ball_radius);
  }
  for (std::size_t i = 0; i < settings.places.size(); ++i) {
    for (std::size_t j = i + 1; j < settings.places.size(); ++j) {
      text += fmt::format("[[distance]]\nbetween = [\"{}\", \"{}\"]\nvalue = {}\nU = 0.001\nk = 2\n",
                          static_cast<char>('A' + i), static_cast<char>('A' + j),
                          std::abs(settings.places[j] - settings.places[i]));
    }
  }
  return text;
}

}  // namespace artcal::testing
