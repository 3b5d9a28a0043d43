#include "app/stream/tip_check.h"

#include <cmath>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "artefacts/virtual_probing/postures.h"
#include "core/kabsch.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr double far_better = 10.0;

/// What could have been done to the angles, and how it is put right.
struct Hypothesis {
  std::string text;
  std::function<void(Eigen::VectorXd&)> correct;
};

// Deviation of the reported tips from those by the arm's file after the best rigid motion, rms, mm.
double deviation(const Arm& arm, int probe, const std::vector<StreamEvent>& events, const Hypothesis& hypothesis) {
  const auto count = static_cast<Eigen::Index>(events.size());
  Eigen::Matrix3Xd by_angles(3, count);
  Eigen::Matrix3Xd reported(3, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    Eigen::VectorXd q = events[static_cast<std::size_t>(i)].joints;
    hypothesis.correct(q);
    by_angles.col(i) = tip_at(arm, probe, q);
    reported.col(i) = *events[static_cast<std::size_t>(i)].tip_in_base;
  }
  by_angles.colwise() -= Eigen::Vector3d(by_angles.rowwise().mean());
  reported.colwise() -= Eigen::Vector3d(reported.rowwise().mean());
  const Eigen::Matrix3d rotation = rotation_of_moment(reported * by_angles.transpose()).rotation;
  return std::sqrt((reported - rotation * by_angles).squaredNorm() / static_cast<double>(count));
}

std::vector<Hypothesis> orders_and_signs(Eigen::Index joints) {
  std::vector<Hypothesis> all{{"", [](Eigen::VectorXd&) {}}};
  for (Eigen::Index i = 0; i < joints; ++i) {
    all.push_back({fmt::format("the sign of q{} reversed", i + 1), [i](Eigen::VectorXd& q) { q[i] = -q[i]; }});
    for (Eigen::Index j = i + 1; j < joints; ++j) {
      all.push_back(
          {fmt::format("q{} and q{} exchanged", i + 1, j + 1), [i, j](Eigen::VectorXd& q) { std::swap(q[i], q[j]); }});
    }
  }
  all.push_back({"all signs reversed", [](Eigen::VectorXd& q) { q = -q; }});
  all.push_back({"the joints in reverse order", [](Eigen::VectorXd& q) { q.reverseInPlace(); }});
  return all;
}

std::vector<Hypothesis> hypotheses(Eigen::Index joints) {
  const std::pair<const char*, double> units[] = {
      {"", 1.0}, {"the angles read as radians", 1.0 / units::degree}, {"the angles read as degrees", units::degree}};
  std::vector<Hypothesis> all;
  for (const auto& [unit, factor] : units) {
    for (const Hypothesis& order : orders_and_signs(joints)) {
      const std::string joined = *unit == '\0' || order.text.empty() ? "" : " and ";
      all.push_back({unit + joined + order.text, [factor = factor, correct = order.correct](Eigen::VectorXd& q) {
                       q *= factor;
                       correct(q);
                     }});
    }
  }
  return all;
}

}  // namespace

std::string check_tips(const Arm& arm, int probe, const std::vector<StreamEvent>& events) {
  const auto all = hypotheses(static_cast<Eigen::Index>(arm.joints.size()));
  const double as_read = deviation(arm, probe, events, all.front());
  if (as_read <= max_deviation * reach(arm)) {
    return "";
  }
  std::string advice = "check order, signs and unit of the joints, the arm's file and the probe";
  double least = as_read / far_better;
  for (const Hypothesis& hypothesis : all) {
    if (const double by_hypothesis = deviation(arm, probe, events, hypothesis); by_hypothesis < least) {
      least = by_hypothesis;
      advice = fmt::format("with {} they deviate by {:.3g} mm: correct `joints` or `units` of the stream's file",
                           hypothesis.text, by_hypothesis);
    }
  }
  return fmt::format(
      "the tip's coordinates are not those of the joint angles: the first {} readings deviate by {:.4g} mm rms by the "
      "arm's file; {}",
      events.size(), as_read, advice);
}

}  // namespace artcal
