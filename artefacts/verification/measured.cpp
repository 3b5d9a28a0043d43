#include "artefacts/verification/measured.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <Eigen/QR>

#include "core/text/in_quotes.h"
#include "fitting/fit.h"

namespace artcal {
namespace {

// Readings farther off a ball than this share of its radius are not on it.
constexpr double no_ball = 0.5;
constexpr Eigen::Index min_points = 4;

Eigen::Matrix3Xd centres_of(const Session& session, const std::vector<int>& readings) {
  Eigen::Matrix3Xd centres(3, static_cast<Eigen::Index>(readings.size()));
  for (std::size_t i = 0; i < readings.size(); ++i) {
    centres.col(static_cast<Eigen::Index>(i)) = session.tips.in_base.col(readings[i]);
  }
  return centres;
}

Expected<double> one_tip_radius(const Session& session, const Touched& touched) {
  const auto radius_of = [&](int reading) { return tip_radius(session.recording, reading, session.arm); };
  const double radius = radius_of(touched.readings.front());
  for (const int reading : touched.readings) {
    if (radius_of(reading) != radius) {
      return bad_input(
          "one feature was touched with tips of several radii; give them labels of their own, such as "
          "another repeat",
          session.recording.where(reading));
    }
  }
  return radius;
}

// Of the intervals that hold that share of the values the smallest.
double narrowest_range(const Eigen::VectorXd& values, double share) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const auto held = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  double narrowest = sorted.back() - sorted.front();
  for (std::size_t i = 0; i + held <= sorted.size(); ++i) {
    narrowest = std::min(narrowest, sorted[i + held - 1] - sorted[i]);
  }
  return narrowest;
}

tl::unexpected<Error> not_one_ball(const std::string& where, const std::string& found) {
  return no_solution(
      fmt::format("{}: the readings do not lie on one ball ({}); was the artefact moved under one "
                  "placement label, or another ball touched?",
                  where, found));
}

// (JᵀJ)⁻¹ of the touches' distances from a sphere by its centre and radius, from the triangle of a QR decomposition.
Eigen::Matrix4d cofactor_of(const Eigen::Matrix3Xd& tips, const Eigen::Vector3d& centre) {
  Eigen::MatrixX4d rows(tips.cols(), 4);
  rows.leftCols<3>() = -(tips.colwise() - centre).colwise().normalized().transpose();
  rows.col(3).setConstant(-1.0);
  const Eigen::HouseholderQR<Eigen::MatrixX4d> qr(rows);
  const Eigen::Matrix4d triangle = qr.matrixQR().topRows<4>().triangularView<Eigen::Upper>();
  const Eigen::Matrix4d inverse = triangle.triangularView<Eigen::Upper>().solve(Eigen::Matrix4d::Identity());
  return inverse * inverse.transpose();
}

Expected<MeasuredPoint> measure_ball(const Session& session, const Touched& touched, const CertifiedFeature& feature) {
  const auto radius = one_tip_radius(session, touched);
  if (!radius) {
    return tl::unexpected(radius.error());
  }
  const Eigen::Matrix3Xd centres = centres_of(session, touched.readings);
  if (feature.radius) {
    const double across = (centres.colwise() - centres.col(0)).colwise().norm().maxCoeff();
    if (across > (2.0 + no_ball) * (*feature.radius + *radius)) {
      return not_one_ball(text_of(touched, session), fmt::format("they are {:.4g} mm apart, and the ball has {:.4g} mm",
                                                                 across, 2.0 * *feature.radius));
    }
  }
  if (centres.cols() < min_points) {
    return no_solution(
        fmt::format("{}: {} readings on a ball, which takes at least {}; the column repeat counts "
                    "repetitions of the test, not its points",
                    text_of(touched, session), centres.cols(), min_points));
  }
  FitOptions options;
  options.tip_radius = *radius;
  const auto fitted = fit<Sphere>(centres, options);
  if (!fitted) {
    return tl::unexpected(Error{fitted.error().code, fitted.error().message, text_of(touched, session)});
  }
  const double expected = feature.radius.value_or(fitted->feature.radius);
  if (fitted->form > no_ball * expected || std::abs(fitted->feature.radius - expected) > no_ball * expected) {
    return not_one_ball(text_of(touched, session),
                        fmt::format("the certified ball has {:.4g} mm, the fitted one {:.4g} mm with residuals over "
                                    "{:.3g} mm",
                                    2.0 * expected, 2.0 * fitted->feature.radius, fitted->form));
  }
  MeasuredPoint measured{fitted->feature.centre, 2.0 * fitted->feature.radius, fitted->form,
                         narrowest_range(fitted->residuals, 0.95)};
  measured.kind = is_scanned(session, touched.readings) ? PointKind::ScannedBall : PointKind::TouchedBall;
  measured.cofactor = cofactor_of(centres, fitted->feature.centre);
  measured.squares = fitted->residuals.squaredNorm();
  measured.degrees_of_freedom = fitted->degrees_of_freedom;
  return measured;
}

MeasuredPoint measure_seat(const Session& session, const Touched& touched) {
  const Eigen::Matrix3Xd centres = centres_of(session, touched.readings);
  const auto count = static_cast<double>(centres.cols());
  MeasuredPoint measured;
  measured.centre_in_base = centres.rowwise().mean();
  const Eigen::Matrix3Xd off = centres.colwise() - measured.centre_in_base;
  measured.form = off.colwise().norm().maxCoeff();
  measured.kind = PointKind::Seat;
  measured.cofactor.topLeftCorner<3, 3>().diagonal().setConstant(1.0 / count);
  measured.squares = off.squaredNorm();
  measured.degrees_of_freedom = 3 * (static_cast<int>(centres.cols()) - 1);
  return measured;
}

}  // namespace

double dilution_along(const MeasuredPoint& measured, const Eigen::Vector3d& direction) {
  return std::sqrt(direction.dot(measured.cofactor.topLeftCorner<3, 3>() * direction));
}

std::string text_of(const Touched& touched, const Session& session) {
  const Artefact& artefact = session.constraints.artefacts[touched.artefact];
  const auto& recording = session.recording;
  std::string text = fmt::format("feature {}, placement {}", in_quotes(artefact.features[touched.feature].name),
                                 in_quotes(recording.placements.name(touched.placement)));
  const auto& repeat = recording.repeats.name(touched.repeat);
  const auto& orientation = recording.orientations.name(touched.orientation);
  text += repeat.empty() ? "" : fmt::format(", repeat {}", in_quotes(repeat));
  return text + (orientation.empty() ? "" : fmt::format(", orientation {}", in_quotes(orientation)));
}

Expected<MeasuredPoint> measure(const Session& session, const Touched& touched) {
  const CertifiedFeature& feature = session.constraints.artefacts[touched.artefact].features[touched.feature];
  if (feature.kind == FeatureKind::Sphere) {
    return measure_ball(session, touched, feature);
  }
  if (feature.kind == FeatureKind::Point) {
    return measure_seat(session, touched);
  }
  return bad_input("neither a ball nor a seat, expected one of these", text_of(touched, session));
}

}  // namespace artcal
