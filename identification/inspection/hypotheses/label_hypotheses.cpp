#include "identification/inspection/hypotheses/label_hypotheses.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr int min_readings = 4;
// Readings that are too few on one side of the move are left out there, which brings a little by chance.
constexpr double per_reading_left_out = 0.1;
constexpr std::size_t max_moves = 200;  // rows tried

int label_of(const Recording& recording, const FeatureConstraint& feature) {
  return recording.readings[static_cast<std::size_t>(feature.readings.front())].feature;
}

std::vector<const FeatureConstraint*> features_of(const Constraints& constraints, int placement) {
  std::vector<const FeatureConstraint*> features;
  for (const FeatureConstraint& feature : constraints.features) {
    if (feature.placement == placement) {
      features.push_back(&feature);
    }
  }
  return features;
}

bool same_kind(const Constraints& constraints, int artefact, int one, int other) {
  const auto& features = constraints.artefacts[static_cast<std::size_t>(artefact)].features;
  return features[static_cast<std::size_t>(one)].kind == features[static_cast<std::size_t>(other)].kind;
}

void relabel(Recording& recording, int placement, int artefact, const std::map<int, std::string>& names) {
  for (Reading& reading : recording.readings) {
    const auto found = names.find(reading.feature);
    if (reading.placement == placement && reading.artefact == artefact && found != names.end()) {
      reading.feature = recording.features.index_of(found->second);
    }
  }
}

// Names the placement of the readings from `from` on anew, and leaves out what is too little on one side.
void split_placement(Recording& recording, int placement, int from) {
  const int other = recording.placements.index_of(recording.placements.name(placement) + " after it moved");
  std::map<std::tuple<int, int, int>, int> counts;
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    Reading& reading = recording.readings[i];
    if (reading.placement == placement && static_cast<int>(i) >= from) {
      reading.placement = other;
    }
    ++counts[{reading.artefact, reading.placement, reading.feature}];
  }
  recording = readings_where(recording, [&](int i) {
    const Reading& reading = recording.readings[static_cast<std::size_t>(i)];
    return (reading.placement != placement && reading.placement != other) ||
           counts[{reading.artefact, reading.placement, reading.feature}] >= min_readings;
  });
}

}  // namespace

Recording readings_of_placement(const Recording& recording, int placement) {
  return readings_where(recording,
                        [&](int i) { return recording.readings[static_cast<std::size_t>(i)].placement == placement; });
}

std::vector<Hypothesis> feature_hypotheses(const Recording& recording, const Constraints& constraints, int placement) {
  std::vector<Hypothesis> hypotheses;
  const auto features = features_of(constraints, placement);
  const std::string in = in_quotes(recording.placements.name(placement));
  for (std::size_t i = 0; i < features.size(); ++i) {
    const FeatureConstraint& first = *features[i];
    const auto& certified = constraints.artefacts[static_cast<std::size_t>(first.artefact)].features;
    const int label = label_of(recording, first);
    const int artefact = recording.readings[static_cast<std::size_t>(first.readings.front())].artefact;
    const std::string where = recording.where(first.readings.front());
    const std::string& name = certified[static_cast<std::size_t>(first.feature)].name;
    for (const FeatureConstraint* other : features) {
      if (other->artefact != first.artefact) {
        continue;
      }
      if (other <= &first || !same_kind(constraints, first.artefact, first.feature, other->feature)) {
        continue;
      }
      const std::string& second = certified[static_cast<std::size_t>(other->feature)].name;
      const std::map<int, std::string> names{{label, second}, {label_of(recording, *other), name}};
      hypotheses.push_back(
          {FindingKind::FeaturesExchanged, 0, where,
           fmt::format("with features {} and {} of placement {} exchanged", in_quotes(name), in_quotes(second), in),
           "Exchange the two names in these rows",
           [placement, artefact, names](Recording& changed, std::vector<Artefact>&) {
             relabel(changed, placement, artefact, names);
           }});
    }
    for (int other = 0; other < static_cast<int>(certified.size()); ++other) {
      if (other == first.feature || !same_kind(constraints, first.artefact, first.feature, other)) {
        continue;
      }
      const std::string& second = certified[static_cast<std::size_t>(other)].name;
      // Where the other feature was read as well, these readings join its own.
      hypotheses.push_back(
          {FindingKind::WrongFeature, 0, where,
           fmt::format("with the readings of feature {} in placement {} taken on feature {}", in_quotes(name), in,
                       in_quotes(second)),
           "Correct the feature's name in these rows, or measure that feature again",
           [placement, artefact, names = std::map<int, std::string>{{label, second}}](
               Recording& changed, std::vector<Artefact>&) { relabel(changed, placement, artefact, names); }});
    }
  }
  return hypotheses;
}

