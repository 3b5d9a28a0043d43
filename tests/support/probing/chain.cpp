#include "tests/support/probing/chain.h"

#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>

namespace artcal::probing {
namespace {

Eigen::Vector3d axis(const Eigen::Matrix4d& frame, int which) { return frame.block<3, 1>(0, which); }
Eigen::Vector3d origin(const Eigen::Matrix4d& frame) { return frame.block<3, 1>(0, 3); }

Eigen::Matrix4d link(double a, double d, double theta, double alpha) {
  const double ct = std::cos(theta), st = std::sin(theta), ca = std::cos(alpha), sa = std::sin(alpha);
  Eigen::Matrix4d t;
  t << ct, -st * ca, st * sa, a * ct, st, ct * ca, -ct * sa, a * st, 0.0, sa, ca, d, 0.0, 0.0, 0.0, 1.0;
  return t;
}

}  // namespace

Eigen::VectorXd parameters(const Chain& chain) {
  Eigen::VectorXd values(4 * chain.joints() + 1);
  values << chain.a, chain.d, chain.theta, chain.alpha, chain.l;
  return values;
}

Chain with_parameters(const Chain& chain, const Eigen::VectorXd& values) {
  const int n = chain.joints();
  return {values.segment(0, n), values.segment(n, n), values.segment(2 * n, n), values.segment(3 * n, n),
          values[4 * n]};
}

Chain gao_chain() {
  Chain chain;
  chain.a = chain.theta = Eigen::VectorXd::Zero(6);
  chain.d = (Eigen::VectorXd(6) << 300.0, 65.5, 792.7, 65.5, 883.2, 0.0).finished();
  chain.alpha = Eigen::VectorXd::Constant(6, std::numbers::pi / 2);
  chain.l = 183.5;
  return chain;
}

Posture posture(const Chain& chain, const Eigen::VectorXd& q) {
  Posture result;
  result.frames.push_back(Eigen::Matrix4d::Identity());
  for (int i = 0; i < chain.joints(); ++i) {
    result.frames.push_back(result.frames.back() * link(chain.a[i], chain.d[i], chain.theta[i] + q[i], chain.alpha[i]));
  }
  result.tip = origin(result.frames.back()) + chain.l * result.stylus();
  return result;
}

Eigen::Matrix3Xd tip_by_parameters(const Chain& chain, const Posture& at) {
  const int n = chain.joints();
  Eigen::Matrix3Xd slope(3, 4 * n + 1);
  for (int i = 0; i < n; ++i) {
    const Eigen::Vector3d z = axis(at.frames[i], 2);
    const Eigen::Vector3d x = axis(at.frames[i + 1], 0);
    slope.col(i) = x;
    slope.col(n + i) = z;
    slope.col(2 * n + i) = z.cross(at.tip - origin(at.frames[i]));
    slope.col(3 * n + i) = x.cross(at.tip - origin(at.frames[i + 1]));
  }
  slope.col(4 * n) = at.stylus();
  return slope;
}

std::optional<Eigen::VectorXd> reach(const Chain& chain, const Eigen::Vector3d& tip, const Eigen::Vector3d& stylus,
                                     Eigen::VectorXd q) {
  constexpr double lever = 300.0;  // mm that a radian of the stylus counts
  for (int iteration = 0; iteration < 60; ++iteration) {
    const Posture at = posture(chain, q);
    Eigen::VectorXd miss(6);
    miss << tip - at.tip, lever * (stylus - at.stylus());
    if (miss.norm() < 1e-10) {
      return q;
    }
    Eigen::MatrixXd slope(6, chain.joints());
    for (int i = 0; i < chain.joints(); ++i) {
      const Eigen::Vector3d z = axis(at.frames[i], 2);
      slope.col(i) << z.cross(at.tip - origin(at.frames[i])), lever * z.cross(at.stylus());
    }
    const double damping = 1e-6 + 1e-2 * std::min(1.0, miss.norm() / 1000.0);
    Eigen::MatrixXd normal = slope.transpose() * slope;
    normal.diagonal().array() += damping * normal.trace() / chain.joints();
    Eigen::VectorXd step = normal.ldlt().solve(slope.transpose() * miss);
    q += step * std::min(1.0, 0.5 / step.cwiseAbs().maxCoeff());
  }
  return std::nullopt;
}

}  // namespace artcal::probing
