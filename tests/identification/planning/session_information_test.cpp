// Information folded in reading by reading against one dense problem: a chain that this file multiplies out and
// differentiates by central differences, all unknowns at once.
#include "identification/planning/session_information.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <Eigen/Dense>

namespace artcal {
namespace {

constexpr int joints = 4;
constexpr double deg = std::numbers::pi / 180.0;
constexpr double encoder = 1e-5;
constexpr double probing = 0.003;
constexpr double u_distance = 0.001;

// a, d, theta, alpha of each joint, then the tip.
using Numbers = Eigen::Matrix<double, 4 * joints + 3, 1>;

Numbers nominal() {
  Numbers n;
  n << 20, 300, 0, 90 * deg, 400, 25, 0, 10 * deg, 350, 30, 0, -75 * deg, 60, 10, 0, 85 * deg, 15, -5, 90;
  return n;
}

Arm arm_of(const Numbers& n) {
  Arm arm;
  for (int j = 0; j < joints; ++j) {
    Joint joint;
    joint.a = n[4 * j];
    joint.d = n[4 * j + 1];
    joint.theta = n[4 * j + 2];
    joint.alpha = n[4 * j + 3];
    arm.joints.push_back(joint);
  }
  arm.probes.resize(1);
  arm.probes[0].tip_in_last = n.tail<3>();
  return arm;
}

// Rz(q + theta) Tz(d) Tx(a) Rx(alpha)
Eigen::Vector3d tip(const Numbers& n, const Eigen::Vector4d& q) {
  Eigen::Isometry3d chain = Eigen::Isometry3d::Identity();
  for (int j = 0; j < joints; ++j) {
    chain = chain * Eigen::AngleAxisd(q[j] + n[4 * j + 2], Eigen::Vector3d::UnitZ()) *
            Eigen::Translation3d(n[4 * j], 0.0, n[4 * j + 1]) *
            Eigen::AngleAxisd(n[4 * j + 3], Eigen::Vector3d::UnitX());
  }
  return chain * n.tail<3>();
}

template <typename Function>
Eigen::Matrix3Xd differences(Eigen::VectorXd at, const Function& f) {
  Eigen::Matrix3Xd slope(3, at.size());
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    const double kept = at[i];
    at[i] = kept + 1e-5;
    const Eigen::Vector3d up = f(at);
    at[i] = kept - 1e-5;
    slope.col(i) = (up - f(at)) / 2e-5;
    at[i] = kept;
  }
  return slope;
}
Eigen::Matrix3Xd by_numbers(const Eigen::Vector4d& q, double reach) {
  Eigen::Matrix3Xd slope = differences(nominal(), [&](const Eigen::VectorXd& n) { return tip(n, q); });
  for (int j = 0; j < joints; ++j) {
    slope.col(4 * j + 2) /= reach;
    slope.col(4 * j + 3) /= reach;
  }
  return slope;
}
Eigen::Matrix3Xd by_joints(const Eigen::Vector4d& q) {
  return differences(q, [&](const Eigen::VectorXd& at) { return tip(nominal(), at); });
}

std::vector<Artefact> two_seats(bool certified) {
  Artefact bar;
  bar.name = "bar";
  bar.features.resize(2);
  bar.features[0].name = "A";
  bar.features[1].name = "B";
  if (certified) bar.distances.push_back({0, 1, 300.0, u_distance});
  return {bar};
}

constexpr int placements = 6;
constexpr int readings = 14;  // of a placement, half of them on each seat
constexpr int arm_columns = 4 * joints + 3;
constexpr int columns = 6 * placements + 1 + arm_columns;  // two points each, the bar's error, the arm

Eigen::Vector4d posture(std::mt19937& random) {
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  const double q1 = angle(random), q2 = angle(random), q3 = angle(random), q4 = angle(random);
  return {q1, q2, q3, q4};
}

// A posture with the tip at a point: Gauss-Newton with the smallest step, from random starts.
Eigen::Vector4d posture_at(const Eigen::Vector3d& point, std::mt19937& random) {
  for (;;) {
    Eigen::Vector4d q = posture(random);
    for (int i = 0; i < 50; ++i) {
      const Eigen::Vector3d miss = point - tip(nominal(), q);
      if (miss.norm() < 1e-8) return q;
      const Eigen::Matrix3Xd slope = by_joints(q);
      const Eigen::Matrix3d damped = slope * slope.transpose() + 1e-3 * miss.norm() * Eigen::Matrix3d::Identity();
      q += slope.transpose() * damped.ldlt().solve(miss);
    }
  }
}

/// The same readings into both: SessionInformation, and one dense normal matrix of all unknowns, of which the arm's
/// part is left after the others are taken out.
struct Both {
  explicit Both(bool certified) : information(arm_of(nominal()), two_seats(certified), encoder, probing) {
    std::mt19937 random(3);
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(columns, columns);
    normal(6 * placements, 6 * placements) = 1.0;
    for (int p = 0; p < placements; ++p) {
      const Eigen::Vector3d at[2] = {tip(nominal(), posture(random)), tip(nominal(), posture(random))};
      for (int k = 0; k < readings; ++k) {
        const int feature = k < readings / 2 ? 0 : 1;
        const Eigen::Vector4d q = posture_at(at[feature], random);
        information.add({0, feature, std::to_string(p), 0, q});
        const Eigen::Matrix3Xd j = by_joints(q);
        const Eigen::Matrix3d covariance =
            probing * probing * Eigen::Matrix3d::Identity() + encoder * encoder * j * j.transpose();
        const Eigen::Matrix3d whitening =
            Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).operatorInverseSqrt();
        Eigen::MatrixXd three = Eigen::MatrixXd::Zero(3, columns);
        three.middleCols(6 * p + 3 * feature, 3) = -whitening;
        three.rightCols(arm_columns) = whitening * by_numbers(q, length);
        normal += three.transpose() * three;
      }
      Eigen::RowVectorXd distance = Eigen::RowVectorXd::Zero(columns);
      distance.segment<3>(6 * p + 3) = (at[1] - at[0]).normalized().transpose() / 1e-4;
      distance.segment<3>(6 * p) = -distance.segment<3>(6 * p + 3);
      distance[6 * placements] = -u_distance / 1e-4;
      if (certified) normal += distance.transpose() * distance;
    }
    const Eigen::Index rest = columns - arm_columns;
    of_arm = normal.bottomRightCorner(arm_columns, arm_columns) -
             normal.bottomLeftCorner(arm_columns, rest) *
                 normal.topLeftCorner(rest, rest).ldlt().solve(normal.topRightCorner(rest, arm_columns));
  }

