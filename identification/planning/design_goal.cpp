#include "identification/planning/design_goal.h"

#include <cmath>

#include "acquisition/sweep.h"
#include "artefacts/simulation/posture.h"
#include "core/random.h"

namespace artcal {
namespace {

struct End {
  Eigen::Vector3d tip;
  Eigen::Matrix3Xd by_parameter;
  Eigen::Matrix3Xd by_joint;
};

End end_at(const Sweep& sweep, const Eigen::VectorXd& q) {
  std::vector<double> sines(2 * static_cast<std::size_t>(q.size()));
  const std::span<const double> angles(q.data(), static_cast<std::size_t>(q.size()));
  joint_sines(angles, sines);
  End end{{}, Eigen::Matrix3Xd(3, sweep.column_count()), Eigen::Matrix3Xd(3, sweep.joint_count())};
  sweep.tip_by_joints({sines, angles}, end.by_joint.data());
  end.tip = sweep.tip_in_base({sines, angles}, end.by_parameter.data());
  return end;
}

}  // namespace

TestLengths test_lengths(const VirtualArm& arm, const DesignPool& pool, const Noise& noise, int count,
                         std::uint64_t seed) {
  const Sweep sweep(arm.arm, pool.system.free, 0);
  RandomStream random(seed, "test lengths");
  TestLengths lengths{Eigen::MatrixXd::Zero(pool.common(), count), Eigen::VectorXd(count)};
  const double encoder = noise.encoder.value_or(0.0);
  const double probing = noise.reading.value_or(noise.probing.value_or(0.0));
  for (int i = 0; i < count; ++i) {
    const End first = end_at(sweep, random_readings(arm, random));
    const End second = end_at(sweep, random_readings(arm, random));
    const Eigen::Vector3d along = (second.tip - first.tip).normalized();
    lengths.by_common.col(i).tail(pool.system.arm_size()) =
        pool.system.scale.cwiseProduct((second.by_parameter - first.by_parameter).transpose() * along);
    lengths.of_noise[i] = 2.0 * probing * probing + encoder * encoder *
                                                        ((first.by_joint.transpose() * along).squaredNorm() +
                                                         (second.by_joint.transpose() * along).squaredNorm());
  }
  return lengths;
}

PredictedU predicted_u(const Eigen::VectorXd& variances) {
  return {std::sqrt(variances.maxCoeff()), std::sqrt(variances.mean())};
}

double to_lower(const Eigen::VectorXd& variances, Goal goal) {
  const double largest = variances.maxCoeff();
  return goal == Goal::Mean ? std::sqrt(variances.mean())
                            : std::sqrt(largest) * std::pow((variances / largest).array().pow(8).mean(), 1.0 / 16.0);
}

Eigen::VectorXd variances_of(const Eigen::MatrixXd& triangle, const TestLengths& lengths) {
  const Eigen::MatrixXd solved = triangle.transpose().triangularView<Eigen::Lower>().solve(lengths.by_common);
  return solved.colwise().squaredNorm().transpose() + lengths.of_noise;
}

}  // namespace artcal