std::vector<Hypothesis> move_hypotheses(const Recording& recording, const Constraints& constraints, int placement,
                                        const Arm& arm) {
  std::vector<int> rows;
  for (std::size_t i = 0; i < recording.readings.size(); ++i) {
    if (recording.readings[i].placement == placement) {
      rows.push_back(static_cast<int>(i));
    }
  }
  const Recording own = readings_of_placement(recording, placement);
  double least = std::numeric_limits<double>::infinity();
  std::size_t best = 0;
  const auto discrepancy_at = [&](std::size_t k) {
    const Hypothesis split{
        FindingKind::ArtefactMoved, 2, "", "", "", [placement, k](Recording& changed, std::vector<Artefact>&) {
          split_placement(changed, placement, static_cast<int>(k));
        }};
    const auto bound = applied(split, own, constraints.artefacts);
    if (!bound) {
      return std::numeric_limits<double>::infinity();
    }
    const auto left_out = static_cast<double>(own.readings.size() - bound->recording.readings.size());
    return discrepancy(*bound, arm) * (1.0 + per_reading_left_out * left_out);
  };
  const std::size_t step = std::max<std::size_t>(1, rows.size() / max_moves);
  for (std::size_t k = min_readings; k + min_readings <= rows.size(); k += step) {
    if (const double found = discrepancy_at(k); found < least) {
      least = found;
      best = k;
    }
  }
  if (best == 0) {
    return {};
  }
  const int from = rows[best];
  return {
      {FindingKind::ArtefactMoved, 2, recording.where(from),
       fmt::format("with the artefact moved in placement {} before this reading",
                   in_quotes(recording.placements.name(placement))),
       "Give the readings from there on a placement's name of their own, and hold the artefact more firmly",
       [placement, from](Recording& changed, std::vector<Artefact>&) { split_placement(changed, placement, from); }}};
}

std::vector<Hypothesis> table_name_hypotheses(const Recording& recording) {
  std::map<int, std::set<int>> tables;
  for (const Reading& reading : recording.readings) {
    tables[reading.placement].insert(reading.file);
  }
  const auto shared =
      std::find_if(tables.begin(), tables.end(), [](const auto& entry) { return entry.second.size() > 1; });
  if (shared == tables.end()) {
    return {};
  }
  const int table = *std::next(shared->second.begin());
  const auto count =
      std::count_if(tables.begin(), tables.end(), [](const auto& entry) { return entry.second.size() > 1; });
  return {{FindingKind::PlacementNamesReused, 0, recording.files[static_cast<std::size_t>(table)],
           fmt::format("with the placements of each table taken for its own ({} of their names, {} first, are in "
                       "several tables)",
                       count, in_quotes(recording.placements.name(shared->first))),
           "Give each placement a name of its own", [](Recording& changed, std::vector<Artefact>&) {
             for (Reading& reading : changed.readings) {
               reading.placement = changed.placements.index_of(
                   fmt::format("{} of table {}", changed.placements.name(reading.placement), reading.file + 1));
             }
           }}};
}

std::vector<Hypothesis> other_table_hypotheses(const Recording& recording) {
  std::vector<Hypothesis> hypotheses;
  for (int table = 0; recording.files.size() > 1 && table < static_cast<int>(recording.files.size()); ++table) {
    const std::string& file = recording.files[static_cast<std::size_t>(table)];
    const auto count = std::count_if(recording.readings.begin(), recording.readings.end(),
                                     [&](const Reading& reading) { return reading.file == table; });
    if (2 * count > static_cast<std::ptrdiff_t>(recording.readings.size())) {
      continue;  // what most readings say is the arm
    }
    hypotheses.push_back({FindingKind::AnotherArmState, 3, file,
                          "without this table, whose readings no arm fits together with the others,",
                          "Identify the tables apart: another arm read it, or the arm changed between them",
                          [table](Recording& changed, std::vector<Artefact>&) {
                            changed = readings_where(changed, [&](int i) {
                              return changed.readings[static_cast<std::size_t>(i)].file != table;
                            });
                          }});
  }
  return hypotheses;
}

Hypothesis without_placement(const Recording& recording, int placement) {
  const auto first = std::find_if(recording.readings.begin(), recording.readings.end(),
                                  [&](const Reading& reading) { return reading.placement == placement; });
  return {FindingKind::PlacementContradicts,
          4,
          recording.where(static_cast<int>(first - recording.readings.begin())),
          fmt::format("without placement {}, whose readings do not fit the arm that all others fit,",
                      in_quotes(recording.placements.name(placement))),
          "Look for the artefact having moved, a feature under another's name, or measure the placement again",
          [placement](Recording& changed, std::vector<Artefact>&) {
            changed = readings_where(
                changed, [&](int i) { return changed.readings[static_cast<std::size_t>(i)].placement != placement; });
          }};
}

}  // namespace artcal
