// Writes the readings of examples/iso10360-12 and examples/sphere-plate anew: simulated, with known truth.
//     write_verification_examples SOURCE_DIR
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <fmt/os.h>
#include <Eigen/Geometry>

#include "acquisition/arm/arm_file.h"
#include "artefacts/artefact/artefact_file.h"
#include "artefacts/virtual_probing/postures.h"
#include "core/units.h"
#include "tests/support/reported_readings.h"

namespace {

using namespace artcal;
using Directions = std::vector<Eigen::Vector3d>;

template <typename T>
T required(Expected<T> value) {
  if (!value) {
    fmt::print(stderr, "{}\n", value.error().text());
    std::exit(1);
  }
  return std::move(*value);
}

Eigen::Vector3d normal(RandomStream& random) { return {random.normal(), random.normal(), random.normal()}; }

Eigen::VectorXd random_posture(RandomStream& random) {
  return Eigen::VectorXd::NullaryExpr(6, [&] { return random.uniform(-std::numbers::pi, std::numbers::pi); });
}

/// A person with the true arm: 2″ of noise in each encoder, 3 µm a coordinate in the tip.
class TrueArm {
 public:
  TrueArm(Arm truth, std::string path) : truth_(std::move(truth)), file_(fmt::output_file(path)) {
    file_.print("artefact,placement,feature,orientation,repeat,temperature,q1,q2,q3,q4,q5,q6\n");
  }

  void touch(const testing::Label& label, const Eigen::Vector3d& centre, double radius, const Directions& directions,
             double temperature) {
    Eigen::VectorXd start = random_posture(random_);
    for (const auto& direction : directions) {
      const Eigen::Vector3d target = centre + (radius + truth_.probes[0].radius) * direction + 0.003 * normal(random_);
      auto q = reach_with_joints(truth_, 0, target, start);
      while (!q) {
        start = random_posture(random_);
        q = reach_with_joints(truth_, 0, target, start);
      }
      write(label, *q, temperature);
    }
  }

 private:
  void write(const testing::Label& label, const Eigen::VectorXd& q, double temperature) {
    file_.print("{},{},{},{},{},{:.1f}", label.artefact, label.placement, label.feature, label.orientation,
                label.repeat, temperature);
    for (const double angle : q) {
      const double turned = std::remainder(angle + 2.0 * units::arcsecond * random_.normal(), 2.0 * std::numbers::pi);
      file_.print(",{:.6f}", turned / units::degree);
    }
    file_.print("\n");
  }

  Arm truth_;
  fmt::ostream file_;
  RandomStream random_{2026, "examples/iso10360-12"};
};

Rigid bar_pose(double azimuth, double height, const Eigen::Vector3d& along) {
  const Eigen::Vector3d centre =
      900.0 * Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), 0.0) + Eigen::Vector3d(0.0, 0.0, 300.0 + height);
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), along);
  return {turn.toRotationMatrix(), centre};
}

void write_lengths(TrueArm& arm, const Artefact& bar) {
  constexpr double temperature = 20.6;
  const double expansion_factor = bar.expansion_factor(temperature);
  const std::vector<Rigid> base_from_bar{
      bar_pose(0.3, 0.0, {0.0, 0.0, 1.0}),    bar_pose(1.9, 100.0, {1.0, 0.0, 0.0}),
      bar_pose(3.3, -100.0, {0.0, 1.0, 0.0}), bar_pose(4.6, 0.0, {1.0, 1.0, 0.0}),
      bar_pose(5.5, 200.0, {1.0, 1.0, 1.0}),  bar_pose(2.6, -200.0, {1.0, -1.0, 1.0}),
      bar_pose(1.0, 50.0, {-1.0, 1.0, 0.5})};
  for (std::size_t position = 0; position < base_from_bar.size(); ++position) {
    for (int repeat = 1; repeat <= 3; ++repeat) {
      for (std::size_t i = 0; i < bar.features.size(); ++i) {
        const double from_a = i == 0 ? 0.0 : bar.distances[i - 1].value;
        arm.touch({"bar", fmt::format("{}", position + 1), bar.features[i].name, "", fmt::format("{}", repeat)},
                  base_from_bar[position] * Eigen::Vector3d(expansion_factor * (from_a - 600.0), 0.0, 0.0),
                  expansion_factor * *bar.features[i].radius, testing::pattern_5_wide(), temperature);
      }
    }
  }
}

void write_iso10360_12(const std::string& source) {
  const std::string folder = source + "/examples/iso10360-12/";
  TrueArm arm(required(read_arm_file(source + "/tests/reference/aacmm-simulated/truth-arm.toml")).arm,
              folder + "readings.csv");
  const Artefact ball = required(read_artefact_file(folder + "ball.toml")).artefact;
  for (const auto& [placement, centre] : {std::pair{"ball 1", Eigen::Vector3d(700.0, 300.0, 200.0)},
                                          std::pair{"ball 2", Eigen::Vector3d(-300.0, -900.0, 500.0)}}) {
    arm.touch({"ball", placement, "ball", "", ""}, centre, *ball.features[0].radius, testing::pattern_25(), 20.5);
    for (int orientation = 1; orientation <= 5; ++orientation) {
      arm.touch({"ball", placement, "ball", fmt::format("{}", orientation), ""}, centre, *ball.features[0].radius,
                testing::pattern_5_wide(), 20.5);
    }
  }
  write_lengths(arm, required(read_artefact_file(folder + "bar.toml")).artefact);
}

// An arm that reports coordinates, 3 µm of noise; ball C4 sits 10 µm beside its certified place.
void write_sphere_plate(const std::string& source) {
  const std::string folder = source + "/examples/sphere-plate/";
  const Artefact plate = required(read_artefact_file(folder + "plate.toml")).artefact;
  auto file = fmt::output_file(folder + "readings.csv");
  file.print("placement,feature,temperature,x,y,z\n");
  RandomStream random(2026, "examples/sphere-plate");
  constexpr double temperature = 20.8;
  const double expansion_factor = plate.expansion_factor(temperature);
  for (int placement = 1; placement <= 2; ++placement) {
    const Rigid base_from_plate{random.rotation(), {500.0, -200.0 * placement, 300.0}};
    for (const CertifiedFeature& ball : plate.features) {
      const Eigen::Vector3d moved = ball.name == "C4" ? Eigen::Vector3d(0.006, 0.008, 0.0) : Eigen::Vector3d::Zero();
      const Eigen::Vector3d centre = base_from_plate * Eigen::Vector3d(expansion_factor * (*ball.at + moved));
      for (const auto& direction : testing::pattern_25()) {
        const Eigen::Vector3d p = centre + (expansion_factor * *ball.radius + 3.0) * direction + 0.003 * normal(random);
        file.print("{},{},{:.1f},{:.4f},{:.4f},{:.4f}\n", placement, ball.name, temperature, p.x(), p.y(), p.z());
      }
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: write_verification_examples SOURCE_DIR\n");
    return 2;
  }
  write_iso10360_12(argv[1]);
  write_sphere_plate(argv[1]);
  return 0;
}
