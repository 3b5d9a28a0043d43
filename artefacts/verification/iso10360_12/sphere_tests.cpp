#include "artefacts/verification/iso10360_12/sphere_tests.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "artefacts/verification/measured.h"
#include "fitting/fit.h"

namespace artcal {
namespace {

constexpr double least_step = 1e-12;     // mm
constexpr std::size_t min_scanned = 20;  // points of a scan, of which 95 % are not all

/// One position of a ball in one repeat.
struct Position {
  std::vector<Touched> orientations;

  [[nodiscard]] bool is_articulated() const { return orientations.size() > 1; }
};

TestValue value_at(const Session& session, const Touched& touched, Quantity quantity, const MeasuredPoint& measured,
                   const std::vector<int>& readings) {
  const auto& [recording, constraints, arm, tips, specification, identification] = session;
  const Artefact& artefact = constraints.artefacts[touched.artefact];
  TestValue value;
  value.quantity = quantity;
  value.artefact = artefact.name;
  value.placement = recording.placements.name(touched.placement);
  value.repeat = recording.repeats.name(touched.repeat);
  value.first = artefact.features[touched.feature].name;
  value.temperature = mean_temperature(session, readings);
  value.budget.fixture = specification.u_fixture;
  value.place = place_of(measured.centre_in_base, recording, arm, readings);
  return value;
}

Budget form_budget(Budget budget, const CertifiedFeature& ball) {
  budget.form = form_uncertainty(ball.form.value_or(0.0), ball.u_form);
  return budget;
}

void add(Verification& verification, TestValue value, const Specification& specification) {
  judge(value, specification);
  verification.values.push_back(std::move(value));
}

void add_size_and_form(const Session& session, const Touched& touched, Verification& verification) {
  const bool scanned = is_scanned(session, touched.readings);
  const auto measured = measure(session, touched);
  if (!measured) {
    verification.missing.push_back("P_Size and P_Form: " + measured.error().text());
    return;
  }
  verification.scatter(measured->kind).add(measured->squares, measured->degrees_of_freedom);
  if (scanned && touched.readings.size() < min_scanned) {
    verification.missing.push_back(
        fmt::format("P_Form.Sph.D95%: {}: {} points, and 95 % of fewer than {} are all of them",
                    text_of(touched, session), touched.readings.size(), min_scanned));
    return;
  }
  const Artefact& artefact = session.constraints.artefacts[touched.artefact];
  const CertifiedFeature& ball = artefact.features[touched.feature];
  TestValue form =
      value_at(session, touched, scanned ? Quantity::FormErrorD95 : Quantity::FormError, *measured, touched.readings);
  form.value = form.measured = scanned ? measured->form_95 : measured->form;
  form.budget = form_budget(form.budget, ball);
  if (ball.radius) {
    TestValue size =
        value_at(session, touched, scanned ? Quantity::SizeErrorAll : Quantity::SizeError, *measured, touched.readings);
    size.certified = 2.0 * *ball.radius;
    size.measured = measured->diameter / expansion_factor_or_one(artefact, size.temperature);
    size.value = size.measured - size.certified;
    size.budget.calibration = 2.0 * ball.u_radius;
    const double of_radius = std::sqrt(measured->cofactor(3, 3));
    size.dilution.add(measured->kind, 2.0 * of_radius, of_radius, ball.name);
    size.budget = with_thermal(size.budget, size.certified, thermal_state(session, artefact, size.temperature));
    add(verification, size, session.specification);
  } else {
    verification.missing.push_back(fmt::format("P_Size: the ball {} has no calibrated diameter", artefact.name));
  }
  add(verification, form, session.specification);
}

Expected<Sphere> smallest_sphere_around(const Eigen::Matrix3Xd& centres) {
  FitOptions smallest;
  smallest.criterion = Criterion::MinimumCircumscribed;
  return fit<Sphere>(centres, smallest).map([](const Fitted<Sphere>& fitted) { return fitted.feature; });
}

// Of the diameter of that sphere by each centre, by central differences: only a few centres hold it, and which do
// follows from all. Zero where the sphere is a point.
Eigen::Matrix3Xd gradient_of_diameter(const Eigen::Matrix3Xd& centres, double radius) {
  const Eigen::Matrix3Xd about_mean = centres.colwise() - centres.rowwise().mean();
  const double step = 1e-3 * radius;
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, centres.cols());
  for (Eigen::Index i = 0; i < gradient.size() && step > least_step; ++i) {
    Eigen::Matrix3Xd more = about_mean, less = about_mean;
    more.reshaped()(i) += step;
    less.reshaped()(i) -= step;
    const auto larger = smallest_sphere_around(more), smaller = smallest_sphere_around(less);
    gradient.reshaped()(i) = larger && smaller ? (larger->radius - smaller->radius) / step : 0.0;
  }
  return gradient;
}

void add_location(const Session& session, const Position& position, Verification& verification) {
  const Touched& first = position.orientations.front();
  Eigen::Matrix3Xd centres(3, static_cast<Eigen::Index>(position.orientations.size()));
  std::vector<int> readings;
  std::vector<MeasuredPoint> balls;
  for (Eigen::Index i = 0; i < centres.cols(); ++i) {
    const Touched& touched = position.orientations[i];
    const auto measured = measure(session, touched);
    if (!measured) {
      verification.missing.push_back("L_Dia: " + measured.error().text());
      return;
    }
    verification.scatter(measured->kind).add(measured->squares, measured->degrees_of_freedom);
    balls.push_back(*measured);
    centres.col(i) = measured->centre_in_base;
    readings.insert(readings.end(), touched.readings.begin(), touched.readings.end());
  }
  const auto around = smallest_sphere_around(centres);
  if (!around) {
    verification.missing.push_back("L_Dia: " + around.error().text());
    return;
  }
  const Artefact& artefact = session.constraints.artefacts[first.artefact];
  TestValue value =
      value_at(session, first, Quantity::LocationDiameter, {around->centre, 2.0 * around->radius, 0.0, 0.0}, readings);
  value.value = value.measured = 2.0 * around->radius;
  const Eigen::Matrix3Xd gradient = gradient_of_diameter(centres, around->radius);
  for (Eigen::Index i = 0; i < centres.cols(); ++i) {
    if (const double size = gradient.col(i).norm(); size > 0.0) {
      const MeasuredPoint& ball = balls[static_cast<std::size_t>(i)];
      const double along = dilution_along(ball, gradient.col(i) / size);
      value.dilution.add(ball.kind, size * along, along, artefact.features[first.feature].name);
    }
  }
  value.budget = form_budget(value.budget, artefact.features[first.feature]);
  add(verification, value, session.specification);
}

}  // namespace

bool is_single_ball(const Artefact& artefact) {
  return artefact.features.size() == 1 && artefact.features.front().kind == FeatureKind::Sphere;
}

void add_sphere_tests(const Session& session, Verification& verification) {
  std::map<std::tuple<int, int, int>, Position> articulated;
  std::map<std::pair<int, int>, std::set<int>> orientations;
  const auto all = touched_features(session, Orientations::Apart);
  for (const Touched& touched : all) {
    orientations[{touched.artefact, touched.placement}].insert(touched.orientation);
  }
  for (const Touched& touched : all) {
    if (!is_single_ball(session.constraints.artefacts[touched.artefact])) {
      continue;
    }
    const bool one_for_all = orientations[{touched.artefact, touched.placement}].size() == 1;
    if (one_for_all || session.recording.orientations.name(touched.orientation).empty()) {
      add_size_and_form(session, touched, verification);
    } else {
      articulated[{touched.artefact, touched.placement, touched.repeat}].orientations.push_back(touched);
    }
  }
  for (const auto& [key, position] : articulated) {
    if (position.is_articulated()) {
      add_location(session, position, verification);
    }
  }
}

}  // namespace artcal
