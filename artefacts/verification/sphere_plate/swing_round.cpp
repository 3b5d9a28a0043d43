#include "artefacts/verification/sphere_plate/swing_round.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "artefacts/verification/sphere_plate/rigid_fit.h"
#include "core/statistics.h"
#include "core/units.h"

namespace artcal {
namespace {

constexpr int max_rounds = 100;
constexpr double tolerance = 1e-12;  // of the size of the plate

double turn_between(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return std::abs(Eigen::AngleAxisd(Eigen::Matrix3d(a.transpose() * b)).angle());
}

}  // namespace

Expected<PlateCalibration> mean_shape(const std::vector<Eigen::Matrix3Xd>& placements,
                                      const Eigen::Matrix3Xd& certified) {
  assert(placements.size() >= 2);
  const auto count = static_cast<double>(placements.size());
  Eigen::Matrix3Xd mean = certified;
  std::vector<Eigen::Matrix3Xd> moved(placements.size());
  std::vector<Eigen::Matrix3d> turns(placements.size());
  for (int round = 0; round < max_rounds; ++round) {
    Eigen::Matrix3Xd next = Eigen::Matrix3Xd::Zero(3, certified.cols());
    for (std::size_t i = 0; i < placements.size(); ++i) {
      const auto fit = fit_rigid(mean, placements[i]);
      if (!fit) {
        return tl::unexpected(fit.error());
      }
      moved[i] = (fit->to_from.rotation * placements[i]).colwise() + fit->to_from.translation;
      turns[i] = fit->to_from.rotation;
      next += moved[i] / count;
    }
    const double change = (next - mean).norm();
    mean = next;
    if (change < tolerance * mean.norm()) {
      break;
    }
  }
  const auto onto = fit_rigid(certified, mean);
  if (!onto) {
    return tl::unexpected(onto.error());
  }
  PlateCalibration result;
  result.placements = static_cast<int>(placements.size());
  result.centres = (onto->to_from.rotation * mean).colwise() + onto->to_from.translation;
  result.deviations = result.centres - certified;
  result.u = Eigen::VectorXd::Zero(certified.cols());
  for (const auto& placement : moved) {
    result.u += (placement - mean).colwise().squaredNorm().transpose();
  }
  const double balls = static_cast<double>(certified.cols());
  result.degrees_of_freedom = (3.0 - 6.0 / balls) * (count - 1.0);
  result.u = (result.u / (count * result.degrees_of_freedom)).cwiseSqrt();
  result.least_turn = std::numbers::pi;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    for (std::size_t j = i + 1; j < turns.size(); ++j) {
      result.least_turn = std::min(result.least_turn, turn_between(turns[i], turns[j]));
    }
  }
  return result;
}

Artefact calibrated_artefact(const Artefact& certified, const PlateCalibration& calibration) {
  Artefact artefact = certified;
  artefact.features.clear();
  artefact.distances.clear();
  artefact.certificate = {};
  artefact.note = fmt::format(
      "Coordinates by a swing-round of {} placements, turned by at least {:.0f} degrees against each other; U by their "
      "scatter, written with k = 2; its {:.3g} degrees of freedom ask for k = {:.3g} for 95 %. The scale is the arm's "
      "and not in U: it needs a calibrated length. Diameters, form and expansion are "
      "those of the certificate of before.",
      calibration.placements, calibration.least_turn / units::degree, calibration.degrees_of_freedom,
      stated_coverage_factor(calibration.degrees_of_freedom));
  for (std::size_t i = 0; i < calibration.features.size(); ++i) {
    const int index = certified.feature_index(calibration.features[i]);
    CertifiedFeature feature = certified.features[static_cast<std::size_t>(index)];
    feature.at = calibration.centres.col(static_cast<Eigen::Index>(i));
    feature.u_at = calibration.u(static_cast<Eigen::Index>(i));
    artefact.features.push_back(std::move(feature));
  }
  return artefact;
}

}  // namespace artcal
