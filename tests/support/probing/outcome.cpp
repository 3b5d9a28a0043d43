#include "tests/support/probing/outcome.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace artcal::probing {
namespace {

constexpr double found_within = 0.05;  // mm
constexpr double coverage = 4.0;

// Index in parameters(Chain) by the name in a result: a1, d1, theta1, alpha1, l.
Eigen::Index index_of(const std::string& name, int joints) {
  if (name == "l") {
    return 4 * joints;
  }
  const auto digits = name.find_first_of("0123456789");
  const std::string kind = name.substr(0, digits);
  const Eigen::Index block = kind == "a" ? 0 : kind == "d" ? 1 : kind == "theta" ? 2 : 3;
  return block * joints + std::stoi(name.substr(digits)) - 1;
}

}  // namespace

double stated_length_error(const Identification& result) {
  const Chain found = chain_of(result.arm);
  const Eigen::VectorXd values = parameters(found);
  std::vector<Eigen::Index> free;
  for (const int index : result.free) {
    free.push_back(index_of(result.parameters[static_cast<std::size_t>(index)].parameter.name, found.joints()));
  }
  const auto postures = [&](int i) {
    Eigen::VectorXd q(found.joints());
    for (int k = 0; k < found.joints(); ++k) {
      q[k] = std::remainder(1.7 * (i + 1) * (k + 1) + 0.3 * i * i, 2.0 * std::numbers::pi);
    }
    return q;
  };
  double squares = 0.0;
  constexpr int pairs = 40;
  for (int i = 0; i < pairs; ++i) {
    const Posture p = posture(found, postures(2 * i));
    const Posture q = posture(found, postures(2 * i + 1));
    const Eigen::RowVectorXd along =
        (p.tip - q.tip).normalized().transpose() * (tip_by_parameters(found, p) - tip_by_parameters(found, q));
    Eigen::RowVectorXd slope(static_cast<Eigen::Index>(free.size()));
    for (std::size_t k = 0; k < free.size(); ++k) {
      slope[static_cast<Eigen::Index>(k)] = along[free[k]];
    }
    squares += (slope * result.covariance).dot(slope);
  }
  return std::sqrt(squares / pairs);
}

Outcome outcome(const Session& session, const Expected<Identification>& result) {
  if (!result) {
    return Outcome::Refused;
  }
  const double error = length_error(session.truth, chain_of(result->arm));
  return error < found_within || error < coverage * stated_length_error(*result) ? Outcome::Found : Outcome::Wrong;
}

}  // namespace artcal::probing
