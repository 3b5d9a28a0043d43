#include "tests/support/probing/session.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <stdexcept>

#include <Eigen/Geometry>

namespace artcal::probing {
namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double ball_radius = 12.7;

/// Random numbers whose sequence the C++ standard fixes: the engine's, turned into normals by Box and Muller.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed * 0x9E3779B97F4A7C15ull + 12345) {}
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) + 0.5) / 9007199254740992.0;
  }
  double normal() {
    return std::sqrt(-2.0 * std::log(uniform(0.0, 1.0))) * std::cos(uniform(0.0, 2.0 * std::numbers::pi));
  }
  Eigen::Vector3d normals() {
    const double x = normal(), y = normal(), z = normal();
    return {x, y, z};
  }
  /// Evenly over the cap of `within` degrees about `pole`.
  Eigen::Vector3d direction(const Eigen::Vector3d& pole, double within) {
    const double height = uniform(std::cos(within * degree), 1.0);
    const double turn = uniform(0.0, 2.0 * std::numbers::pi);
    const double across = std::sqrt(std::max(0.0, 1.0 - height * height));
    const Eigen::Vector3d side = pole.unitOrthogonal();
    return height * pole + across * (std::cos(turn) * side + std::sin(turn) * pole.cross(side));
  }

 private:
  std::mt19937_64 engine_;
};

struct Pose {
  Eigen::Matrix3d rotation;
  Eigen::Vector3d shift;
  Eigen::Vector3d operator*(const Eigen::Vector3d& point) const { return rotation * point + shift; }
};

Pose any_pose(Dice& dice, double size) {
  Pose pose;
  pose.rotation = Eigen::Quaterniond(dice.normal(), dice.normal(), dice.normal(), dice.normal()).normalized();
  const Eigen::Vector3d middle =
      Eigen::Vector3d(0.0, 0.0, 300.0) + dice.uniform(500.0, 1200.0) * dice.direction(Eigen::Vector3d::UnitZ(), 120.0);
  pose.shift = middle - pose.rotation * Eigen::Vector3d(0.5 * size, 0.0, 0.0);
  return pose;
}

CertifiedFeature feature(int index, FeatureKind kind) {
  CertifiedFeature made;
  made.name = std::to_string(index);
  made.kind = kind;
  if (kind == FeatureKind::Sphere) {
    made.radius = ball_radius;
  }
  return made;
}

/// One artefact, where its features are, and how often each is read in a placement.
struct Thing {
  Artefact artefact;
  std::vector<Eigen::Vector3d> at, normals;
  double size = 0.0;
  double width = 0.0;  ///< of a plane, mm: contacts lie within half of it
  int readings = 0;
  int placements = 0;
};

Thing row(const std::string& name, FeatureKind kind, const std::vector<double>& places, int readings, int placements) {
  Thing thing;
  thing.artefact.name = name;
  for (std::size_t i = 0; i < places.size(); ++i) {
    thing.artefact.features.push_back(feature(static_cast<int>(i), kind));
    thing.at.emplace_back(places[i], 0.0, 0.0);
    thing.normals.push_back(Eigen::Vector3d::UnitZ());
    for (std::size_t j = 0; j < i; ++j) {
      thing.artefact.distances.push_back(
          {static_cast<int>(j), static_cast<int>(i), std::abs(places[i] - places[j]), 4e-4});
    }
  }
  thing.size = places.back();
  thing.readings = readings;
  thing.placements = placements;
  return thing;
}

Thing plate(int readings, int placements) {
  Thing thing = row("plate", FeatureKind::Sphere, {0.0}, readings, placements);
  thing.artefact.features.clear();
  thing.at.clear();
  for (int i = 0; i < 25; ++i) {
    thing.at.emplace_back(100.0 * (i % 5), 100.0 * (i / 5), 0.0);
    thing.normals.push_back(Eigen::Vector3d::UnitZ());
    thing.artefact.features.push_back(feature(i, FeatureKind::Sphere));
    thing.artefact.features.back().at = thing.at.back();
  }
  thing.size = 400.0;
  return thing;
}

Thing gauge(int readings, int placements) {
  Thing thing = row("gauge", FeatureKind::Plane, {0.0}, readings, placements);
  thing.artefact.features.clear();
  thing.at.clear();
  thing.normals.clear();
  for (int i = 0; i < 10; ++i) {
    const double facing = i % 2 == 0 ? -1.0 : 1.0;
    thing.at.emplace_back(80.0 * i, 0.0, 0.0);
    thing.normals.emplace_back(facing, 0.0, 0.0);
    thing.artefact.features.push_back(feature(i, FeatureKind::Plane));
    thing.artefact.features.back().at = thing.at.back();
    thing.artefact.features.back().normal = thing.normals.back();
  }
  thing.size = 720.0;
  thing.width = 15.0;
  return thing;
}

