#include "artefacts/simulation/true_artefact.h"

#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>
#include <Eigen/Dense>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr double not_placed = std::numeric_limits<double>::quiet_NaN();

double drawn(double value, double u, RandomStream* errors) {
  return errors != nullptr && u > 0.0 ? value + u * errors->normal() : value;
}

/// Features along a line, found from distances; NaN where none leads.
class Line {
 public:
  Line(const Artefact& artefact, int root)
      : artefact_(artefact),
        x_(Eigen::VectorXd::Constant(static_cast<Eigen::Index>(artefact.features.size()), not_placed)) {
    x_[root] = 0.0;
    while (place_next()) {
    }
  }

  [[nodiscard]] bool has(int feature) const { return !std::isnan(x_[feature]); }

  // Moves all but the root so that `lengths` (one a distance, weighted by their u) are met as well as they can be.
  [[nodiscard]] Eigen::VectorXd adjusted(int root, const std::vector<double>& lengths) const {
    const auto rows = static_cast<Eigen::Index>(lengths.size());
    Eigen::MatrixXd signs = Eigen::MatrixXd::Zero(rows + 1, x_.size());
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero(rows + 1);
    signs(rows, root) = 1.0;
    for (Eigen::Index i = 0; i < rows; ++i) {
      const CertifiedDistance& distance = artefact_.distances[i];
      if (has(distance.first)) {
        const double sign = x_[distance.second] > x_[distance.first] ? 1.0 : -1.0;
        signs(i, distance.second) = sign / distance.u;
        signs(i, distance.first) = -sign / distance.u;
        wanted[i] = lengths[i] / distance.u;
      }
    }
    return signs.completeOrthogonalDecomposition().solve(wanted);
  }

 private:
  [[nodiscard]] double misfit(int feature, double x) const {
    double sum = 0.0;
    for (const CertifiedDistance& distance : artefact_.distances) {
      const int other = distance.first == feature ? distance.second : distance.first;
      if ((distance.first == feature || distance.second == feature) && has(other)) {
        sum += std::abs(std::abs(x_[other] - x) - distance.value);
      }
    }
    return sum;
  }

  bool place_next() {
    for (const CertifiedDistance& distance : artefact_.distances) {
      if (has(distance.first) != has(distance.second)) {
        const int known = has(distance.first) ? distance.first : distance.second;
        const int next = known == distance.first ? distance.second : distance.first;
        const double ahead = x_[known] + distance.value;
        const double behind = x_[known] - distance.value;
        x_[next] = misfit(next, behind) < misfit(next, ahead) ? behind : ahead;
        return true;
      }
    }
    return false;
  }

  const Artefact& artefact_;
  Eigen::VectorXd x_;
};

bool wants_place(const CertifiedFeature& feature) { return feature.kind != FeatureKind::Coordinates; }

Expected<void> place_on_line(const Artefact& artefact, std::vector<std::optional<Eigen::Vector3d>>& places,
                             RandomStream* errors) {
  std::vector<int> unplaced;
  for (int f = 0; f < static_cast<int>(places.size()); ++f) {
    if (!places[f] && wants_place(artefact.features[f])) {
      unplaced.push_back(f);
    }
  }
  if (unplaced.empty()) {
    return {};
  }
  const Line line(artefact, unplaced.front());
  std::vector<double> lengths;
  for (const CertifiedDistance& distance : artefact.distances) {
    lengths.push_back(drawn(distance.value, distance.u, errors));
  }
  const Eigen::VectorXd x = line.adjusted(unplaced.front(), lengths);
  for (const int f : unplaced) {
    const bool plane_in_a_row = artefact.features[f].kind == FeatureKind::Plane && unplaced.size() > 1;
    if (!line.has(f) || plane_in_a_row) {
      return bad_input(
          fmt::format("nothing says where the feature {} of the artefact {} is beside {}; state its place "
                      "in a table headed [[true_feature]]",
                      in_quotes(artefact.features[f].name), in_quotes(artefact.name),
                      in_quotes(artefact.features[unplaced.front()].name)));
    }
    places[f] = Eigen::Vector3d(x[f], 0.0, 0.0);
  }
  return {};
}

// The distance between two real features, as a certificate means it.
double real_distance(const RealArtefact& real, const Artefact& artefact, const CertifiedDistance& distance) {
  const RealFeature& first = real.features[distance.first];
  const RealFeature& second = real.features[distance.second];
  const bool planes = artefact.features[distance.first].kind == FeatureKind::Plane;
  return planes ? std::abs(first.normal.dot(second.at - first.at)) : (second.at - first.at).norm();
}

Expected<void> check_distances(const RealArtefact& real, const Artefact& artefact) {
  for (const CertifiedDistance& distance : artefact.distances) {
    const double found = real_distance(real, artefact, distance);
    const double off = std::abs(found - distance.value);
    if (!(off <= 4.0 * distance.u)) {
      return bad_input(fmt::format(
          "the certified distance between {} and {} of the artefact {} is {} mm, but they would be {} mm apart; "
          "features without a place are taken to lie on one line, and others are stated in [[true_feature]]",
          in_quotes(artefact.features[distance.first].name), in_quotes(artefact.features[distance.second].name),
          in_quotes(artefact.name), distance.value, found));
    }
  }
  return {};
}

}  // namespace

Expected<RealArtefact> real_artefact(const PlannedArtefact& planned, RandomStream* errors) {
  const Artefact& artefact = planned.certified;
  if (errors != nullptr) {
    // What is certified must make sense before anything is drawn around it.
    if (auto certified = real_artefact(planned, nullptr); !certified) {
      return certified;
    }
  }
  RealArtefact real;
  real.expansion = drawn(artefact.expansion, artefact.u_expansion, errors);
  std::vector<std::optional<Eigen::Vector3d>> places;
  for (std::size_t f = 0; f < artefact.features.size(); ++f) {
    const CertifiedFeature& certified = artefact.features[f];
    const TrueFeature& stated = planned.stated[f];
    RealFeature& feature = real.features.emplace_back();
    feature.normal = stated.normal.value_or(certified.normal.value_or(feature.normal));
    std::optional<Eigen::Vector3d> at = stated.at;
    if (!at && certified.at) {
      at = *certified.at;
      for (double& coordinate : *at) {
        coordinate = drawn(coordinate, certified.u_at, errors);
      }
    }
    places.push_back(at);
    if (certified.kind == FeatureKind::Sphere) {
      if (!stated.radius && !certified.radius) {
        return bad_input(
            fmt::format("nobody states the diameter of the ball {} of the artefact {}; state `diameter` in "
                        "a table headed [[true_feature]]",
                        in_quotes(certified.name), in_quotes(artefact.name)));
      }
      feature.radius = stated.radius ? *stated.radius : drawn(*certified.radius, certified.u_radius, errors);
    }
  }
  if (auto placed = place_on_line(artefact, places, errors); !placed) {
    return tl::unexpected(placed.error());
  }
  for (std::size_t f = 0; f < places.size(); ++f) {
    real.features[f].at = places[f].value_or(Eigen::Vector3d::Zero());
  }
  if (errors == nullptr) {
    if (auto checked = check_distances(real, artefact); !checked) {
      return tl::unexpected(checked.error());
    }
  }
  return real;
}

}  // namespace artcal
