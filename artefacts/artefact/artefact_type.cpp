#include "artefacts/artefact/artefact_type.h"

#include <array>
#include <limits>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr int any_number = std::numeric_limits<int>::max();

struct TypeEntry {
  ArtefactType type;
  std::string_view name;
  FeatureKind kind;  // that its features are of
  std::string_view plural;
  bool or_points = false;  // balls may be held in seats and probed with a mating tip
  int fewest = 1;
  int most = any_number;
};

constexpr std::array types{
    TypeEntry{ArtefactType::BallBar, "ball bar", FeatureKind::Sphere, "spheres or points", true, 2},
    TypeEntry{ArtefactType::SpherePlate, "sphere plate", FeatureKind::Sphere, "spheres or points", true, 3},
    TypeEntry{ArtefactType::Plane, "plane", FeatureKind::Plane, "planes"},
    TypeEntry{ArtefactType::Sphere, "sphere", FeatureKind::Sphere, "spheres", false, 1, 1},
    TypeEntry{ArtefactType::SeatPlate, "seat plate", FeatureKind::Point, "points"},
    TypeEntry{ArtefactType::StepGauge, "step gauge", FeatureKind::Plane, "planes", false, 2},
    TypeEntry{ArtefactType::GaugeBlock, "gauge block", FeatureKind::Plane, "planes", false, 2, 2},
    TypeEntry{ArtefactType::TelescopingBar, "telescoping bar", FeatureKind::Anchor, "anchors"},
};

std::string count_text(const TypeEntry& entry) {
  return entry.most == entry.fewest ? fmt::format("{}", entry.fewest)
         : entry.most == any_number ? fmt::format("at least {}", entry.fewest)
                                    : fmt::format("{} to {}", entry.fewest, entry.most);
}

}  // namespace

std::optional<ArtefactType> artefact_type(std::string_view name) {
  for (const TypeEntry& entry : types) {
    if (entry.name == name) {
      return entry.type;
    }
  }
  return std::nullopt;
}

std::string artefact_type_names() {
  std::string names;
  for (const TypeEntry& entry : types) {
    names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", entry.name);
  }
  return names;
}

std::string_view name_of(ArtefactType type) {
  for (const TypeEntry& entry : types) {
    if (entry.type == type) {
      return entry.name;
    }
  }
  return "artefact";
}

std::optional<TypeContradiction> contradiction_of_type(const Artefact& artefact) {
  for (const TypeEntry& entry : types) {
    if (entry.type != artefact.type) {
      continue;
    }
    const int count = static_cast<int>(artefact.features.size());
    for (int i = 0; i < count; ++i) {
      const FeatureKind kind = artefact.features[i].kind;
      if (kind != entry.kind && !(entry.or_points && kind == FeatureKind::Point)) {
        return TypeContradiction{i, fmt::format("the artefact is a {}, which has {}, but the feature {} is none",
                                                entry.name, entry.plural, in_quotes(artefact.features[i].name))};
      }
    }
    if (count < entry.fewest || count > entry.most) {
      return TypeContradiction{0, fmt::format("the artefact is a {} and has {} features, expected {}", entry.name,
                                              count, count_text(entry))};
    }
  }
  return std::nullopt;
}

}  // namespace artcal
