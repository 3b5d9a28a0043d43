#include "artefacts/verification/iso10360_12/face_tests.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "artefacts/verification/iso10360_12/face_axis.h"
#include "artefacts/verification/iso10360_12/length_value.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

Eigen::Vector3d mean_of(const Session& session, const std::vector<int>& readings) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int reading : readings) {
    sum += session.tips.in_base.col(reading);
  }
  return sum / static_cast<double>(readings.size());
}

double tip_radius(const Session& session, int reading) {
  return artcal::tip_radius(session.recording, reading, session.arm);
}

bool one_tip(const Session& session, const std::vector<int>& readings) {
  return std::all_of(readings.begin(), readings.end(), [&](int reading) {
    return tip_radius(session, reading) == tip_radius(session, readings.front());
  });
}

// σ₂ − σ₁, or nothing where nobody says which way the faces look.
std::optional<int> looks(const Artefact& artefact, const CertifiedDistance& length) {
  const CertifiedFeature& a = artefact.features[static_cast<std::size_t>(length.first)];
  const CertifiedFeature& b = artefact.features[static_cast<std::size_t>(length.second)];
  if (a.normal && b.normal && a.at && b.at) {
    const Eigen::Vector3d way = *b.at - *a.at;
    return (b.normal->dot(way) > 0.0 ? 1 : -1) - (a.normal->dot(way) > 0.0 ? 1 : -1);
  }
  return artefact.type == ArtefactType::GaugeBlock ? std::optional(2) : std::nullopt;
}

std::vector<CertifiedDistance> face_lengths(const Artefact& artefact) {
  if (!artefact.distances.empty()) {
    return artefact.distances;
  }
  std::vector<CertifiedDistance> lengths;
  for (int i = 0; i < static_cast<int>(artefact.features.size()); ++i) {
    for (int j = i + 1; j < static_cast<int>(artefact.features.size()); ++j) {
      const CertifiedFeature& a = artefact.features[static_cast<std::size_t>(i)];
      const CertifiedFeature& b = artefact.features[static_cast<std::size_t>(j)];
      if (is_measuring_face(artefact, i) && is_measuring_face(artefact, j) && a.at && b.at) {
        lengths.push_back({i, j, std::abs(a.normal->dot(*b.at - *a.at)), std::hypot(a.u_at, b.u_at)});
      }
    }
  }
  return lengths;
}

TestValue face_value(const Session& session, const Artefact& artefact, const CertifiedDistance& length,
                     const std::vector<int>& first, const std::vector<int>& second, const FaceAxis& axis, int sides) {
  const Eigen::Vector3d from = mean_of(session, first);
  const Eigen::Vector3d way = mean_of(session, second) - from;
  const double along = std::abs(axis.in_base.dot(way));
  MeasuredLength measured{first, along - tip_radius(session, first.front()) * sides, from + 0.5 * way};
  measured.readings.insert(measured.readings.end(), second.begin(), second.end());
  TestValue value = length_value(session, artefact, length, measured);
  value.quantity = sides == 0 ? Quantity::LengthUni : Quantity::LengthBi;
  for (const auto& [name, readings] : {std::pair{&value.first, &first}, std::pair{&value.second, &second}}) {
    value.dilution.add(PointKind::Face, 1.0 / std::sqrt(static_cast<double>(readings->size())), 0.0, *name);
  }
  const double across = (way - axis.in_base.dot(way) * axis.in_base).norm();
  const double by_axis = std::hypot(across * axis.u, 0.5 * along * axis.u * axis.u);
  value.budget.alignment = std::hypot(value.budget.alignment, by_axis);
  return value;
}

/// The planes of one artefact in one placement.
class PlacedFaces {
 public:
  PlacedFaces(const Session& session, int artefact, int placement, const PlaneReadings& planes,
              Verification& verification)
      : session_(session),
        artefact_(session.constraints.artefacts[static_cast<std::size_t>(artefact)]),
        place_(session.recording.placements.name(placement)),
        planes_(planes),
        verification_(verification) {}

  void add_repeat(int repeat) {
    const auto axis = face_axis(session_, artefact_, planes_, repeat);
    for (const CertifiedDistance& length : face_lengths(artefact_)) {
      const auto* first = readings_of(length.first, repeat);
      const auto* second = readings_of(length.second, repeat);
      if (first == nullptr || second == nullptr) {
        continue;
      }
      const auto sides = looks(artefact_, length);
      if (!axis || !sides) {
        tell(!axis ? axis.error().message
                   : "the certificate does not say which way the faces look (`normal` and `at`), so that the tip "
                     "cannot be taken off");
        return;
      }
      std::vector<int> both = *first;
      both.insert(both.end(), second->begin(), second->end());
      if (!one_tip(session_, both)) {
        tell("the faces were touched with tips of several radii");
        return;
      }
      TestValue value = face_value(session_, artefact_, length, *first, *second, *axis, *sides);
      value.placement = place_;
      value.repeat = session_.recording.repeats.name(repeat);
      judge(value, session_.specification);
      verification_.values.push_back(std::move(value));
    }
  }

 private:
  [[nodiscard]] const std::vector<int>* readings_of(int feature, int repeat) const {
    const auto plane = planes_.find(feature);
    if (plane == planes_.end()) {
      return nullptr;
    }
    const auto found = plane->second.find(repeat);
    return found == plane->second.end() ? nullptr : &found->second;
  }
  void tell(const std::string& why) {
    verification_.missing.push_back(
        fmt::format("artefact {}, placement {}: {}", in_quotes(artefact_.name), in_quotes(place_), why));
  }

  const Session& session_;
  const Artefact& artefact_;
  const std::string& place_;
  const PlaneReadings& planes_;
  Verification& verification_;
};

}  // namespace

void add_face_tests(const Session& session, Verification& verification) {
  std::map<std::pair<int, int>, PlaneReadings> placed;
  for (const Touched& touched : touched_features(session, Orientations::Together)) {
    const Artefact& artefact = session.constraints.artefacts[static_cast<std::size_t>(touched.artefact)];
    if (artefact.features[static_cast<std::size_t>(touched.feature)].kind == FeatureKind::Plane) {
      placed[{touched.artefact, touched.placement}][touched.feature][touched.repeat] = touched.readings;
    }
  }
  for (const auto& [key, planes] : placed) {
    std::set<int> repeats;
    for (const auto& [feature, by_repeat] : planes) {
      for (const auto& [repeat, readings] : by_repeat) {
        repeats.insert(repeat);
      }
    }
    PlacedFaces faces(session, key.first, key.second, planes, verification);
    for (const int repeat : repeats) {
      faces.add_repeat(repeat);
    }
  }
}

}  // namespace artcal
