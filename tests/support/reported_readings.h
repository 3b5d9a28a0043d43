#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "acquisition/recording/recording.h"
#include "artefacts/artefact/artefact.h"
#include "artefacts/constraints/constraint.h"
#include "artefacts/verification/session.h"
#include "core/random.h"
#include "core/rigid.h"

/// Recordings of coordinates with planted truth, for the tests of verification. Nothing here is taken from
/// the code under test.
namespace artcal::testing {

struct Label {
  std::string artefact, placement, feature, orientation, repeat;
};

/// Directions of the 25-point pattern: pole, 4 at 22.5°, 8 at 45°, 4 at 67.5°, 8 at 90° from it, each ring
/// turned by 22.5° (as remembered, not checked against a standard's text).
inline std::vector<Eigen::Vector3d> pattern_25() {
  constexpr double degree = std::numbers::pi / 180.0;
  std::vector<Eigen::Vector3d> directions{Eigen::Vector3d::UnitZ()};
  double turn = 0.0;
  for (const auto& [count, down] : {std::pair{4, 22.5}, {8, 45.0}, {4, 67.5}, {8, 90.0}}) {
    for (int i = 0; i < count; ++i) {
      const double around = turn + 360.0 * i / count;
      directions.emplace_back(std::sin(down * degree) * std::cos(around * degree),
                              std::sin(down * degree) * std::sin(around * degree), std::cos(down * degree));
    }
    turn += 22.5;
  }
  return directions;
}

/// Pole and four on a ring at 60° from it.
inline std::vector<Eigen::Vector3d> pattern_5() {
  std::vector<Eigen::Vector3d> directions{Eigen::Vector3d::UnitZ()};
  const double sine = std::sin(std::numbers::pi / 3);
  for (int i = 0; i < 4; ++i) {
    directions.emplace_back(sine * std::cos(i * std::numbers::pi / 2), sine * std::sin(i * std::numbers::pi / 2), 0.5);
  }
  return directions;
}

/// Pole and four on the equator: of five touches those that determine the centre best about a stem.
inline std::vector<Eigen::Vector3d> pattern_5_wide() {
  return {{0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {-1.0, 0.0, 0.0}, {0.0, -1.0, 0.0}};
}

class ReportedReadings {
 public:
  explicit ReportedReadings(double tip_radius = 3.0) {
    Probe probe;
    probe.radius = tip_radius;
    recording_.arm.name = "reports its own coordinates";
    recording_.arm.probes = {probe};
    recording_.name = "made up";
    recording_.files = {"made-up.csv"};
  }

  void add(const Label& label, const Eigen::Vector3d& tip_in_base, double temperature = 20.0) {
    Reading reading;
    reading.artefact = recording_.artefacts.index_of(label.artefact);
    reading.placement = recording_.placements.index_of(label.placement);
    reading.feature = recording_.features.index_of(label.feature);
    reading.orientation = recording_.orientations.index_of(label.orientation);
    reading.repeat = recording_.repeats.index_of(label.repeat);
    reading.temperature = temperature;
    reading.tip = tip_in_base;
    reading.line = static_cast<int>(recording_.readings.size()) + 2;
    recording_.readings.push_back(reading);
  }

  /// Touches a ball along `directions`, each reading with normal noise (mm a coordinate).
  void touch_ball(const Label& label, const Eigen::Vector3d& centre, double radius,
                  const std::vector<Eigen::Vector3d>& directions, double noise, RandomStream& random,
                  double temperature = 20.0) {
    for (const auto& direction : directions) {
      const Eigen::Vector3d off{random.normal(), random.normal(), random.normal()};
      add(label, centre + (radius + recording_.arm.probes[0].radius) * direction + noise * off, temperature);
    }
  }

  [[nodiscard]] Recording recording() const {
    Recording result = recording_;
    result.joints.resize(0, static_cast<Eigen::Index>(result.readings.size()));
    return result;
  }

 private:
  Recording recording_;
};

/// A recording of a day, unless it has one.
inline Recording dated(Recording recording) {
  recording.date = recording.date.empty() ? "2026-03-10" : recording.date;
  return recording;
}

/// Artefacts with certificates that are valid on that day, unless they have some.
inline std::vector<Artefact> certified(std::vector<Artefact> artefacts) {
  for (Artefact& artefact : artefacts) {
    Certificate& certificate = artefact.certificate;
    if (certificate.number.empty() && certificate.date.empty()) {
      certificate = {"K-1", "made-up laboratory", "2026-03-02", "2028-03-01"};
    }
  }
  return artefacts;
}

/// Everything that a session refers to, kept together. Its certificates and its day are sound unless a test says
/// otherwise afterwards.
struct SessionMaterial {
  Recording recording;
  Constraints constraints;
  TipCentres tips;
  Specification specification;

  SessionMaterial(Recording read, std::vector<Artefact> artefacts, Specification by)
      : recording(dated(std::move(read))),
        constraints(build_constraints(recording, certified(std::move(artefacts))).value()),
        tips(tip_centres(recording).value()),
        specification(std::move(by)) {}
  [[nodiscard]] Session session() const { return {recording, constraints, recording.arm, tips, specification}; }
};

inline CertifiedFeature ball(std::string name, double diameter) {
  CertifiedFeature feature;
  feature.name = std::move(name);
  feature.kind = FeatureKind::Sphere;
  feature.radius = 0.5 * diameter;
  feature.u_radius = 0.1e-3;
  feature.form = 0.1e-3;
  feature.u_form = 0.05e-3;
  return feature;
}

}  // namespace artcal::testing
