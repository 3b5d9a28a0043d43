#include "artefacts/artefact_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/in_quotes.h"
#include "core/text_file.h"
#include "core/toml_document.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

constexpr std::string_view schema = "artcal-artefact/1";

// U and k as a certificate states them, to u = U/k in mm.
double read_standard_uncertainty(TomlTable& table, double length) {
  const double expanded = table.number("U") * length;
  const double k = table.number("k");
  if (expanded <= 0.0 || k <= 0.0) {
    table.fail("U", "an uncertainty of zero or less is not one: state U and k as the certificate does");
    return 1.0;
  }
  return expanded / k;
}

FeatureKind read_kind(TomlTable& table) {
  const std::string kind = table.text("kind");
  if (kind == "sphere") return FeatureKind::Sphere;
  if (kind == "anchor") return FeatureKind::Anchor;
  if (kind == "coordinates") return FeatureKind::Coordinates;
  if (kind != "point") {
    table.fail("kind", fmt::format("the feature's kind is {}, expected \"point\", \"sphere\", \"anchor\" or "
                                   "\"coordinates\"",
                                   in_quotes(kind)));
  }
  return FeatureKind::Point;
}

CertifiedFeature read_feature(TomlTable table, double length) {
  CertifiedFeature feature;
  feature.name = table.name("name");
  if (feature.name.empty()) {
    table.fail("name", "the feature's name is empty; readings find it by its name");
  }
  feature.kind = read_kind(table);
  if (table.has("at")) {
    const auto at = table.numbers("at");
    if (at.size() != 3) {
      table.fail("at", fmt::format("`at` holds {} numbers, expected x, y and z", at.size()));
    } else {
      feature.at = length * Eigen::Vector3d::Map(at.data());
    }
  }
  if (feature.kind == FeatureKind::Sphere) {
    feature.radius = 0.5 * table.number("diameter") * length;
    if (*feature.radius <= 0.0) {
      table.fail("diameter", "the diameter of a sphere is not above zero");
    }
  }
  if (table.has("U") && (feature.kind == FeatureKind::Anchor || feature.kind == FeatureKind::Coordinates)) {
    feature.u = read_standard_uncertainty(table, length);
  }
  if (feature.kind == FeatureKind::Coordinates && feature.at) {
    table.fail("at",
               "a feature of the kind \"coordinates\" gets its place from each reading (ref_x, ref_y, ref_z), so "
               "it has no `at` of its own");
  }
  return feature;
}

CertifiedDistance read_distance(TomlTable table, const Artefact& artefact, double length) {
  CertifiedDistance distance;
  const auto names = table.texts("between");
  if (names.size() != 2 || names[0] == names[1]) {
    table.fail("between", "a distance lies between two features, such as between = [\"1\", \"2\"]");
    return distance;
  }
  for (const auto& name : names) {
    if (artefact.feature_index(name) < 0) {
      table.fail("between",
                 fmt::format("the distance names the feature {}, which the artefact does not have", in_quotes(name)));
      return distance;
    }
  }
  distance.first = artefact.feature_index(names[0]);
  distance.second = artefact.feature_index(names[1]);
  distance.value = table.number("value") * length;
  distance.u = read_standard_uncertainty(table, length);
  if (distance.value <= 0.0) {
    table.fail("value", "a certified distance is not above zero");
  }
  const CertifiedFeature& from = artefact.features[distance.first];
  const CertifiedFeature& to = artefact.features[distance.second];
  if (from.kind == FeatureKind::Coordinates || to.kind == FeatureKind::Coordinates) {
    table.fail("between", "a feature of the kind \"coordinates\" is no single point that a distance could end at");
  } else if (from.at.has_value() != to.at.has_value()) {
    // Half known, it would bind the pose to a free point; no certificate says such a thing.
    table.fail("between", fmt::format("of the features {} and {} only one has certified coordinates; state `at` for "
                                      "both, or for neither",
                                      in_quotes(names[0]), in_quotes(names[1])));
  } else if (from.at && std::abs((*from.at - *to.at).norm() - distance.value) > 2.0 * distance.u) {
    table.fail("value",
               fmt::format("the certified distance between {} and {} is {} mm, but their certified coordinates "
                           "are {} mm apart, which is more than its U away",
                           in_quotes(names[0]), in_quotes(names[1]), distance.value, (*from.at - *to.at).norm()));
  }
  for (const CertifiedDistance& other : artefact.distances) {
    if (std::minmax(other.first, other.second) == std::minmax(distance.first, distance.second)) {
      table.fail("between", fmt::format("the distance between {} and {} is stated twice", in_quotes(names[0]),
                                        in_quotes(names[1])));
    }
  }
  return distance;
}

void check_names(const Artefact& artefact, TomlTable& root) {
  if (artefact.features.empty()) {
    root.fail("feature", "the artefact has no feature, expected at least one table headed [[feature]]");
  }
  for (std::size_t i = 0; i < artefact.features.size(); ++i) {
    if (artefact.feature_index(artefact.features[i].name) != static_cast<int>(i)) {
      root.fail("feature", fmt::format("two features are called {}; give each its own name",
                                       in_quotes(artefact.features[i].name)));
    }
  }
}

Artefact read_artefact(TomlTable& root, const std::filesystem::path& path) {
  Artefact artefact;
  artefact.name = root.name_or("name", at_most(80, path.stem().string()));
  artefact.note = root.text_or("note", "");
  TomlTable units = root.table("units");
  const double length = length_unit(units, "length");
  const std::string frame = root.text_or("frame", "artefact");
  if (frame != "artefact" && frame != "base") {
    root.fail("frame", fmt::format("frame is {}, expected \"artefact\" (pose unknown) or \"base\" (the arm's)",
                                   in_quotes(frame)));
  }
  artefact.frame = frame == "base" ? CoordinateFrame::Base : CoordinateFrame::Artefact;
  artefact.expansion_is_known = root.has("expansion_per_K");
  artefact.expansion = root.number_or("expansion_per_K", 0.0);
  if (std::abs(artefact.expansion) > 1e-3) {
    root.fail("expansion_per_K",
              fmt::format("an expansion of {} per kelvin is no solid's; steel is 11.5e-6", artefact.expansion));
  }
  artefact.reference_temperature = root.number_or("reference_temperature_C", 20.0);
  for (auto& table : root.tables("feature")) {
    artefact.features.push_back(read_feature(table, length));
  }
  check_names(artefact, root);
  for (auto& table : root.tables("distance")) {
    artefact.distances.push_back(read_distance(table, artefact, length));
  }
  return artefact;
}

}  // namespace

Expected<ArtefactFile> read_artefact_file(const std::filesystem::path& path) {
  auto document = TomlDocument::read(path, schema);
  if (!document) {
    return tl::unexpected(document.error());
  }
  ArtefactFile result{read_artefact(document->root(), path), {path.string(), document->sha256()}};
  if (auto finished = document->finish(); !finished) {
    return tl::unexpected(finished.error());
  }
  return result;
}

}  // namespace artcal