Thing faces(int readings, int placements) {
  Thing thing = row("block", FeatureKind::Plane, {0.0, 500.0}, readings, placements);
  thing.normals = {-Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitX()};
  thing.width = 60.0;
  return thing;
}

Thing table(int readings, int placements) {
  Thing thing = row("table", FeatureKind::Plane, {0.0}, readings, placements);
  thing.width = 500.0;
  return thing;
}

std::vector<Thing> things_of(const Probing& probing) {
  const int n = probing.placements;
  switch (probing.kind) {
    case Kind::Bar2: return {row("bar", FeatureKind::Sphere, {0.0, 500.0}, 25, n)};
    case Kind::Bar3: return {row("bar", FeatureKind::Sphere, {0.0, 300.0, 700.0}, 25, n)};
    case Kind::Bar4: return {row("bar", FeatureKind::Sphere, {0.0, 200.0, 500.0, 800.0}, 25, n)};
    case Kind::Plate: return {plate(9, n)};
    case Kind::Ball: return {row("ball", FeatureKind::Sphere, {0.0}, 60, n)};
    case Kind::Seats: return {row("seats", FeatureKind::Point, {0.0, 500.0}, 25, n)};
    case Kind::StepGauge: return {gauge(8, n)};
    case Kind::Planes: return {faces(20, n), table(60, 3)};
    case Kind::Mixed:
      return {row("bar", FeatureKind::Sphere, {0.0, 300.0, 700.0}, 15, n),
              row("seats", FeatureKind::Point, {0.0, 500.0}, 10, n), table(40, 2)};
  }
  throw std::logic_error("no such kind");
}

/// Where the centre of a tip is that touches a feature there, and the inward normal at the contact.
struct Contact {
  Eigen::Vector3d tip, inward;
};

Contact contact(Dice& dice, const Thing& thing, std::size_t f, const Pose& pose, double tip_radius, double cap) {
  const Eigen::Vector3d normal = pose.rotation * thing.normals[f];
  switch (thing.artefact.features[f].kind) {
    case FeatureKind::Sphere: {
      const Eigen::Vector3d outward = dice.direction(normal, cap);
      return {pose * thing.at[f] + (ball_radius + tip_radius) * outward, -outward};
    }
    case FeatureKind::Plane: {
      const Eigen::Vector3d side = normal.unitOrthogonal();
      const double half = 0.5 * thing.width;
      return {pose * thing.at[f] + dice.uniform(-half, half) * side + dice.uniform(-half, half) * normal.cross(side) +
                  tip_radius * normal,
              -normal};
    }
    default: return {pose * thing.at[f], -normal};
  }
}

std::optional<Eigen::VectorXd> joints_at(Dice& dice, const Chain& truth, const Contact& contact, double within) {
  for (int attempt = 0; attempt < 12; ++attempt) {
    Eigen::VectorXd q(6);
    for (double& angle : q) {
      angle = dice.uniform(-std::numbers::pi, std::numbers::pi);
    }
    if (auto found = reach(truth, contact.tip, dice.direction(contact.inward, within), q)) {
      for (double& angle : *found) {
        angle = std::remainder(angle, 2.0 * std::numbers::pi);
      }
      return found;
    }
  }
  return std::nullopt;
}

// One placement; nothing where some contact is out of reach.
std::optional<std::vector<Touch>> read_placement(Dice& dice, const Session& session, const Thing& thing, int artefact,
                                                 int placement, const Probing& probing) {
  const Pose pose = any_pose(dice, thing.size);
  std::vector<Touch> touches;
  for (std::size_t f = 0; f < thing.at.size(); ++f) {
    // Seats take the stylus from anywhere in a wide cone; nobody points it along one line only.
    const bool seat = thing.artefact.features[f].kind == FeatureKind::Point;
    for (int k = 0; k < thing.readings; ++k) {
      Contact touched = contact(dice, thing, f, pose, session.tip_radius, probing.cap);
      touched.tip += probing.noise * dice.normals();
      // The stylus cannot come through the material of a plane, and does not lie along it.
      const bool plane = thing.artefact.features[f].kind == FeatureKind::Plane;
      const double within = seat ? 60.0 : plane ? std::min(80.0, probing.stylus_within) : probing.stylus_within;
      const auto q = joints_at(dice, session.truth, touched, within);
      if (!q) {
        return std::nullopt;
      }
      touches.push_back({artefact, placement, static_cast<int>(f), *q});
    }
  }
  return touches;
}

}  // namespace

