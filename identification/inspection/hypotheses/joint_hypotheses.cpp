#include "identification/inspection/hypotheses/joint_hypotheses.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <fmt/format.h>

#include "core/units.h"

namespace artcal {
namespace {

using Change = std::function<void(Eigen::Ref<Eigen::VectorXd>)>;

constexpr int all_tables = -1;
constexpr int offsets_tried = 24;
constexpr double min_offset = 10.0 * units::degree;
constexpr double offset_resolution = 0.05 * units::degree;

/// Collects hypotheses about one table, or all.
class Collector {
 public:
  Collector(const Recording& recording, int table, std::vector<Hypothesis>& hypotheses)
      : recording_(recording), table_(table), hypotheses_(hypotheses) {}

  void add(FindingKind kind, const std::string& text, const std::string& remedy, Change change) {
    const int table = table_;
    hypotheses_.push_back(
        {kind, 0, recording_.files.empty() ? "" : recording_.files[static_cast<std::size_t>(std::max(0, table))], text,
         remedy, [table, change](Recording& recording, std::vector<Artefact>&) {
           for (std::size_t i = 0; i < recording.readings.size(); ++i) {
             if (table == all_tables || recording.readings[i].file == table) {
               change(recording.joints.col(static_cast<Eigen::Index>(i)));
             }
           }
         }});
  }

 private:
  const Recording& recording_;
  int table_;
  std::vector<Hypothesis>& hypotheses_;
};

void add_joint_units(Collector& collector) {
  collector.add(FindingKind::AngleUnit, "with its joint angles taken for radians", "State units.joint = \"rad\"",
                [](Eigen::Ref<Eigen::VectorXd> q) { q /= units::degree; });
  collector.add(FindingKind::AngleUnit, "with its joint angles taken for degrees", "State units.joint = \"deg\"",
                [](Eigen::Ref<Eigen::VectorXd> q) { q *= units::degree; });
}

void add_orders(Collector& collector, int joints) {
  for (int i = 0; i < joints; ++i) {
    for (int j = i + 1; j < joints; ++j) {
      collector.add(FindingKind::JointsExchanged,
                    fmt::format("read with {} and {} exchanged", joint_name(i), joint_name(j)),
                    "Exchange the two columns, or their names in the header",
                    [i, j](Eigen::Ref<Eigen::VectorXd> q) { std::swap(q[i], q[j]); });
    }
  }
  const std::string remedy = "Put the columns of joint angles in the arm's order, from the base on";
  collector.add(FindingKind::JointsExchanged, "read with the joints in reverse order", remedy,
                [](Eigen::Ref<Eigen::VectorXd> q) { q.reverseInPlace(); });
  for (const int shift : {1, joints - 1}) {
    collector.add(FindingKind::JointsExchanged,
                  fmt::format("read with {} as {}, {} as {} and so on", joint_name(shift), joint_name(0),
                              joint_name((shift + 1) % joints), joint_name(1)),
                  remedy, [shift, joints](Eigen::Ref<Eigen::VectorXd> q) {
                    const Eigen::VectorXd before = q;
                    for (int i = 0; i < joints; ++i) {
                      q[i] = before[(i + shift) % joints];
                    }
                  });
  }
}

void add_signs(Collector& collector, int joints) {
  for (int i = 0; i < joints; ++i) {
    collector.add(FindingKind::JointSign, fmt::format("read with the sign of {} turned round", joint_name(i)),
                  fmt::format("State sign = -1 (or 1) for joint {} in the arm's file, as its encoder counts", i + 1),
                  [i](Eigen::Ref<Eigen::VectorXd> q) { q[i] = -q[i]; });
  }
  collector.add(FindingKind::JointSign, "read with the signs of all joints turned round",
                "State sign = -1 (or 1) for all joints in the arm's file, as their encoders count",
                [](Eigen::Ref<Eigen::VectorXd> q) { q = -q; });
}

double discrepancy_of_offset(const Bound& bound, int joint, double offset) {
  Arm arm = bound.recording.arm;
  arm.joints[static_cast<std::size_t>(joint)].theta += offset;
  return discrepancy(bound, arm);
}

// The best of a grid, then by halving its steps.
double best_offset(const Bound& bound, int joint) {
  double best = 0.0;
  double least = discrepancy_of_offset(bound, joint, 0.0);
  const double grid = 360.0 * units::degree / offsets_tried;
  for (int k = 1; k < offsets_tried; ++k) {
    if (const double found = discrepancy_of_offset(bound, joint, k * grid); found < least) {
      least = found;
      best = k * grid;
    }
  }
  for (double step = 0.5 * grid; step > offset_resolution; step *= 0.5) {
    const double at = best;
    for (const double offset : {at - step, at + step}) {
      if (const double found = discrepancy_of_offset(bound, joint, offset); found < least) {
        least = found;
        best = offset;
      }
    }
  }
  return std::remainder(best, 360.0 * units::degree);
}

}  // namespace

std::vector<Hypothesis> joint_hypotheses(const Recording& recording) {
  std::vector<Hypothesis> hypotheses;
  const int joints = static_cast<int>(recording.arm.joints.size());
  const int tables = static_cast<int>(recording.files.size());
  for (int table = all_tables; table < (tables > 1 ? tables : 0); ++table) {
    Collector collector(recording, table, hypotheses);
    add_joint_units(collector);
    add_orders(collector, joints);
    add_signs(collector, joints);
  }
  return hypotheses;
}

std::vector<Hypothesis> offset_hypotheses(const Recording& recording, const Constraints& constraints) {
  std::vector<Hypothesis> hypotheses;
  const Bound bound{recording, constraints};
  for (int joint = 0; joint < static_cast<int>(recording.arm.joints.size()); ++joint) {
    const double offset = best_offset(bound, joint);
    if (std::abs(offset) < min_offset) {
      continue;
    }
    const auto sign = recording.arm.joints[static_cast<std::size_t>(joint)].sign;
    hypotheses.push_back(
        {FindingKind::JointOffset, 1, "",
         fmt::format("with the zero of joint {} turned by {:.1f} degrees", joint + 1, offset / units::degree),
         fmt::format("Correct theta of joint {} in the arm's file, or the encoder's reference", joint + 1),
         [joint, offset, sign](Recording& changed, std::vector<Artefact>&) {
           changed.joints.row(joint).array() += sign * offset;
         }});
  }
  return hypotheses;
}

}  // namespace artcal
