#include "artefacts/artefact/geometry_tables.h"

#include <vector>

#include <fmt/format.h>

#include "artefacts/artefact/consistency.h"
#include "artefacts/artefact/distance_table.h"
#include "artefacts/artefact/feature_table.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::size_t max_features = 1000;
constexpr std::size_t max_distances = 5000;

bool too_many(TomlTable& root, const char* key, std::size_t count, std::size_t most) {
  if (count > most) {
    root.fail(key, fmt::format("the artefact has {} tables [[{}]], more than the {} that are read", count, key, most));
  }
  return count > most;
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

void note(const Contradiction& found, std::vector<TomlTable>& features, std::vector<TomlTable>& distances,
          const std::vector<std::size_t>& table_of) {
  if (found.of == Contradiction::Of::Feature) {
    TomlTable& table = features[found.index];
    table.fail(table.has("at") ? "at" : "kind", found.message);
    return;
  }
  TomlTable& table = distances[table_of[found.index]];
  const char* ends = table.has("along") ? "along" : "between";
  table.fail(found.of == Contradiction::Of::Ends || !table.has("value") ? ends : "value", found.message);
}

}  // namespace

void read_geometry(TomlTable& root, const ArtefactValues& values, Artefact& artefact) {
  auto features = root.tables("feature");
  auto distances = root.tables("distance");
  if (too_many(root, "feature", features.size(), max_features) ||
      too_many(root, "distance", distances.size(), max_distances)) {
    return;
  }
  for (auto& table : features) {
    artefact.features.push_back(read_feature(table, values));
  }
  check_names(artefact, root);
  if (artefact.features.empty()) {
    return;
  }
  std::vector<std::size_t> table_of;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    if (artefact.distances.size() > max_distances) {
      root.fail("distance", fmt::format("the artefact has more than the {} distances that are read", max_distances));
      return;
    }
    for (const auto& distance : read_distances(distances[i], artefact, values)) {
      artefact.distances.push_back(distance);
      table_of.push_back(i);
    }
  }
  if (const auto found = find_contradiction(artefact)) {
    note(*found, features, distances, table_of);
  }
}

}  // namespace artcal