const char* name_of(Kind kind) {
  switch (kind) {
    case Kind::Bar2: return "bar of two";
    case Kind::Bar3: return "bar of three";
    case Kind::Bar4: return "bar of four";
    case Kind::Plate: return "5 x 5 plate";
    case Kind::Ball: return "single ball";
    case Kind::Seats: return "two seats";
    case Kind::StepGauge: return "step gauge";
    case Kind::Planes: return "planes";
    case Kind::Mixed: return "mixed";
  }
  return "";
}

Session probe(const Probing& probing) {
  Dice dice(probing.seed);
  Session session;
  session.nominal = gao_chain();
  session.nominal.alpha[5] = probing.last_alpha * degree;
  Eigen::VectorXd values = parameters(session.nominal);
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const bool length = i < 12 || i == 24;
    values[i] += probing.rough * (length ? 0.3 : 0.1 * degree) * dice.normal();
  }
  values[5] = values[11] = 0.0;  // a6 and d6, which no reading of one tip tells apart from theta6 and alpha6
  session.truth = with_parameters(session.nominal, values);
  for (const Thing& thing : things_of(probing)) {
    const int artefact = static_cast<int>(session.artefacts.size());
    session.artefacts.push_back(thing.artefact);
    for (int p = 0; p < thing.placements;) {
      if (auto touches = read_placement(dice, session, thing, artefact, p, probing)) {
        session.touches.insert(session.touches.end(), touches->begin(), touches->end());
        ++p;
      }
    }
  }
  for (int w = 0; w < probing.wrong_labels; ++w) {
    Touch& touch =
        session.touches[static_cast<std::size_t>(dice.uniform(0.0, static_cast<double>(session.touches.size())))];
    const auto count = static_cast<int>(session.artefacts[touch.artefact].features.size());
    touch.feature = (touch.feature + 1) % count;
  }
  return session;
}

Bound bound(const Session& session, double stated_noise) {
  Recording recording;
  recording.name = "probed";
  recording.files = {"readings.csv"};
  if (stated_noise > 0.0) {
    recording.noise.reading = stated_noise;
  }
  Arm& arm = recording.arm;
  arm.name = "nominal";
  for (int i = 0; i < session.nominal.joints(); ++i) {
    arm.joints.push_back({.a = session.nominal.a[i],
                          .d = session.nominal.d[i],
                          .theta = session.nominal.theta[i],
                          .alpha = session.nominal.alpha[i]});
  }
  Probe tip;
  tip.tip_in_last = {0.0, 0.0, session.nominal.l};
  tip.radius = session.tip_radius;
  tip.on_axis = true;
  arm.probes = {tip};
  recording.joints.resize(session.nominal.joints(), static_cast<Eigen::Index>(session.touches.size()));
  for (std::size_t i = 0; i < session.touches.size(); ++i) {
    const Touch& touch = session.touches[i];
    Reading reading;
    const Artefact& artefact = session.artefacts[touch.artefact];
    reading.artefact = recording.artefacts.index_of(artefact.name);
    reading.placement = recording.placements.index_of(artefact.name + " " + std::to_string(touch.placement));
    reading.feature = recording.features.index_of(artefact.features[touch.feature].name);
    reading.orientation = recording.orientations.index_of("");
    reading.repeat = recording.repeats.index_of("");
    reading.line = static_cast<int>(i) + 2;
    recording.readings.push_back(reading);
    recording.joints.col(static_cast<Eigen::Index>(i)) = touch.q;
  }
  auto constraints = build_constraints(recording, session.artefacts);
  if (!constraints) {
    throw std::runtime_error(constraints.error().text());
  }
  return {std::move(recording), std::move(*constraints)};
}

Chain chain_of(const Arm& arm) {
  const auto n = static_cast<Eigen::Index>(arm.joints.size());
  Chain chain;
  chain.a = chain.d = chain.theta = chain.alpha = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Joint& joint = arm.joints[static_cast<std::size_t>(i)];
    chain.a[i] = joint.a;
    chain.d[i] = joint.d;
    chain.theta[i] = joint.theta;
    chain.alpha[i] = joint.alpha;
  }
  chain.l = arm.probes.front().tip_in_last.z();
  return chain;
}

double length_error(const Chain& truth, const Chain& found) {
  Dice dice(77);
  double squares = 0.0;
  constexpr int pairs = 200;
  const auto any = [&] {
    Eigen::VectorXd q(truth.joints());
    for (double& angle : q) {
      angle = dice.uniform(-std::numbers::pi, std::numbers::pi);
    }
    return q;
  };
  for (int i = 0; i < pairs; ++i) {
    const Eigen::VectorXd p = any();
    const Eigen::VectorXd q = any();
    const double error =
        (posture(found, p).tip - posture(found, q).tip).norm() - (posture(truth, p).tip - posture(truth, q).tip).norm();
    squares += error * error;
  }
  return std::sqrt(squares / pairs);
}

}  // namespace artcal::probing
