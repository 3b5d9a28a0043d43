#include "artefacts/verification/point_uncertainty.h"

#include <cmath>

#include <fmt/format.h>

#include "core/text/in_quotes.h"
#include "fitting/fit.h"

namespace artcal {
namespace {

constexpr double much_dilution = 2.5;  // of a single centre or radius: worth a warning
constexpr std::size_t plane_parameters = 3;

Eigen::Matrix3Xd tips_of(const Session& session, const std::vector<int>& readings) {
  Eigen::Matrix3Xd tips(3, static_cast<Eigen::Index>(readings.size()));
  for (Eigen::Index i = 0; i < tips.cols(); ++i) {
    tips.col(i) = session.tips.in_base.col(readings[static_cast<std::size_t>(i)]);
  }
  return tips;
}

// Seats and faces stay where they are from repeat to repeat.
void pool_seats_and_faces(const Session& session, Verification& verification) {
  for (const FeatureConstraint& constraint : session.constraints.features) {
    const Artefact& artefact = session.constraints.artefacts[static_cast<std::size_t>(constraint.artefact)];
    const FeatureKind kind = artefact.features[static_cast<std::size_t>(constraint.feature)].kind;
    const auto count = static_cast<int>(constraint.readings.size());
    if (kind == FeatureKind::Point && count > 1) {
      const Eigen::Matrix3Xd tips = tips_of(session, constraint.readings);
      const Eigen::Vector3d mean = tips.rowwise().mean();
      verification.scatter(PointKind::Seat).add((tips.colwise() - mean).squaredNorm(), 3 * (count - 1));
    } else if (kind == FeatureKind::Plane && constraint.readings.size() > plane_parameters) {
      if (const auto plane = fit<Plane>(tips_of(session, constraint.readings))) {
        verification.scatter(PointKind::Face).add(plane->residuals.squaredNorm(), plane->degrees_of_freedom);
      }
    }
  }
}

bool depends_on_balls_or_seats(const Dilution& dilution) {
  return dilution.of_value[static_cast<std::size_t>(PointKind::TouchedBall)] > 0.0 ||
         dilution.of_value[static_cast<std::size_t>(PointKind::ScannedBall)] > 0.0 ||
         dilution.of_value[static_cast<std::size_t>(PointKind::Seat)] > 0.0;
}

/// Values whose dilution is beyond something, told in one sentence by the worst of them.
class PoorlyDetermined {
 public:
  void add(const TestValue& value) {
    ++count_;
    if (worst_ == nullptr || value.dilution.worst > worst_->dilution.worst) {
      worst_ = &value;
    }
  }
  [[nodiscard]] bool any() const { return worst_ != nullptr; }
  [[nodiscard]] std::string text() const {
    return fmt::format(
        "{}: the touches on {} lie on so small a part of it that they determine its {} with {:.1f} times the scatter "
        "of one touch, u(points) = {:.1f} um{}; spread them from the pole to the equator",
        label_of(*worst_), in_quotes(worst_->dilution.worst_feature),
        worst_->second.empty() ? "size and place" : "centre", worst_->dilution.worst, 1e3 * worst_->budget.points,
        count_ > 1 ? fmt::format(" (the worst of {} such values)", count_) : "");
  }

 private:
  const TestValue* worst_ = nullptr;
  int count_ = 0;
};

}  // namespace

void add_point_uncertainties(const Session& session, Verification& verification) {
  pool_seats_and_faces(session, verification);
  const auto otherwise = session.identification != nullptr ? session.identification->noise : std::nullopt;
  PoorlyDetermined beyond, much;
  bool unknown = false;
  for (TestValue& value : verification.values) {
    const PointUncertainty points = point_uncertainty(value.dilution, verification.scatters, otherwise);
    value.budget.points = points.u;
    value.budget.points_freedom = points.degrees_of_freedom;
    judge(value, session.specification);
    unknown = unknown || (!points.is_known && depends_on_balls_or_seats(value.dilution));
    if (value.dilution.worst > max_dilution) {
      beyond.add(value);
    } else if (value.dilution.worst > much_dilution && 2.0 * points.u * points.u > std::pow(value.budget.total(), 2)) {
      much.add(value);
    }
  }
  if (beyond.any()) {
    report_missing(verification, session.specification, Evidence::CentreDilution, beyond.text());
  }
  if (much.any()) {
    verification.warnings.push_back(much.text());
  }
  if (unknown && session.specification.rule != DecisionRule::Simple) {
    report_missing(
        verification, session.specification, Evidence::CentreDilution,
        "no feature was touched more often than determining it takes, so that the scatter of the touches is not "
        "known and u lacks it; touch each ball in five points or more, each seat twice");
  }
}

}  // namespace artcal
