#include "app/stream/touch_check.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "app/stream/tip_check.h"
#include "core/text/in_quotes.h"
#include "fitting/fit.h"

namespace artcal {
namespace {

constexpr Eigen::Index touches_of_ball = 4;  // before a deviation from it is told
constexpr Eigen::Index touches_of_plane = 3;
constexpr Eigen::Index touches_of_length = 5;  // of each end, when certified distances are compared

bool is_same_feature(const Touch& a, const Touch& b) {
  return a.feature == b.feature && a.placement == b.placement && a.artefact == b.artefact;
}

FitOptions options_of(const CertifiedFeature& feature, double tip_radius) {
  FitOptions options;
  options.fixed_radius = feature.radius;
  options.tip_radius = tip_radius;
  return options;
}

}  // namespace

const CertifiedFeature* TouchCheck::feature_of(const Touch& touch) const {
  for (const Artefact& artefact : artefacts_) {
    for (const CertifiedFeature& feature : artefact.features) {
      if (artefact.name == touch.artefact && feature.name == touch.feature) {
        return &feature;
      }
    }
  }
  return nullptr;
}

Eigen::Matrix3Xd TouchCheck::tips_of(const Touch& touch, bool with_last) const {
  Eigen::Matrix3Xd tips(3, static_cast<Eigen::Index>(touches_.size()));
  Eigen::Index count = 0;
  for (const Touch& other : touches_) {
    if (is_same_feature(other, touch) && other.probe == touch.probe && (with_last || &other != &touches_.back())) {
      tips.col(count++) = other.tip_in_base;
    }
  }
  return tips.leftCols(count);
}

std::optional<double> TouchCheck::deviation_of_last() const {
  if (touches_.empty()) {
    return std::nullopt;
  }
  const Touch& last = touches_.back();
  const CertifiedFeature* feature = feature_of(last);
  const Eigen::Matrix3Xd before = tips_of(last, false);
  if (feature == nullptr || before.cols() == 0) {
    return std::nullopt;
  }
  const double tip_radius = arm_.probes[static_cast<std::size_t>(last.probe)].radius;
  switch (feature->kind) {
    case FeatureKind::Point: return (last.tip_in_base - before.rowwise().mean()).norm();
    case FeatureKind::Sphere:
      if (before.cols() >= touches_of_ball) {
        if (const auto ball = fit<Sphere>(before, options_of(*feature, tip_radius))) {
          return (last.tip_in_base - ball->feature.centre).norm() - ball->feature.radius - tip_radius;
        }
      }
      return std::nullopt;
    case FeatureKind::Plane:
      if (before.cols() >= touches_of_plane) {
        if (const auto plane = fit<Plane>(before)) {
          return signed_distance(plane->feature, last.tip_in_base);
        }
      }
      return std::nullopt;
    case FeatureKind::Anchor:
    case FeatureKind::Coordinates: return std::nullopt;
  }
  return std::nullopt;
}

std::optional<Eigen::Vector3d> TouchCheck::centre_of(const Touch& touch) const {
  const CertifiedFeature* feature = feature_of(touch);
  const Eigen::Matrix3Xd tips = tips_of(touch, true);
  if (feature == nullptr || tips.cols() == 0) {
    return std::nullopt;
  }
  if (feature->kind == FeatureKind::Point) {
    return Eigen::Vector3d(tips.rowwise().mean());
  }
  if (feature->kind != FeatureKind::Sphere || tips.cols() < touches_of_length) {
    return std::nullopt;
  }
  const auto ball = fit<Sphere>(tips, options_of(*feature, arm_.probes[static_cast<std::size_t>(touch.probe)].radius));
  return ball ? std::optional(ball->feature.centre) : std::nullopt;
}

void TouchCheck::compare_distances(Said& said) const {
  const Touch& last = touches_.back();
  const auto artefact =
      std::find_if(artefacts_.begin(), artefacts_.end(), [&](const Artefact& a) { return a.name == last.artefact; });
  const auto centre = centre_of(last);
  if (artefact == artefacts_.end() || !centre) {
    return;
  }
  const int index = artefact->feature_index(last.feature);
  for (const CertifiedDistance& distance : artefact->distances) {
    if (distance.first != index && distance.second != index) {
      continue;
    }
    Touch end = last;
    end.feature =
        artefact->features[static_cast<std::size_t>(distance.first == index ? distance.second : distance.first)].name;
    const auto other = centre_of(end);
    if (!other) {
      continue;
    }
    const double read = (*centre - *other).norm();
    const std::string text = fmt::format("{} to {} is {:.3f} mm by the arm's file, certified {:.3f} mm", end.feature,
                                         last.feature, read, distance.value);
    said.note += "; " + text;
    // A few touches of a nominal arm may find the centre of a ball wrong by as much as its radius.
    const double ball = feature_of(last)->radius.value_or(0.0);
    if (std::abs(read - distance.value) > max_deviation * reach(arm_) + 3.0 * ball) {
      said.warning = text + "; is it another feature, or did the artefact move?";
    }
  }
}

TouchCheck::Said TouchCheck::add(const Touch& touch) {
  touches_.push_back(touch);
  Said said;
  const auto deviation = deviation_of_last();
  if (deviation) {
    // Of a point it is a distance, of a ball or a plane it has a sign.
    const CertifiedFeature* of = feature_of(touch);
    const bool is_signed = of == nullptr || of->kind != FeatureKind::Point;
    said.note = (is_signed ? fmt::format("{:+.3f}", *deviation) : fmt::format("{:.3f}", *deviation)) +
                " mm from the earlier touches";
    if (std::abs(*deviation) > max_deviation * reach(arm_)) {
      said.warning = fmt::format(
          "this touch is {} mm from where the earlier ones have {}; is it another feature, or "
          "did the artefact move? Undo it if so",
          is_signed ? fmt::format("{:+.1f}", *deviation) : fmt::format("{:.1f}", *deviation), in_quotes(touch.feature));
    }
  }
  const CertifiedFeature* feature = feature_of(touch);
  const Eigen::Index touches = tips_of(touch, true).cols();
  if (feature != nullptr && touches == (feature->kind == FeatureKind::Point ? 1 : touches_of_length)) {
    compare_distances(said);
  }
  return said;
}

}  // namespace artcal
