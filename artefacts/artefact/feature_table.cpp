#include "artefacts/artefact/feature_table.h"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "artefacts/artefact/length_values.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::array kinds{std::pair{"point", FeatureKind::Point}, std::pair{"sphere", FeatureKind::Sphere},
                           std::pair{"plane", FeatureKind::Plane}, std::pair{"anchor", FeatureKind::Anchor},
                           std::pair{"coordinates", FeatureKind::Coordinates}};

FeatureKind read_kind(TomlTable& table) {
  const std::string kind = table.text("kind");
  for (const auto& [name, value] : kinds) {
    if (kind == name) {
      return value;
    }
  }
  table.fail("kind", fmt::format("the feature's kind is {}, expected \"point\", \"sphere\", \"plane\", \"anchor\" or "
                                 "\"coordinates\"",
                                 in_quotes(kind)));
  return FeatureKind::Point;
}

Eigen::Vector3d read_vector(TomlTable& table, std::string_view key) {
  const auto numbers = table.numbers(key);
  if (numbers.size() != 3) {
    table.fail(key, fmt::format("`{}` holds {} numbers, expected x, y and z", key, numbers.size()));
    return Eigen::Vector3d::Zero();
  }
  return Eigen::Vector3d::Map(numbers.data());
}

void read_place(TomlTable& table, const ArtefactValues& values, const TemperatureConversion& conversion,
                CertifiedFeature& feature) {
  if (!table.has("at")) {
    if (table.has("U_at")) {
      table.fail("U_at", "this is the uncertainty of certified coordinates, but the feature has no `at`");
    }
    return;
  }
  if (feature.kind == FeatureKind::Coordinates) {
    table.fail("at",
               "a feature of the kind \"coordinates\" gets its place from each reading (ref_x, ref_y, ref_z), so "
               "it has no `at` of its own");
  }
  const LengthValues at = read_lengths(table, "at", values);
  if (at.values.size() != 3) {
    table.fail("at", fmt::format("`at` holds {} numbers, expected x, y and z", at.values.size()));
    return;
  }
  feature.at = conversion.factor * Eigen::Vector3d::Map(at.values.data());
  const double length = feature.at->norm();
  if (!(length <= largest_length)) {
    table.fail("at", fmt::format("the point is {:.6g} mm from the origin; is it in the wrong unit?", length));
    return;
  }
  if (const auto u = read_uncertainty(table, values, "U_at", "k_at", values.at_rule, length, at.largest_certified())) {
    feature.u_at = std::hypot(*u, conversion.relative_u * length);
  }
}

void read_normal(TomlTable& table, CertifiedFeature& feature) {
  if (table.has("normal")) {
    const Eigen::Vector3d direction = read_vector(table, "normal");
    if (!(direction.norm() > 1e-6)) {
      table.fail("normal", "the normal has no direction, expected one such as [0, 0, 1], out of the material");
      return;
    }
    feature.normal = direction.normalized();
  }
  if (feature.at.has_value() != feature.normal.has_value()) {
    table.fail(feature.at ? "at" : "normal",
               "a plane whose place is certified has `at`, one of its points, and `normal`; state both, or neither");
  }
}

void read_diameter(TomlTable& table, const ArtefactValues& values, const TemperatureConversion& conversion,
                   CertifiedFeature& feature) {
  if (table.is_text("diameter")) {
    if (const std::string text = table.text("diameter"); text != "unknown") {
      table.fail("diameter",
                 fmt::format("`diameter` is {}, expected a number, or \"unknown\" for a ball whose size is to "
                             "be found",
                             in_quotes(text)));
    } else if (table.has("U_diameter")) {
      table.fail("U_diameter", "a diameter that is unknown has no uncertainty");
    }
    return;
  }
  const LengthValues stated = read_length(table, "diameter", values);
  const double diameter = stated.values.front() * conversion.factor;
  if (diameter <= 0.0 || !(diameter <= largest_length)) {
    table.fail("diameter", diameter <= 0.0 ? "the diameter of a sphere is not above zero"
                                           : fmt::format("a ball of {:.6g} mm; is it in the wrong unit?", diameter));
    return;
  }
  feature.radius = 0.5 * diameter;
  if (const auto u = read_uncertainty(table, values, "U_diameter", "k_diameter", values.diameter_rule, diameter,
                                      stated.certified_of(0))) {
    feature.u_radius = 0.5 * std::hypot(*u, conversion.relative_u * diameter);
    if (*u > 0.05 * diameter) {
      table.fail("U_diameter",
                 fmt::format("a standard uncertainty of {} mm is much for a diameter of {} mm; is it in the "
                             "wrong unit?",
                             *u, diameter));
    }
  }
}

void read_feature_form(TomlTable& table, const ArtefactValues& values, CertifiedFeature& feature) {
  if (!table.has("form")) {
    if (table.has("U_form")) {
      table.fail("U_form", "this is the uncertainty of a form deviation, but the feature has no `form`");
    }
    return;
  }
  const LengthValues stated = read_length(table, "form", values);
  feature.form = stated.values.front();
  if (*feature.form < 0.0) {
    table.fail("form", "a form deviation is a range of residuals and not below zero");
  }
  feature.u_form =
      read_uncertainty(table, values, "U_form", "k_form", std::nullopt, *feature.form, stated.certified_of(0))
          .value_or(0.0);
}

}  // namespace

CertifiedFeature read_feature(TomlTable& table, const ArtefactValues& values) {
  CertifiedFeature feature;
  feature.name = table.name("name");
  if (feature.name.empty()) {
    table.fail("name", "the feature's name is empty; readings find it by its name");
  }
  feature.kind = read_kind(table);
  const TemperatureConversion conversion = read_conversion(table, values);
  read_place(table, values, conversion, feature);
  if (feature.kind == FeatureKind::Sphere) {
    read_diameter(table, values, conversion, feature);
  }
  if (feature.kind == FeatureKind::Plane) {
    read_normal(table, feature);
  }
  if (feature.kind == FeatureKind::Sphere || feature.kind == FeatureKind::Plane) {
    read_feature_form(table, values, feature);
  }
  if (table.has("U") && (feature.kind == FeatureKind::Anchor || feature.kind == FeatureKind::Coordinates)) {
    feature.u = read_standard_uncertainty(table, values, "U");
  }
  return feature;
}

}  // namespace artcal
