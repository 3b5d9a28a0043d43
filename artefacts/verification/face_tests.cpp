#include "artefacts/verification/face_tests.h"

#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include <fmt/format.h>
#include <Eigen/SVD>

#include "artefacts/verification/measured.h"
#include "core/in_quotes.h"

namespace artcal {
namespace {

constexpr double thinnest = 0.02;  // spread across over spread along: less is one line

struct Face {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  std::vector<int> readings;
};
using Faces = std::map<int, Face>;  // by feature

// The direction across all faces; nothing where their readings lie on one line each.
std::optional<Eigen::Vector3d> common_normal(const Session& session, const Faces& faces) {
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto& [feature, face] : faces) {
    for (const int reading : face.readings) {
      const Eigen::Vector3d off = session.tips.in_base.col(reading) - face.mean;
      scatter += off * off.transpose();
    }
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(scatter, Eigen::ComputeFullU);
  if (!(std::sqrt(svd.singularValues()(1)) > thinnest * std::sqrt(svd.singularValues()(0)))) {
    return std::nullopt;
  }
  return svd.matrixU().col(2);
}

// σ₂ − σ₁, or nothing where nobody says which way the faces look.
std::optional<int> looks(const Artefact& artefact, const CertifiedDistance& length) {
  const CertifiedFeature& a = artefact.features[length.first];
  const CertifiedFeature& b = artefact.features[length.second];
  if (a.normal && b.normal && a.at && b.at) {
    const Eigen::Vector3d way = *b.at - *a.at;
    return (b.normal->dot(way) > 0.0 ? 1 : -1) - (a.normal->dot(way) > 0.0 ? 1 : -1);
  }
  return artefact.type == ArtefactType::GaugeBlock ? std::optional(2) : std::nullopt;
}

TestValue face_value(const Session& session, const Artefact& artefact, const CertifiedDistance& length,
                     const Face& first, const Face& second, const Eigen::Vector3d& normal, int sides) {
  std::vector<int> readings = first.readings;
  readings.insert(readings.end(), second.readings.begin(), second.readings.end());
  const double tip = session.recording.arm.probes[session.recording.readings[readings.front()].probe].radius;
  TestValue value;
  value.quantity = sides == 0 ? Quantity::LengthUni : Quantity::LengthBi;
  value.artefact = artefact.name;
  value.first = artefact.features[length.first].name;
  value.second = artefact.features[length.second].name;
  value.temperature = mean_temperature(session, readings);
  value.certified = length.value;
  value.measured = (std::abs(normal.dot(second.mean - first.mean)) - tip * sides) /
                   expansion_factor_or_one(artefact, value.temperature);
  value.value = value.measured - value.certified;
  value.budget.calibration = length.u;
  value.budget.alignment = session.specification.u_alignment;
  value.budget.fixture = session.specification.u_fixture;
  value.budget = with_thermal(value.budget, value.certified, thermal_state(session, artefact, value.temperature));
  value.place = place_of(0.5 * (first.mean + second.mean), session.recording, session.arm, readings);
  return value;
}

bool one_tip(const Session& session, const Faces& faces) {
  const auto radius = [&](int reading) {
    return session.recording.arm.probes[session.recording.readings[reading].probe].radius;
  };
  const double first = radius(faces.begin()->second.readings.front());
  for (const auto& [feature, face] : faces) {
    for (const int reading : face.readings) {
      if (radius(reading) != first) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

void add_face_tests(const Session& session, Verification& verification) {
  using Key = std::tuple<int, int, int>;
  std::map<Key, Faces> positions;
  for (const Touched& touched : touched_features(session, Orientations::Together)) {
    if (session.constraints.artefacts[touched.artefact].features[touched.feature].kind != FeatureKind::Plane) {
      continue;
    }
    Face face{Eigen::Vector3d::Zero(), touched.readings};
    for (const int reading : touched.readings) {
      face.mean += session.tips.in_base.col(reading) / static_cast<double>(touched.readings.size());
    }
    positions[{touched.artefact, touched.placement, touched.repeat}].emplace(touched.feature, face);
  }
  for (const auto& [key, faces] : positions) {
    const auto& [artefact_index, placement, repeat] = key;
    const Artefact& artefact = session.constraints.artefacts[artefact_index];
    const std::string& place = session.recording.placements.name(placement);
    const auto tell = [&](const char* why) {
      verification.missing.push_back(
          fmt::format("artefact {}, placement {}: {}", in_quotes(artefact.name), in_quotes(place), why));
    };
    const auto normal = common_normal(session, faces);
    if (!normal || !one_tip(session, faces)) {
      tell(normal ? "the faces were touched with tips of several radii"
                  : "the readings of each face lie on one line, so that its direction is not told");
      continue;
    }
    for (const CertifiedDistance& length : artefact.distances) {
      const auto first = faces.find(length.first);
      const auto second = faces.find(length.second);
      if (first == faces.end() || second == faces.end()) {
        continue;
      }
      const auto sides = looks(artefact, length);
      if (!sides) {
        tell(
            "the certificate does not say which way the faces look (`normal` and `at`), so that the tip cannot be "
            "taken off");
        break;
      }
      TestValue value = face_value(session, artefact, length, first->second, second->second, *normal, *sides);
      value.placement = place;
      value.repeat = session.recording.repeats.name(repeat);
      judge(value, session.specification);
      verification.values.push_back(std::move(value));
    }
  }
}

}  // namespace artcal
