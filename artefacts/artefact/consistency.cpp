#include "artefacts/artefact/consistency.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "artefacts/artefact/artefact_type.h"
#include "artefacts/artefact/parallel.h"
#include "core/statistics.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr double chance_of_one_set = 0.18;  // that a sound certificate is refused: that of four comparisons with k = 2
constexpr double least_coverage_factor = 2.0;

// Among many comparisons one is off by more than 2 u by chance: the coverage factor grows with their number.
double coverage_factor(std::size_t comparisons) {
  const auto count = static_cast<double>(std::max<std::size_t>(comparisons, 1));
  return std::max(least_coverage_factor, std::sqrt(chi_squared_quantile(1.0 - chance_of_one_set / count, 1.0)));
}

Contradiction at_feature(int index, std::string message) {
  return {Contradiction::Of::Feature, index, std::move(message)};
}
Contradiction at_distance(std::size_t index, std::string message) {
  return {Contradiction::Of::Distance, static_cast<int>(index), std::move(message)};
}

std::string both(const CertifiedFeature& a, const CertifiedFeature& b) {
  return fmt::format("{} and {}", in_quotes(a.name), in_quotes(b.name));
}

std::string both(const Artefact& artefact, const CertifiedDistance& distance) {
  return both(artefact.features[distance.first], artefact.features[distance.second]);
}

// Between two points, or two parallel planes. REQUIRES: certified coordinates of both.
double distance_between(const CertifiedFeature& a, const CertifiedFeature& b) {
  const Eigen::Vector3d step = *b.at - *a.at;
  return a.kind == FeatureKind::Plane ? std::abs(a.normal->dot(step)) : step.norm();
}

// Two features at the same place, or two balls in one another. REQUIRES: certified coordinates of both.
std::optional<std::string> collision(const CertifiedFeature& a, const CertifiedFeature& b) {
  const bool planes = a.kind == FeatureKind::Plane;
  if (planes != (b.kind == FeatureKind::Plane) || (planes && !are_parallel(*a.normal, *b.normal))) {
    return std::nullopt;
  }
  const double distance = distance_between(a, b);
  const double U = least_coverage_factor * std::hypot(a.u_at, b.u_at);
  if (distance <= U) {
    return fmt::format("the features {} are in the same place; one of them is there twice", both(a, b));
  }
  if (a.radius && b.radius && distance + U < *a.radius + *b.radius) {
    return fmt::format("the balls {} overlap: their centres are {:.6g} mm apart, their radii together are {:.6g} mm",
                       both(a, b), distance, *a.radius + *b.radius);
  }
  return std::nullopt;
}

std::optional<Contradiction> find_collision(const Artefact& artefact) {
  const auto& features = artefact.features;
  for (std::size_t i = 0; i < features.size(); ++i) {
    for (std::size_t j = 0; j < i && features[i].at; ++j) {
      if (!features[j].at) {
        continue;
      }
      if (auto message = collision(features[j], features[i])) {
        return at_feature(static_cast<int>(i), std::move(*message));
      }
    }
  }
  return std::nullopt;
}

std::optional<std::string> contradiction_of_ends(const Artefact& artefact, const CertifiedDistance& distance) {
  const CertifiedFeature& a = artefact.features[distance.first];
  const CertifiedFeature& b = artefact.features[distance.second];
  if (a.radius && b.radius && distance.value + least_coverage_factor * distance.u < *a.radius + *b.radius) {
    return fmt::format("the balls {} overlap: the certified distance is {} mm, their radii together are {} mm",
                       both(a, b), distance.value, *a.radius + *b.radius);
  }
  if (!a.at || !b.at) {
    return std::nullopt;
  }
  if (a.kind == FeatureKind::Plane && !are_parallel(*a.normal, *b.normal)) {
    return fmt::format("the planes {} are not parallel, so there is no one distance between them", both(a, b));
  }
  const double between = distance_between(a, b);
  const double u = std::hypot(distance.u, a.u_at, b.u_at);
  if (std::abs(between - distance.value) > coverage_factor(artefact.distances.size()) * u) {
    return fmt::format(
        "the certified distance between {} is {} mm, but their certified coordinates are {} mm apart, "
        "which is more than its U away",
        both(a, b), distance.value, between);
  }
  return std::nullopt;
}

/// Distances as a graph: from each feature to others.
using Graph = std::vector<std::vector<int>>;

// The shortest way between the ends of a distance that is shorter than it: length and variance.
std::pair<double, double> way_round(const Artefact& artefact, const Graph& graph, const CertifiedDistance& distance) {
  using Stop = std::pair<double, int>;
  const double far = std::numeric_limits<double>::infinity();
  std::vector<double> length(artefact.features.size(), far);
  std::vector<double> variance(artefact.features.size(), 0.0);
  std::priority_queue<Stop, std::vector<Stop>, std::greater<>> next;
  length[distance.first] = 0.0;
  next.emplace(0.0, distance.first);
  while (!next.empty()) {
    const auto [so_far, feature] = next.top();
    next.pop();
    if (feature == distance.second) {
      break;
    }
    if (so_far > length[feature]) {
      continue;
    }
    for (const int i : graph[feature]) {
      const CertifiedDistance& step = artefact.distances[i];
      const int to = step.first == feature ? step.second : step.first;
      const double longer = so_far + step.value;
      if (longer < length[to] && longer < distance.value) {
        length[to] = longer;
        variance[to] = variance[feature] + step.u * step.u;
        next.emplace(longer, to);
      }
    }
  }
  return {length[distance.second], variance[distance.second]};
}

std::optional<Contradiction> find_impossible_distance(const Artefact& artefact) {
  Graph graph(artefact.features.size());
  std::set<std::pair<int, int>> stated;
  for (std::size_t i = 0; i < artefact.distances.size(); ++i) {
    const CertifiedDistance& distance = artefact.distances[i];
    if (!stated.insert(std::minmax(distance.first, distance.second)).second) {
      return Contradiction{Contradiction::Of::Ends, static_cast<int>(i),
                           fmt::format("the distance between {} is stated twice", both(artefact, distance))};
    }
    graph[distance.first].push_back(static_cast<int>(i));
    graph[distance.second].push_back(static_cast<int>(i));
  }
  const double factor = coverage_factor(artefact.distances.size());
  for (std::size_t i = 0; i < artefact.distances.size(); ++i) {
    const CertifiedDistance& distance = artefact.distances[i];
    const auto [way, variance] = way_round(artefact, graph, distance);
    if (distance.value > way + factor * std::sqrt(variance + distance.u * distance.u)) {
      return at_distance(
          i, fmt::format("the certified distance between {} is {} mm, but the other distances lead from one "
                         "to the other in {} mm",
                         both(artefact, distance), distance.value, way));
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Contradiction> find_contradiction(const Artefact& artefact) {
  if (auto found = contradiction_of_type(artefact)) {
    return at_feature(found->feature, std::move(found->message));
  }
  if (auto found = find_collision(artefact)) {
    return found;
  }
  for (std::size_t i = 0; i < artefact.distances.size(); ++i) {
    if (auto message = contradiction_of_ends(artefact, artefact.distances[i])) {
      return at_distance(i, std::move(*message));
    }
  }
  return find_impossible_distance(artefact);
}

}  // namespace artcal
