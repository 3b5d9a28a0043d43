#include "app/stream/tip_check.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "artefacts/virtual_probing/postures.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr double max_off = 0.01;  // of the reach
constexpr double far_better = 10.0;

using Change = std::function<void(Eigen::VectorXd&)>;

double off_by(const Arm& arm, const std::vector<StreamEvent>& events, const Change& change) {
  std::vector<Eigen::Vector3d> tips;
  for (const StreamEvent& event : events) {
    Eigen::VectorXd q = event.joints;
    change(q);
    tips.push_back(tip_at(arm, 0, q));
  }
  double worst = 0.0;
  for (std::size_t i = 0; i < events.size(); ++i) {
    for (std::size_t k = i + 1; k < events.size(); ++k) {
      const double reported = (*events[i].tip_in_base - *events[k].tip_in_base).norm();
      worst = std::max(worst, std::abs((tips[i] - tips[k]).norm() - reported));
    }
  }
  return worst;
}

}  // namespace

std::string check_tips(const Arm& arm, const std::vector<StreamEvent>& events) {
  const double as_read = off_by(arm, events, [](Eigen::VectorXd&) {});
  if (as_read <= max_off * reach(arm)) {
    return "";
  }
  std::string best = "check the joints' order, signs and units, the arm's file and the probe";
  double least = as_read / far_better;
  const auto try_out = [&](const std::string& text, const Change& change) {
    if (const double off = off_by(arm, events, change); off < least) {
      least = off;
      best = fmt::format("{} they differ by {:.3g} mm only", text, off);
    }
  };
  try_out("with the angles taken for radians", [](Eigen::VectorXd& q) { q /= units::degree; });
  try_out("with the angles taken for degrees", [](Eigen::VectorXd& q) { q *= units::degree; });
  for (Eigen::Index i = 0; i < static_cast<Eigen::Index>(arm.joints.size()); ++i) {
    try_out(fmt::format("with the sign of q{} turned round", i + 1), [i](Eigen::VectorXd& q) { q[i] = -q[i]; });
    for (Eigen::Index j = i + 1; j < static_cast<Eigen::Index>(arm.joints.size()); ++j) {
      try_out(fmt::format("with q{} and q{} exchanged", i + 1, j + 1),
              [i, j](Eigen::VectorXd& q) { std::swap(q[i], q[j]); });
    }
  }
  return fmt::format(
      "the tip's coordinates and the joint angles do not belong together: distances between the first {} readings "
      "differ by up to {:.4g} mm by the arm's file; {}",
      events.size(), as_read, best);
}

}  // namespace artcal
