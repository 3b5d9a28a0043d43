#include "identification/planning/design_goal.h"

#include <cmath>

#include "artefacts/simulation/posture.h"
#include "core/random.h"
#include "identification/uncertainty/uncertain_arm.h"

namespace artcal {

TestLengths test_lengths(const VirtualArm& arm, const DesignPool& pool, const Noise& noise, int count,
                         std::uint64_t seed) {
  const UncertainArm uncertain(arm.arm, {pool.system.free, {}, 0.0, 0.0});
  RandomStream random(seed, "test lengths");
  TestLengths lengths{Eigen::MatrixXd::Zero(pool.common(), count), Eigen::VectorXd(count)};
  const double encoder = noise.encoder.value_or(0.0);
  const double probing = noise.reading.value_or(noise.probing.value_or(0.0));
  for (int i = 0; i < count; ++i) {
    const UncertainTip first = uncertain.tip(random_readings(arm, random));
    const UncertainTip second = uncertain.tip(random_readings(arm, random));
    const Eigen::Vector3d along = (second.in_base - first.in_base).normalized();
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
