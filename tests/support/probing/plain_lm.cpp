#include "tests/support/probing/plain_lm.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace artcal::probing {
namespace {

/// A point or a ball in one placement, and which of the unknowns is its centre or the pose that it hangs on.
struct Place {
  FeatureKind kind = FeatureKind::Point;
  double radii = 0.0;
  std::optional<Eigen::Vector3d> at;
  Eigen::Index first = 0;  // of three for a centre, of six for a pose
  std::vector<const Touch*> touches;
};

struct Between {
  Eigen::Index first = 0, second = 0;
  double length = 0.0, u = 0.0;
};

class Problem {
 public:
  Problem(const Session& session, double noise) : session_(session), noise_(noise) {
    const Chain& nominal = session.nominal;
    const int n = nominal.joints();
    for (int i = 0; i < 4 * n + 1; ++i) {
      // Fixed: a and d of the last joint; d and theta of the first, which move the base.
      if (i != n - 1 && i != 2 * n - 1 && i != n && i != 2 * n) free_.push_back(i);
    }
    values_ = parameters(nominal);
    collect();
    start();
  }

  Chain solve() {
    double damping = 1e-3;
    auto [normal, gradient, cost] = linearise();
    for (int iteration = 0; iteration < 300; ++iteration) {
      Eigen::MatrixXd damped = normal;
      damped.diagonal() += damping * normal.diagonal() + Eigen::VectorXd::Constant(normal.rows(), 1e-12);
      const Eigen::VectorXd step = damped.ldlt().solve(-gradient);
      const auto before = std::tuple(values_, unknowns_, rotations_);
      take(step);
      auto next = linearise();
      if (std::get<2>(next) < cost) {
        const bool done = cost - std::get<2>(next) < 1e-10 * cost;
        std::tie(normal, gradient, cost) = std::move(next);
        damping = std::max(1e-12, damping * 0.3);
        if (done) break;
      } else {
        std::tie(values_, unknowns_, rotations_) = before;
        damping *= 4.0;
        if (damping > 1e12) break;
      }
    }
    return with_parameters(session_.nominal, values_);
  }

 private:
  void collect() {
    std::map<std::tuple<int, int, int>, std::size_t> known;
    std::map<std::pair<int, int>, Eigen::Index> poses;
    Eigen::Index size = 0;
    for (const Touch& touch : session_.touches) {
      const Artefact& artefact = session_.artefacts[touch.artefact];
      const CertifiedFeature& feature = artefact.features[touch.feature];
      const auto [entry, is_new] = known.try_emplace({touch.artefact, touch.placement, touch.feature}, places_.size());
      if (is_new) {
        Place place{feature.kind, feature.radius.value_or(0.0) + session_.tip_radius, feature.at, size, {}};
        if (feature.at) {
          const auto [pose, new_pose] = poses.try_emplace({touch.artefact, touch.placement}, size);
          place.first = pose->second;
          size += new_pose ? 6 : 0;
        } else {
          size += 3;
        }
        places_.push_back(place);
      }
      places_[entry->second].touches.push_back(&touch);
    }
    for (const auto& [key, index] : known) {
      for (const auto& [other, second] : known) {
        if (std::get<0>(key) != std::get<0>(other) || std::get<1>(key) != std::get<1>(other)) continue;
        for (const CertifiedDistance& distance : session_.artefacts[std::get<0>(key)].distances) {
          if (distance.first == std::get<2>(key) && distance.second == std::get<2>(other)) {
            distances_.push_back({places_[index].first, places_[second].first, distance.value, distance.u});
          }
        }
      }
    }
    unknowns_ = Eigen::VectorXd::Zero(size);
  }

  [[nodiscard]] Eigen::Vector3d linear_centre(const Place& place, const Chain& chain) const {
    const auto count = static_cast<Eigen::Index>(place.touches.size());
    Eigen::MatrixX4d a(count, 4);
    Eigen::VectorXd b(count);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < count; ++i) mean += posture(chain, place.touches[i]->q).tip / count;
    for (Eigen::Index i = 0; i < count; ++i) {
      const Eigen::Vector3d p = posture(chain, place.touches[i]->q).tip - mean;
      a.row(i) << 2.0 * p.transpose(), 10.0;
      b[i] = p.squaredNorm() - place.radii * place.radii;
    }
    return place.kind == FeatureKind::Point ? mean : Eigen::Vector3d(mean + a.colPivHouseholderQr().solve(b).head<3>());
  }

  void start() {
    const Chain chain = with_parameters(session_.nominal, values_);
    std::map<Eigen::Index, std::pair<Eigen::Matrix3Xd, Eigen::Matrix3Xd>> plates;
    for (const Place& place : places_) {
      const Eigen::Vector3d centre = linear_centre(place, chain);
      if (!place.at) {
        unknowns_.segment<3>(place.first) = centre;
        continue;
      }
      auto& [from, onto] = plates[place.first];
      from.conservativeResize(3, from.cols() + 1);
      onto.conservativeResize(3, onto.cols() + 1);
      from.rightCols<1>() = *place.at;
      onto.rightCols<1>() = centre;
    }
    for (const auto& [first, pairs] : plates) {
      const Eigen::Matrix4d pose = Eigen::umeyama(pairs.first, pairs.second, false);
      rotations_[first] = pose.topLeftCorner<3, 3>();
      unknowns_.segment<3>(first + 3) = pose.topRightCorner<3, 1>();
    }
  }

