#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "core/normal_vector.h"
#include "core/random.h"

namespace artcal::testing {

/// What a point of a simulated scan lies on; balls count from 0.
namespace on {
inline constexpr int stem = -1, table = -2, mixed = -3, stray = -4, bar = -5;
}

struct ScanSettings {
  std::uint64_t seed = 1;
  std::vector<Eigen::Vector3d> centres;  ///< mm, in the artefact's frame; stems go down, against z
  double radius = 12.7;
  double noise = 0.02;        ///< of each coordinate, mm
  double spacing = 1.2;       ///< of the rays over the whole scene, mm
  double ball_spacing = 0.5;  ///< of further rays over each ball, mm; 0 for none
  double mixed = 0.05;        ///< mixed pixels, as a share of the points on balls
  double missing = 0.3;       ///< of each ball's points, lost in patches
  bool stems = true;
  bool table = true;
  std::vector<int> balls_not_there;
  std::vector<Eigen::Vector3d> strays;  ///< centres of further balls of the same radius
  int views = 1;                        ///< directions that the scanner looks from
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  bool turned = true;  ///< the artefact stands at a random attitude
};

struct SimulatedScan {
  Eigen::Matrix3Xd points;               ///< mm, in the scanner's frame
  std::vector<int> labels;               ///< one a point
  std::vector<Eigen::Vector3d> centres;  ///< of the balls, in the scanner's frame; those not there too
  [[nodiscard]] std::vector<int> points_on(int label) const {
    std::vector<int> which;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (labels[i] == label) which.push_back(static_cast<int>(i));
    }
    return which;
  }
};

/// A scan with known truth: parallel rays from each view onto balls on stems, a bar below them and a table, the
/// first surface that a ray meets seen with noise; patches of each ball lost; rays along a ball's edge that come
/// back from anywhere between ball and background.
class ScanSimulation {
 public:
  explicit ScanSimulation(const ScanSettings& settings) : s_(settings), random_(settings.seed, "scan") {}

  SimulatedScan run() {
    place_balls();
    for (int view = 0; view < s_.views; ++view) {
      scan_from(view);
    }
    lose_patches();
    mix_pixels();
    return finished();
  }

 private:
  using V = Eigen::Vector3d;
  struct Ball {
    V centre;
    int label;
  };
  struct Hit {
    double t = std::numeric_limits<double>::infinity();
    int label = 0;
  };
  struct Sample {
    V origin, direction;
    Hit hit;
    bool lost = false;
  };

  void place_balls() {
    for (std::size_t i = 0; i < s_.centres.size(); ++i) {
      if (std::find(s_.balls_not_there.begin(), s_.balls_not_there.end(), static_cast<int>(i)) ==
          s_.balls_not_there.end()) {
        balls_.push_back({s_.centres[i], static_cast<int>(i)});
      }
    }
    for (const V& stray : s_.strays) balls_.push_back({stray, on::stray});
    low_ = high_ = s_.centres.empty() ? V(V::Zero()) : s_.centres.front();
    for (const Ball& ball : balls_) {
      low_ = low_.cwiseMin(ball.centre);
      high_ = high_.cwiseMax(ball.centre);
    }
    low_.array() -= 4.0 * s_.radius;
    high_.array() += 4.0 * s_.radius;
  }

