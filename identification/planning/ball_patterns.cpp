#include "identification/planning/ball_patterns.h"

#include <algorithm>

#include "artefacts/simulation/pattern.h"
#include "artefacts/virtual_probing/postures.h"

namespace artcal {
namespace {

constexpr std::size_t ball_parameters = 4;
constexpr double least_gain = 1e-3;  // of an exchange, so that rounding ends none of them differently

double dilution_of(const std::vector<Eigen::Vector3d>& directions, const std::vector<int>& chosen) {
  std::vector<Eigen::Vector3d> touched;
  for (const int i : chosen) {
    touched.push_back(directions[static_cast<std::size_t>(i)]);
  }
  return centre_dilution(touched);
}

/// A ball in one placement and all possible readings of it.
struct Ball {
  int feature = 0;  ///< into Constraints::features
  std::vector<int> readings;
  std::vector<Eigen::Vector3d> directions;  ///< of each, from the centre

  /// Places of those of `chosen` that are on this ball, into `readings`.
  [[nodiscard]] std::vector<int> among(const std::vector<int>& chosen) const {
    std::vector<int> places;
    for (int i = 0; i < static_cast<int>(readings.size()); ++i) {
      if (std::find(chosen.begin(), chosen.end(), readings[static_cast<std::size_t>(i)]) != chosen.end()) {
        places.push_back(i);
      }
    }
    return places;
  }
};

std::vector<Ball> balls_in(const Simulation& possible, const Constraints& constraints, int placement) {
  const std::string& name = possible.recording.placements.name(placement);
  const auto place = std::find_if(possible.placements.begin(), possible.placements.end(),
                                  [&](const RealPlacement& real) { return real.name == name; });
  std::vector<Ball> balls;
  for (int f = 0; f < static_cast<int>(constraints.features.size()); ++f) {
    const FeatureConstraint& feature = constraints.features[static_cast<std::size_t>(f)];
    if (feature.placement != placement || !feature.is<OnBall>() || place == possible.placements.end()) {
      continue;
    }
    const RealArtefact& artefact = possible.artefacts[static_cast<std::size_t>(place->artefact)];
    const Eigen::Vector3d centre_in_base =
        place->base_from_artefact * artefact.features[static_cast<std::size_t>(feature.feature)].at;
    Ball ball{f, feature.readings, {}};
    for (const int reading : feature.readings) {
      const int probe = possible.recording.readings[static_cast<std::size_t>(reading)].probe;
      const Eigen::Vector3d tip_in_base = tip_at(possible.arm.arm, probe, possible.recording.joints.col(reading));
      ball.directions.push_back((tip_in_base - centre_in_base).normalized());
    }
    balls.push_back(std::move(ball));
  }
  return balls;
}

}  // namespace

std::vector<int> spread_touches(const std::vector<Eigen::Vector3d>& directions, std::vector<int> chosen) {
  double dilution = dilution_of(directions, chosen);
  while (chosen.size() >= ball_parameters && dilution > max_planned_dilution) {
    std::vector<int> best = chosen;
    double least = dilution;
    for (std::size_t out = 0; out < chosen.size(); ++out) {
      for (int in = 0; in < static_cast<int>(directions.size()); ++in) {
        if (std::find(chosen.begin(), chosen.end(), in) == chosen.end()) {
          std::vector<int> other = chosen;
          other[out] = in;
          if (const double with = dilution_of(directions, other); with < (1.0 - least_gain) * least) {
            least = with;
            best = std::move(other);
          }
        }
      }
    }
    if (best == chosen) {
      break;
    }
    chosen = std::move(best);
    dilution = least;
  }
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

std::vector<int> with_spread_touches(const Simulation& possible, const Constraints& constraints, int placement,
                                     const std::vector<int>& chosen) {
  std::vector<int> spread = chosen;
  for (const Ball& ball : balls_in(possible, constraints, placement)) {
    const std::vector<int> before = ball.among(spread);
    std::erase_if(spread, [&](int reading) {
      return std::find(ball.readings.begin(), ball.readings.end(), reading) != ball.readings.end();
    });
    for (const int place : spread_touches(ball.directions, before)) {
      spread.push_back(ball.readings[static_cast<std::size_t>(place)]);
    }
  }
  std::sort(spread.begin(), spread.end());
  return spread;
}

std::vector<PlannedBall> planned_balls(const Simulation& possible, const Constraints& constraints, int placement,
                                       const std::vector<int>& chosen) {
  std::vector<PlannedBall> planned;
  for (const Ball& ball : balls_in(possible, constraints, placement)) {
    const std::vector<int> touches = ball.among(chosen);
    if (!touches.empty()) {
      const FeatureConstraint& feature = constraints.features[static_cast<std::size_t>(ball.feature)];
      planned.push_back({constraints.artefacts[static_cast<std::size_t>(feature.artefact)]
                             .features[static_cast<std::size_t>(feature.feature)]
                             .name,
                         static_cast<int>(touches.size()), dilution_of(ball.directions, touches)});
    }
  }
  return planned;
}

}  // namespace artcal