  void take(const Eigen::VectorXd& step) {
    for (std::size_t i = 0; i < free_.size(); ++i) values_[free_[i]] += step[static_cast<Eigen::Index>(i)];
    const Eigen::VectorXd rest = step.tail(unknowns_.size());
    unknowns_ += rest;
    for (auto& [first, rotation] : rotations_) {
      const Eigen::Vector3d turn = rest.segment<3>(first);
      if (turn.norm() > 0.0) rotation = rotation * Eigen::AngleAxisd(turn.norm(), turn.normalized());
      unknowns_.segment<3>(first).setZero();
    }
  }

  [[nodiscard]] std::tuple<Eigen::MatrixXd, Eigen::VectorXd, double> linearise() const {
    const Chain chain = with_parameters(session_.nominal, values_);
    const auto arm = static_cast<Eigen::Index>(free_.size());
    const Eigen::Index all = arm + unknowns_.size();
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(all, all);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(all);
    double cost = 0.0;
    for (const Place& place : places_) {
      const int size = place.at ? 6 : 3;
      for (const Touch* touch : place.touches) {
        const Posture at = posture(chain, touch->q);
        const Eigen::Matrix3Xd slope = tip_by_parameters(chain, at);
        Eigen::Matrix3Xd rows(3, arm + size);
        for (Eigen::Index i = 0; i < arm; ++i) rows.col(i) = slope.col(free_[static_cast<std::size_t>(i)]);
        Eigen::Vector3d centre = unknowns_.segment<3>(place.first);
        if (place.at) {
          const Eigen::Matrix3d& rotation = rotations_.at(place.first);
          centre = rotation * *place.at + unknowns_.segment<3>(place.first + 3);
          for (int k = 0; k < 3; ++k) {
            rows.col(arm + k) = -(rotation * Eigen::Vector3d::Unit(k).cross(*place.at));
          }
        }
        rows.rightCols<3>() = -Eigen::Matrix3d::Identity();
        Eigen::MatrixXd weighted = rows / noise_;
        Eigen::VectorXd residual = (at.tip - centre) / noise_;
        if (place.kind == FeatureKind::Sphere) {
          const double distance = (at.tip - centre).norm();
          const Eigen::RowVector3d direction = (at.tip - centre).transpose() / std::max(distance, 1e-12);
          weighted = direction * rows / noise_;
          residual = Eigen::VectorXd::Constant(1, (distance - place.radii) / noise_);
        }
        const Eigen::MatrixXd square = weighted.transpose() * weighted;
        const Eigen::VectorXd pull = weighted.transpose() * residual;
        const Eigen::Index first = arm + place.first;
        normal.topLeftCorner(arm, arm) += square.topLeftCorner(arm, arm);
        normal.block(0, first, arm, size) += square.topRightCorner(arm, size);
        normal.block(first, 0, size, arm) += square.bottomLeftCorner(size, arm);
        normal.block(first, first, size, size) += square.bottomRightCorner(size, size);
        gradient.head(arm) += pull.head(arm);
        gradient.segment(first, size) += pull.tail(size);
        cost += residual.squaredNorm();
      }
    }
    for (const Between& between : distances_) {
      const Eigen::Vector3d apart = unknowns_.segment<3>(between.second) - unknowns_.segment<3>(between.first);
      Eigen::VectorXd row = Eigen::VectorXd::Zero(6);
      row << -apart.normalized(), apart.normalized();
      row /= between.u;
      const double residual = (apart.norm() - between.length) / between.u;
      const Eigen::Index ends[] = {arm + between.first, arm + between.second};
      for (int i = 0; i < 2; ++i) {
        gradient.segment<3>(ends[i]) += row.segment<3>(3 * i) * residual;
        for (int j = 0; j < 2; ++j) {
          normal.block<3, 3>(ends[i], ends[j]) += row.segment<3>(3 * i) * row.segment<3>(3 * j).transpose();
        }
      }
      cost += residual * residual;
    }
    return {normal, gradient, cost};
  }

  const Session& session_;
  double noise_;
  std::vector<Eigen::Index> free_;
  Eigen::VectorXd values_, unknowns_;
  std::map<Eigen::Index, Eigen::Matrix3d> rotations_;
  std::vector<Place> places_;
  std::vector<Between> distances_;
};

}  // namespace

bool plain_lm_knows(const Session& session) {
  return std::all_of(session.artefacts.begin(), session.artefacts.end(), [](const Artefact& artefact) {
    return std::all_of(artefact.features.begin(), artefact.features.end(),
                       [](const CertifiedFeature& feature) { return feature.kind != FeatureKind::Plane; });
  });
}

Chain plain_lm(const Session& session, double noise) { return Problem(session, noise).solve(); }

}  // namespace artcal::probing
