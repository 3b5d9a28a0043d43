#include "identification/inspection/hypotheses/encoder_slip.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/units.h"
#include "identification/initial/coarse_fit.h"
#include "identification/least_squares/arm_fit.h"
#include "identification/problem/preparation.h"

namespace artcal {
namespace {

constexpr std::size_t fitted_of_each_score = 2;
constexpr double sphere_deviation = 1.0;   // mm; what nominal arms make of a sphere
constexpr double surely_explained = 30.0;  // than the readings as written: no other slip is tried
constexpr int slip_iterations = 30;
constexpr std::size_t max_places = 400;
constexpr double near_enough_for_slips = 1e-3;  // mm

Arm with_slip_joint(Arm arm, int joint) {
  Joint slip;
  slip.errors.gain = -1.0;  // turns by (1 + gain)·q
  slip.sign = arm.joints[static_cast<std::size_t>(joint)].sign;
  slip.type = arm.joints[static_cast<std::size_t>(joint)].type;
  // Rz (Tz) of the slip stands beside Rz and Tz of the joint in both conventions.
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
    slip.change = 1.0 + fit->arm.joints[static_cast<std::size_t>(row)].errors.gain;
    slip.size = fit->noise;
    slip.arm = fit->arm;
    slip.arm.joints.erase(slip.arm.joints.begin() + row);
    return slip;
  }

  // The place at which the readings are nearest to what the arm found makes of them.
  void find_place(EncoderSlip& best) const {
    const auto order_of_best = readings_in_order(recording_, best.joint, best.order);
    double least = std::numeric_limits<double>::infinity();
    std::size_t place = 0;
    for (std::size_t step = std::max<std::size_t>(1, order_of_best.size() / max_places), k = step;
         k < order_of_best.size(); k += step) {
      EncoderSlip slip = placed(best.joint, best.order, order_of_best, k);
      slip.change = best.change;
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

// The places to fit, from the best score of each list on; of each joint and order one.
std::vector<StepScore> candidates(const std::vector<std::vector<StepScore>>& lists) {
  std::vector<StepScore> chosen;
  for (std::size_t rank = 0; rank < fitted_of_each_score; ++rank) {
    for (const auto& scores : lists) {
      const bool is_new =
          rank < scores.size() && std::none_of(chosen.begin(), chosen.end(), [&](const StepScore& other) {
            return other.joint == scores[rank].joint && other.order == scores[rank].order;
          });
      if (is_new) {
        chosen.push_back(scores[rank]);
      }
    }
  }
  return chosen;
}

std::vector<StepScore> candidates(const Recording& recording, const Constraints& constraints, const Arm& nominal,
                                  const std::vector<Parameter>& free, const std::optional<Arm>& as_written) {
  const Weights weights = coarse_weights(constraints, sphere_deviation);
  std::vector<std::vector<StepScore>> lists;
  const System at_nominal = make_system(recording, constraints, nominal, free);
  lists.push_back(score_steps(at_nominal, weights, recording));
  if (std::any_of(constraints.features.begin(), constraints.features.end(),
                  [](const FeatureConstraint& feature) { return feature.is<OnBall>(); })) {
    const Constraints points = balls_as_points(constraints);
    System to_centres = make_system(recording, points, nominal, free);
    lengthen_to_centres(constraints, to_centres);
    lists.push_back(score_steps(to_centres, coarse_weights(points, centre_deviation(constraints, nominal)), recording));
  }
  if (as_written) {
    lists.push_back(score_steps(make_system(recording, constraints, *as_written, free), weights, recording));
  }
  return candidates(lists);
}

}  // namespace

std::optional<EncoderSlip> find_encoder_slip(const Recording& recording, const Constraints& constraints,
                                             const IdentifyOptions& options, const AsWritten& as_written) {
  const Arm nominal = arm_for(options.model, recording.arm);
  const auto preparation = prepare_from(nominal, recording, constraints, options);
  if (!preparation) {
    return std::nullopt;
  }
  const SlipFits fits(recording, constraints, preparation->free);
  std::optional<EncoderSlip> best;
  for (const StepScore& place : candidates(recording, constraints, nominal, preparation->free, as_written.arm)) {
    auto slip = fits.at(place.joint, place.order, readings_in_order(recording, place.joint, place.order), place.place,
                        Loss::Cauchy);
    if (slip && (!best || slip->size < best->size)) {
      best = std::move(slip);
    }
    if (best && best->size * surely_explained <= as_written.size) {
      break;
    }
  }
  if (best) {
    fits.find_place(*best);
  }
  return best;
}

Hypothesis slip_hypothesis(const Recording& recording, const EncoderSlip& slip) {
  const bool in_time = slip.order == SlipOrder::Time;
  const bool is_prismatic = recording.arm.joints[static_cast<std::size_t>(slip.joint)].is_prismatic();
  const auto text_of = [&](double change, const char* form) {
    return fmt::format(fmt::runtime(form), is_prismatic ? change : change / units::degree) +
           (is_prismatic ? " mm" : " degrees");
  };
  const std::string text = in_time ? fmt::format("with the encoder of joint {} slipped by {} before this reading",
                                                 slip.joint + 1, text_of(-slip.change, "{:.4g}"))
                                   : fmt::format("with the encoder of joint {} off by {} above {}", slip.joint + 1,
                                                 text_of(-slip.change, "{:.4g}"),
                                                 text_of(recording.joints(slip.joint, slip.first), "{:.1f}"));
  return {in_time ? FindingKind::EncoderSlipped : FindingKind::EncoderWrapped,
          1,
          recording.where(slip.first),
          text,
          in_time ? "Measure again what was read after it, or identify the two parts apart"
                  : "Correct how the encoder's counts are turned into positions, and measure again",
          [joint = slip.joint, after = slip.after, change = slip.change](Recording& changed, std::vector<Artefact>&) {
            for (std::size_t i = 0; i < after.size(); ++i) {
              changed.joints(joint, static_cast<Eigen::Index>(i)) += after[i] ? change : 0.0;
            }
          }};
}

}  // namespace artcal