  // The first surface along o + t·v, one ball passed over where asked.
  [[nodiscard]] Hit cast(const V& o, const V& v, int passed_over = -1) const {
    Hit hit;
    const double r = s_.radius;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      const V& c = balls_[i].centre;
      const V to = c - o;
      const double along = to.dot(v);
      const double apart = to.squaredNorm() - along * along;
      if (apart > 9.0 * r * r) continue;
      if (apart < r * r && static_cast<int>(i) != passed_over)
        take(hit, along - std::sqrt(r * r - apart), balls_[i].label);
      if (s_.stems) take(hit, stem(o, v, c), on::stem);
    }
    if (s_.stems) take(hit, rectangle(o, v, low_.z() + 1.5 * r, 3.0 * r), on::bar);
    if (s_.table) take(hit, rectangle(o, v, low_.z(), 0.0), on::table);
    return hit;
  }
  static void take(Hit& hit, double t, int label) {
    if (t < hit.t) hit = {t, label};
  }
  // A cylinder of a third of the ball's radius, from inside the ball down to the bar.
  [[nodiscard]] double stem(const V& o, const V& v, const V& c) const {
    const double r = s_.radius / 3.0;
    const Eigen::Vector2d p = (o - c).head<2>(), d = v.head<2>();
    const double a = d.squaredNorm(), b = p.dot(d), q = p.squaredNorm() - r * r;
    if (a < 1e-12 || b * b < a * q) return std::numeric_limits<double>::infinity();
    const double t = (-b - std::sqrt(b * b - a * q)) / a;
    const double z = o.z() + t * v.z() - c.z();
    return z < 0.0 && z > -2.5 * s_.radius ? t : std::numeric_limits<double>::infinity();
  }
  // Level, as large as the scene less a margin in y.
  [[nodiscard]] double rectangle(const V& o, const V& v, double z, double margin) const {
    const double t = (z - o.z()) / v.z();
    const V p = o + t * v;
    const bool inside =
        p.x() > low_.x() && p.x() < high_.x() && p.y() > low_.y() + margin && p.y() < high_.y() - margin;
    return inside ? t : std::numeric_limits<double>::infinity();
  }

  void scan_from(int view) {
    const double tilt = view == 0 ? 0.3 : 0.6;
    const double turn = random_.uniform(0.0, 6.283);
    const V v = -V(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt));
    const V middle = 0.5 * (low_ + high_);
    raster(V(middle.x(), middle.y(), low_.z()), 0.5 * (high_ - low_).head<2>(), v, s_.spacing);
    if (s_.ball_spacing > 0.0) {
      for (const Ball& ball : balls_) raster(ball.centre, {1.3 * s_.radius, 1.3 * s_.radius}, v, s_.ball_spacing);
    }
  }
  // Rays through a level rectangle, a jittered grid.
  void raster(const V& middle, const Eigen::Vector2d& half, const V& v, double spacing) {
    for (double x = -half.x(); x < half.x(); x += spacing) {
      for (double y = -half.y(); y < half.y(); y += spacing) {
        const double across = random_.uniform(0.0, spacing);
        const double along = random_.uniform(0.0, spacing);
        const V through = middle + V(x + along, y + across, 0.0);
        const V origin = through - 1000.0 * v;
        const Hit hit = cast(origin, v);
        samples_.push_back({origin, v, hit, false});
      }
    }
  }

  void lose_patches() {
    for (std::size_t b = 0; b < balls_.size(); ++b) {
      std::vector<std::size_t> own;
      for (std::size_t i = 0; i < samples_.size(); ++i) {
        const Sample& s = samples_[i];
        if (s.hit.label == balls_[b].label && std::abs((point(s) - balls_[b].centre).norm() - s_.radius) < 1e-6)
          own.push_back(i);
      }
      std::size_t lost = 0;
      while (!own.empty() && static_cast<double>(lost) < s_.missing * static_cast<double>(own.size())) {
        const V hole =
            point(samples_[own[static_cast<std::size_t>(random_.uniform() * static_cast<double>(own.size()))]]);
        const double size = s_.radius * random_.uniform(0.1, 0.4);
        for (const std::size_t i : own) {
          if (!samples_[i].lost && (point(samples_[i]) - hole).norm() < size) {
            samples_[i].lost = true;
            ++lost;
          }
        }
      }
    }
  }

  void mix_pixels() {
    std::vector<std::size_t> edge;
    std::vector<std::pair<double, double>> span;
    std::size_t on_balls = 0;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      Sample& s = samples_[i];
      if (s.lost) continue;
      on_balls += s.hit.label >= 0 ? 1 : 0;
      for (std::size_t b = 0; b < balls_.size(); ++b) {
        const V to = balls_[b].centre - s.origin;
        const double along = to.dot(s.direction);
        const double apart = std::sqrt(std::max(0.0, to.squaredNorm() - along * along));
        if (apart > 0.96 * s_.radius && apart < 1.02 * s_.radius) {
          const double behind = std::min(cast(s.origin, s.direction, static_cast<int>(b)).t, along + 8.0 * s_.radius);
          const double front = along - std::sqrt(std::max(0.0, s_.radius * s_.radius - apart * apart));
          if (behind > front) {
            edge.push_back(i);
            span.emplace_back(front, behind);
          }
        }
      }
    }
    auto wanted = static_cast<std::size_t>(s_.mixed * static_cast<double>(on_balls));
    for (std::size_t k = 0; k < edge.size() && wanted > 0; ++k) {
      if (random_.uniform() * static_cast<double>(edge.size() - k) < static_cast<double>(wanted)) {
        samples_[edge[k]].hit = {random_.uniform(span[k].first, span[k].second), on::mixed};
        --wanted;
      }
    }
  }

  SimulatedScan finished() {
    const Eigen::Matrix3d turn = s_.turned ? random_.rotation() : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    SimulatedScan scan;
    for (const V& c : s_.centres) scan.centres.push_back(turn * c + s_.offset);
    std::vector<V> points;
    for (const Sample& s : samples_) {
      if (!s.lost && std::isfinite(s.hit.t)) {
        points.push_back(turn * point(s) + s_.offset + s_.noise * normal_vector(random_));
        scan.labels.push_back(s.hit.label);
      }
    }
    scan.points.resize(3, static_cast<Eigen::Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) scan.points.col(static_cast<Eigen::Index>(i)) = points[i];
    return scan;
  }
  static V point(const Sample& s) { return s.origin + s.hit.t * s.direction; }

  ScanSettings s_;
  RandomStream random_;
  std::vector<Ball> balls_;
  std::vector<Sample> samples_;
  V low_, high_;
};

inline SimulatedScan simulate_scan(const ScanSettings& settings) { return ScanSimulation(settings).run(); }

/// Balls on a line; the distances from the first.
inline std::vector<Eigen::Vector3d> ball_bar(const std::vector<double>& places) {
  std::vector<Eigen::Vector3d> centres;
  for (const double x : places) centres.emplace_back(x, 0.0, 0.0);
  return centres;
}

/// rows × columns balls in a plane; pitch in mm.
inline std::vector<Eigen::Vector3d> sphere_plate(int rows, int columns, double pitch) {
  std::vector<Eigen::Vector3d> centres;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) centres.emplace_back(pitch * j, pitch * i, 0.0);
  }
  return centres;
}

/// The best that can be done: the centre of the sphere of known radius through the points that are truly on it,
/// by plain Gauss-Newton steps of its own.
inline Eigen::Vector3d least_squares_limit(const SimulatedScan& scan, int label, Eigen::Vector3d centre,
                                           double radius) {
  const std::vector<int> own = scan.points_on(label);
  for (int step = 0; step < 20; ++step) {
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (const int i : own) {
      const Eigen::Vector3d way = scan.points.col(i) - centre;
      const Eigen::Vector3d u = way.normalized();
      a += u * u.transpose();
      b += (way.norm() - radius) * u;
    }
    centre += a.inverse() * b;
  }
  return centre;
}

}  // namespace artcal::testing
