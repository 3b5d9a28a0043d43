#include "artefacts/artefact/distance_table.h"

#include <cmath>

#include <fmt/format.h>

#include "artefacts/artefact/length_values.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// Indices of the features that are named; fewer where a name is unknown, which has been noted then.
std::vector<int> read_names(TomlTable& table, std::string_view key, const Artefact& artefact) {
  std::vector<int> indices;
  for (const auto& name : table.texts(key)) {
    const int index = artefact.feature_index(name);
    if (name.empty() || index < 0) {
      table.fail(key,
                 fmt::format("the distance names the feature {}, which the artefact does not have", in_quotes(name)));
      return {};
    }
    indices.push_back(index);
  }
  return indices;
}

void check_ends(TomlTable& table, std::string_view key, const CertifiedFeature& from, const CertifiedFeature& to) {
  if (from.kind == FeatureKind::Coordinates || to.kind == FeatureKind::Coordinates) {
    table.fail(key, "a feature of the kind \"coordinates\" is no single point that a distance could end at");
  } else if ((from.kind == FeatureKind::Plane) != (to.kind == FeatureKind::Plane)) {
    table.fail(key, fmt::format("of the features {} and {} one is a plane; a distance lies between two planes, or "
                                "between two points or balls' centres",
                                in_quotes(from.name), in_quotes(to.name)));
  } else if (from.at.has_value() != to.at.has_value()) {
    // Half known, it would bind the pose to a free point; no certificate says such a thing.
    table.fail(key, fmt::format("of the features {} and {} only one has certified coordinates; state `at` for "
                                "both, or for neither",
                                in_quotes(from.name), in_quotes(to.name)));
  }
}

CertifiedDistance make_distance(TomlTable& table, const char* value_key, const Artefact& artefact,
                                const ArtefactValues& values, int first, int second, double value,
                                const CertifiedUncertainty& certified, const TemperatureConversion& conversion) {
  CertifiedDistance distance{first, second, value * conversion.factor, 1.0};
  if (conversion.temperature) {
    distance.stated = StatedValue{value, *conversion.temperature};
  }
  if (distance.value <= 0.0) {
    table.fail(value_key, "a certified distance is not above zero");
    return distance;
  }
  if (!(distance.value <= largest_length)) {
    table.fail(value_key, fmt::format("a certified distance of {:.6g} mm; is it in the wrong unit?", distance.value));
    return distance;
  }
  const auto u = read_uncertainty(table, values, "U", "k", values.distance_rule, distance.value, certified);
  distance.u =
      std::hypot(u ? *u : read_standard_uncertainty(table, values, "U"), conversion.relative_u * distance.value);
  if (distance.u > 0.05 * distance.value) {
    table.fail("U", fmt::format("a standard uncertainty of {} mm is much for a distance of {} mm; is it in the wrong "
                                "unit?",
                                distance.u, distance.value));
  }
  check_ends(table, table.has("between") ? "between" : "along", artefact.features[first], artefact.features[second]);
  return distance;
}

std::vector<CertifiedDistance> read_one(TomlTable& table, const Artefact& artefact, const ArtefactValues& values) {
  const auto names = table.texts("between");
  if (names.size() != 2 || names[0] == names[1]) {
    table.fail("between", "a distance lies between two features, such as between = [\"1\", \"2\"]");
    return {};
  }
  const auto ends = read_names(table, "between", artefact);
  if (ends.size() != 2) {
    return {};
  }
  const LengthValues stated = read_length(table, "value", values);
  return {make_distance(table, "value", artefact, values, ends[0], ends[1], stated.values.front(),
                        stated.certified_of(0), read_conversion(table, values))};
}

// The temperature of each value of a row: `temperatures_C`, or `temperature_C` for all.
std::vector<TemperatureConversion> read_conversions(TomlTable& table, const ArtefactValues& values, std::size_t count) {
  if (!table.has("temperatures_C")) {
    return std::vector<TemperatureConversion>(count, read_conversion(table, values));
  }
  std::vector<TemperatureConversion> all;
  for (const double temperature : table.numbers("temperatures_C")) {
    all.push_back(conversion_at(table, "temperatures_C", temperature, values));
  }
  if (all.size() != count) {
    table.fail("temperatures_C", fmt::format("there are {} temperatures for {} values", all.size(), count));
    all.resize(count);
  }
  return all;
}

std::vector<CertifiedDistance> read_row(TomlTable& table, const Artefact& artefact, const ArtefactValues& values) {
  const auto row = read_names(table, "along", artefact);
  const bool from_first = table.has("positions");
  const char* key = from_first ? "positions" : "steps";
  const LengthValues stated = read_lengths(table, key, values);
  const auto& numbers = stated.values;
  if (from_first && table.has("steps")) {
    table.fail("steps", "state `steps`, each to the next, or `positions`, each from the first, not both");
  }
  if (row.size() < 2 || numbers.size() != row.size() - 1) {
    table.fail(key, fmt::format("there are {} values along {} features, expected one less than features",
                                numbers.size(), row.size()));
    return {};
  }
  const auto conversions = read_conversions(table, values, numbers.size());
  std::vector<CertifiedDistance> all;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (row[from_first ? 0 : i] == row[i + 1]) {
      table.fail("along",
                 fmt::format("the row names the feature {} twice", in_quotes(artefact.features[row[i + 1]].name)));
      return {};
    }
    all.push_back(make_distance(table, key, artefact, values, row[from_first ? 0 : i], row[i + 1], numbers[i],
                                stated.certified_of(i), conversions[i]));
  }
  return all;
}

}  // namespace

std::vector<CertifiedDistance> read_distances(TomlTable& table, const Artefact& artefact,
                                              const ArtefactValues& values) {
  return table.has("along") ? read_row(table, artefact, values) : read_one(table, artefact, values);
}

}  // namespace artcal
