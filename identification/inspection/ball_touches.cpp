#include "identification/inspection/ball_touches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include "artefacts/simulation/pattern.h"
#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

// Of the radius: touches nearer to one plane than this lie on a circle.
constexpr double flat = 0.02;
constexpr double singular_determinant = 1e-12;

// Of a centre in its worst direction where the radius is known.
double dilution_of_known_radius(const Eigen::Matrix3Xd& directions) {
  const Eigen::Matrix3d normal = directions * directions.transpose();
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(normal).eigenvalues()[0];
  return least > singular_determinant ? 1.0 / std::sqrt(least) : std::numeric_limits<double>::infinity();
}

double dilution_of(const OnBall& ball, const Eigen::Matrix3Xd& directions) {
  if (ball.radius || !ball.shared_radius) {
    return dilution_of_known_radius(directions);
  }
  std::vector<Eigen::Vector3d> all;
  for (Eigen::Index k = 0; k < directions.cols(); ++k) {
    all.emplace_back(directions.col(k));
  }
  return centre_dilution(all);
}

bool on_one_circle(const Eigen::Matrix3Xd& directions) {
  const Eigen::Matrix3Xd centred = directions.colwise() - directions.rowwise().mean();
  const Eigen::Vector3d sizes = Eigen::JacobiSVD<Eigen::Matrix3Xd>(centred).singularValues();
  return sizes[2] < flat * std::sqrt(static_cast<double>(directions.cols()));
}

// Half the angle of the cap about the mean direction that holds all touches, degrees.
double cap(const Eigen::Matrix3Xd& directions) {
  const Eigen::Vector3d middle = directions.rowwise().mean().normalized();
  const double least = (middle.transpose() * directions).minCoeff();
  return std::acos(std::clamp(least, -1.0, 1.0)) / units::degree;
}

}  // namespace

Findings find_undetermined_centres(const Recording& recording, const Constraints& constraints,
                                   const Evaluation& nominal) {
  Findings findings;
  std::size_t first = 0;
  for (std::size_t f = 0; f < constraints.features.size(); ++f) {
    const FeatureConstraint& feature = constraints.features[f];
    const std::size_t begin = first;
    first += feature.readings.size();
    const auto* ball = feature.as<OnBall>();
    if (ball == nullptr || feature.location != Location::Unknown || feature.size() < 4) {
      continue;
    }
    Eigen::Matrix3Xd directions(3, feature.size());
    for (int k = 0; k < feature.size(); ++k) {
      directions.col(k) = (nominal.tips[begin + static_cast<std::size_t>(k)] - nominal.points[f]).normalized();
    }
    const FeatureName name = name_of(feature, constraints, recording);
    const double dilution = dilution_of(*ball, directions);
    const bool circle = on_one_circle(directions);
    if (!circle && dilution <= max_centre_dilution) {
      continue;
    }
    const std::string what =
        circle ? "all lie on one circle, so that its centre has a mirror image on the other side of the circle's plane"
               : fmt::format(
                     "all lie within {:.0f} degrees of one direction, so that its centre is {:.3g} times as "
                     "uncertain as a touch (at most {:.0f} is sensible)",
                     cap(directions), dilution, max_centre_dilution);
    findings.push_back(
        {FindingKind::CentreNotDetermined, recording.where(feature.readings.front()),
         fmt::format("the {} touches of ball {} in placement {} {}. Touch it on all sides that are free, "
                     "the pole and the equator among them",
                     feature.size(), in_quotes(name.feature), in_quotes(name.placement), what)});
  }
  return findings;
}

}  // namespace artcal
