#include "artefacts/verification/iso10360_12/length_tests.h"

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "artefacts/verification/iso10360_12/length_value.h"
#include "artefacts/verification/measured.h"

namespace artcal {
namespace {

struct End {
  MeasuredPoint point;
  std::vector<int> readings;
};
using Ends = std::map<int, End>;  // by feature

bool is_point_or_ball(const CertifiedFeature& feature) {
  return feature.kind == FeatureKind::Sphere || feature.kind == FeatureKind::Point;
}

TestValue ball_length(const Session& session, const Artefact& artefact, const CertifiedDistance& certified,
                      const End& first, const End& second) {
  const Eigen::Vector3d& from = first.point.centre_in_base;
  const Eigen::Vector3d& to = second.point.centre_in_base;
  MeasuredLength measured{first.readings, (from - to).norm(), 0.5 * (from + to)};
  measured.readings.insert(measured.readings.end(), second.readings.begin(), second.readings.end());
  TestValue value = length_value(session, artefact, certified, measured);
  const Eigen::Vector3d along = (to - from).normalized();
  for (const auto& [end, name] : {std::pair{&first, &value.first}, std::pair{&second, &value.second}}) {
    const double dilution = dilution_along(end->point, along);
    value.dilution.add(end->point.kind, dilution, end->point.kind == PointKind::Seat ? 0.0 : dilution, *name);
  }
  return value;
}

}  // namespace

std::vector<CertifiedDistance> certified_lengths(const Artefact& artefact) {
  std::vector<CertifiedDistance> lengths;
  for (const CertifiedDistance& distance : artefact.distances) {
    if (is_point_or_ball(artefact.features[distance.first]) && is_point_or_ball(artefact.features[distance.second])) {
      lengths.push_back(distance);
    }
  }
  if (!lengths.empty()) {
    return lengths;
  }
  for (std::size_t i = 0; i < artefact.features.size(); ++i) {
    for (std::size_t j = i + 1; j < artefact.features.size(); ++j) {
      const CertifiedFeature& a = artefact.features[i];
      const CertifiedFeature& b = artefact.features[j];
      if (a.at && b.at && is_point_or_ball(a) && is_point_or_ball(b)) {
        lengths.push_back(
            {static_cast<int>(i), static_cast<int>(j), (*a.at - *b.at).norm(), std::hypot(a.u_at, b.u_at)});
      }
    }
  }
  return lengths;
}

void add_length_tests(const Session& session, Quantity quantity, Verification& verification) {
  std::map<std::tuple<int, int, int>, Ends> positions;
  std::vector<std::tuple<int, int, int>> order;
  for (const Touched& touched : touched_features(session, Orientations::Together)) {
    const Artefact& artefact = session.constraints.artefacts[touched.artefact];
    if (artefact.features.size() < 2 || !is_point_or_ball(artefact.features[touched.feature])) {
      continue;
    }
    const auto measured = measure(session, touched);
    if (!measured) {
      verification.missing.push_back(measured.error().text());
      continue;
    }
    if (measured->kind != PointKind::Seat) {
      verification.scatter(measured->kind).add(measured->squares, measured->degrees_of_freedom);
    }
    const std::tuple key{touched.artefact, touched.placement, touched.repeat};
    if (!positions.contains(key)) {
      order.push_back(key);
    }
    positions[key].emplace(touched.feature, End{*measured, touched.readings});
  }
  for (const auto& key : order) {
    const auto& [artefact_index, placement, repeat] = key;
    const Ends& ends = positions[key];
    const Artefact& artefact = session.constraints.artefacts[artefact_index];
    for (const CertifiedDistance& length : certified_lengths(artefact)) {
      const auto first = ends.find(length.first);
      const auto second = ends.find(length.second);
      if (first == ends.end() || second == ends.end()) {
        continue;
      }
      TestValue value = ball_length(session, artefact, length, first->second, second->second);
      value.quantity = quantity;
      value.placement = session.recording.placements.name(placement);
      value.repeat = session.recording.repeats.name(repeat);
      judge(value, session.specification);
      verification.values.push_back(std::move(value));
    }
  }
}

}  // namespace artcal