  [[nodiscard]] int rank() const {
    return static_cast<int>(
        (Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(of_arm).eigenvalues().array() > 1.0).count());
  }

  // Mean over lengths between random postures.
  [[nodiscard]] double u_of_length() const {
    std::mt19937 random(4);
    const auto solver = (of_arm + 0.01 * Eigen::MatrixXd::Identity(arm_columns, arm_columns)).eval().ldlt();
    double sum = 0.0;
    constexpr int lengths = 4000;
    for (int i = 0; i < lengths; ++i) {
      const Eigen::Vector4d q1 = posture(random);
      const Eigen::Vector4d q2 = posture(random);
      const Eigen::Vector3d along = (tip(nominal(), q2) - tip(nominal(), q1)).normalized();
      const Eigen::VectorXd slope = (by_numbers(q2, length) - by_numbers(q1, length)).transpose() * along;
      sum +=
          slope.dot(solver.solve(slope)) + 2.0 * probing * probing +
          encoder * encoder *
              ((by_joints(q1).transpose() * along).squaredNorm() + (by_joints(q2).transpose() * along).squaredNorm());
    }
    return std::sqrt(sum / lengths);
  }

  double length = reach(arm_of(nominal()));
  SessionInformation information;
  Eigen::MatrixXd of_arm;
};

TEST(SessionInformation, IsThatOfOneDenseProblem) {
  const Both both(true);
  EXPECT_EQ(both.information.rank(), both.rank());
  EXPECT_LT(both.information.rank(), both.information.parameters());
  // 200 lengths against 4000: their mean scatters by some per cent.
  EXPECT_NEAR(both.information.u_of_length().mean / both.u_of_length(), 1.0, 0.1);
}

// The certified distance is all that says how long the arm is: without it one more direction is not determined, and
// lengths are known as well as the arm was beforehand.
TEST(SessionInformation, HasTheScaleFromTheCertifiedDistancesAlone) {
  const Both with(true);
  const Both without(false);
  EXPECT_EQ(with.rank(), without.rank() + 1);
  EXPECT_EQ(with.information.rank(), without.information.rank() + 1);
  EXPECT_LT(10.0 * with.u_of_length(), without.u_of_length());
  EXPECT_LT(10.0 * with.information.u_of_length().mean, without.information.u_of_length().mean);
  EXPECT_NEAR(without.information.u_of_length().mean / without.u_of_length(), 1.0, 0.1);
}

}  // namespace
}  // namespace artcal
