#include "identification/inspection/hypotheses/encoder_slip.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "core/units.h"
#include "identification/least_squares/arm_fit.h"
#include "identification/problem/preparation.h"

namespace artcal {
namespace {

constexpr std::size_t places_in_time = 6;
constexpr std::size_t places_by_angle = 3;
constexpr int slip_iterations = 30;
constexpr std::size_t max_places = 400;
constexpr double near_enough_for_slips = 1e-3;  // mm

Arm with_slip_joint(Arm arm, int joint) {
  Joint slip;
  slip.errors.gain = -1.0;  // turns by (1 + gain)·q
  slip.sign = arm.joints[static_cast<std::size_t>(joint)].sign;
  // Rz of the slip stands beside Rz of the joint in both conventions.
  const int at = arm.convention == Convention::Standard ? joint : joint + 1;
  arm.joints.insert(arm.joints.begin() + at, slip);
  return arm;
}

std::vector<Parameter> with_slip_parameter(const std::vector<Parameter>& free, const Arm& arm, int at) {
  std::vector<Parameter> extended;
  const auto all = all_parameters(arm);
  const auto named = [&](ParameterKind kind, int owner) {
    return *std::find_if(all.begin(), all.end(),
                         [&](const Parameter& p) { return p.kind == kind && p.owner == owner; });
  };
  for (const Parameter& parameter : free) {
    const bool of_probe = parameter.is_tip() || parameter.kind == ParameterKind::Radius;
    extended.push_back(named(parameter.kind, parameter.owner + (!of_probe && parameter.owner >= at ? 1 : 0)));
  }
  extended.push_back(named(ParameterKind::Gain, at));
  return extended;
}

/// Fits slips of one recording.
class SlipFits {
 public:
  SlipFits(const Recording& recording, const Constraints& constraints, const std::vector<Parameter>& free)
      : recording_(recording), constraints_(constraints), free_(free) {}

  [[nodiscard]] std::vector<int> order(int joint, SlipOrder by) const {
    std::vector<int> order(recording_.readings.size());
    std::iota(order.begin(), order.end(), 0);
    if (by == SlipOrder::Angle) {
      std::stable_sort(order.begin(), order.end(), [&](int one, int other) {
        return recording_.joints(joint, one) < recording_.joints(joint, other);
      });
    }
    return order;
  }

  // Before place `k` of the order.
  [[nodiscard]] std::optional<EncoderSlip> at(int joint, SlipOrder by, const std::vector<int>& order, std::size_t k,
                                              Loss loss) const {
    EncoderSlip slip = placed(joint, by, order, k);
    const int row = recording_.arm.convention == Convention::Standard ? joint : joint + 1;
    Recording longer = recording_;
    longer.arm = with_slip_joint(recording_.arm, joint);
    const Eigen::Index below = recording_.joints.rows() - row;
    longer.joints.resize(recording_.joints.rows() + 1, recording_.joints.cols());
    longer.joints.topRows(row) = recording_.joints.topRows(row);
    longer.joints.bottomRows(below) = recording_.joints.bottomRows(below);
    for (Eigen::Index i = 0; i < longer.joints.cols(); ++i) {
      longer.joints(row, i) = slip.after[static_cast<std::size_t>(i)] ? 1.0 : 0.0;
    }
    SolveOptions options;
    options.max_iterations = slip_iterations;
    options.still = near_enough_for_slips;
    options.loss = loss;
    const auto fit =
        fit_arm(longer, constraints_, longer.arm, with_slip_parameter(free_, longer.arm, row), {}, options);
    if (!fit) {
      return std::nullopt;
    }
    slip.angle = 1.0 + fit->arm.joints[static_cast<std::size_t>(row)].errors.gain;
    slip.size = fit->noise;
    slip.arm = fit->arm;
    slip.arm.joints.erase(slip.arm.joints.begin() + row);
    return slip;
  }

  // The place at which the readings are nearest to what the arm found makes of them.
  void find_place(EncoderSlip& best) const {
    const auto order_of_best = order(best.joint, best.order);
    double least = std::numeric_limits<double>::infinity();
    std::size_t place = 0;
    for (std::size_t step = std::max<std::size_t>(1, order_of_best.size() / max_places), k = step;
         k < order_of_best.size(); k += step) {
      EncoderSlip slip = placed(best.joint, best.order, order_of_best, k);
      slip.angle = best.angle;
      const auto bound = applied(slip_hypothesis(recording_, slip), recording_, constraints_.artefacts);
      if (const double found = bound ? discrepancy(*bound, best.arm) : least; found < least) {
        least = found;
        place = k;
      }
    }
    auto slip = place > 0 ? at(best.joint, best.order, order_of_best, place, Loss::None) : std::nullopt;
    if (slip) {
      best = std::move(*slip);
    }
  }

 private:
  [[nodiscard]] static EncoderSlip placed(int joint, SlipOrder by, const std::vector<int>& order, std::size_t k) {
    EncoderSlip slip{joint, by, std::vector<bool>(order.size(), false), order[k], 0.0, 0.0, {}};
    for (std::size_t i = k; i < order.size(); ++i) {
      slip.after[static_cast<std::size_t>(order[i])] = true;
    }
    return slip;
  }

  const Recording& recording_;
  const Constraints& constraints_;
  const std::vector<Parameter>& free_;
};

}  // namespace

std::optional<EncoderSlip> find_encoder_slip(const Recording& recording, const Constraints& constraints,
                                             const IdentifyOptions& options) {
  const auto preparation = prepare_from(arm_for(options.model, recording.arm), recording, constraints, options);
  if (!preparation) {
    return std::nullopt;
  }
  const SlipFits fits(recording, constraints, preparation->free);
  std::optional<EncoderSlip> best;
  for (int joint = 0; joint < static_cast<int>(recording.arm.joints.size()); ++joint) {
    for (const SlipOrder by : {SlipOrder::Time, SlipOrder::Angle}) {
      const auto order = fits.order(joint, by);
      const std::size_t places = by == SlipOrder::Time ? places_in_time : places_by_angle;
      for (std::size_t i = 1; i < places; ++i) {
        const std::size_t k = i * order.size() / places;
        auto slip = k > 0 ? fits.at(joint, by, order, k, Loss::Cauchy) : std::nullopt;
        if (slip && (!best || slip->size < best->size)) {
          best = std::move(slip);
        }
      }
    }
  }
  if (best) {
    fits.find_place(*best);
  }
  return best;
}

Hypothesis slip_hypothesis(const Recording& recording, const EncoderSlip& slip) {
  const bool in_time = slip.order == SlipOrder::Time;
  const double angle = slip.angle;
  const std::string text =
      in_time ? fmt::format("with the encoder of joint {} slipped by {:.4g} degrees before this reading",
                            slip.joint + 1, -angle / units::degree)
              : fmt::format("with the encoder of joint {} off by {:.4g} degrees above {:.1f} degrees", slip.joint + 1,
                            -angle / units::degree, recording.joints(slip.joint, slip.first) / units::degree);
  return {in_time ? FindingKind::EncoderSlipped : FindingKind::EncoderWrapped,
          1,
          recording.where(slip.first),
          text,
          in_time ? "Measure again what was read after it, or identify the two parts apart"
                  : "Correct how the encoder's counts are turned into angles, and measure again",
          [joint = slip.joint, after = slip.after, angle](Recording& changed, std::vector<Artefact>&) {
            for (std::size_t i = 0; i < after.size(); ++i) {
              changed.joints(joint, static_cast<Eigen::Index>(i)) += after[i] ? angle : 0.0;
            }
          }};
}

}  // namespace artcal
