#include "artefacts/simulation/plan/plan_session.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "artefacts/simulation/plan/plan_keys.h"
#include "core/text/in_quotes.h"
#include "core/text/name_list.h"

namespace artcal {
namespace {

constexpr int max_points = 100'000;  // of a pattern

std::vector<std::string> names_of(const auto& named) {
  std::vector<std::string> names;
  for (const auto& one : named) {
    if constexpr (requires { one.certified; }) {
      names.push_back(one.certified.name);
    } else {
      names.push_back(one.name);
    }
  }
  return names;
}

// The artefact a table names; the only one where it names none.
int artefact_at(TomlTable& table, const SimulationPlan& plan) {
  const std::string name = table.name_or("artefact", "");
  for (std::size_t i = 0; i < plan.artefacts.size(); ++i) {
    if (plan.artefacts[i].certified.name == name || (name.empty() && plan.artefacts.size() == 1)) {
      return static_cast<int>(i);
    }
  }
  table.fail("artefact", name.empty() ? "the table names no artefact, and there are several"
                                      : fmt::format("there is no artefact {} in this plan; `artefact` can be {}",
                                                    in_quotes(name), listed_names(names_of(plan.artefacts))));
  return 0;
}

int feature_called(TomlTable& table, std::string_view key, const std::string& name, const Artefact& artefact) {
  const int feature = artefact.feature_index(name);
  if (feature < 0) {
    table.fail(key, fmt::format("the artefact {} has no feature {}; `{}` can be {}", in_quotes(artefact.name),
                                in_quotes(name), key, listed_names(names_of(artefact.features))));
  }
  return std::max(0, feature);
}

Eigen::Matrix3d turned(const Eigen::Vector3d& about_xyz) {
  return (Eigen::AngleAxisd(about_xyz.z(), Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(about_xyz.y(), Eigen::Vector3d::UnitY()) *
          Eigen::AngleAxisd(about_xyz.x(), Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}

void read_temperature(TomlTable& table, const std::string& prefix, std::optional<double>& begin, double& end) {
  const std::string at_begin = prefix + "temperature_C";
  const std::string at_end = prefix + "temperature_end_C";
  if (table.has(at_begin)) {
    begin = number_between(table, at_begin, 20.0, -100.0, 200.0);
  }
  end = number_between(table, at_end, begin.value_or(20.0), -100.0, 200.0);
  if (table.has(at_end) && !begin) {
    table.fail(at_end, fmt::format("a temperature at the end needs one at the beginning, `{}`", at_begin));
  }
}

void read_placement(TomlTable table, SimulationPlan& plan, const PlanUnits& units) {
  PlannedPlacement placement;
  placement.where = table.where("");
  placement.artefact = artefact_at(table, plan);
  const bool in_base = plan.artefacts[placement.artefact].certified.frame == CoordinateFrame::Base;
  const auto position = triple_at(table, "position");
  const auto turn = triple_at(table, "turn");
  const int drawn = count_at(table, "random", 0, 0, max_planned_placements);
  placement.upright = table.truth_or("upright", false);
  if (in_base && (position || turn || drawn > 0)) {
    table.fail("", "the artefact's coordinates stand in the arm's base frame, so that it has no other position");
  } else if (!in_base && position.has_value() == (drawn > 0)) {
    table.fail("", "a placement states its `position`, or how many are to be drawn, such as random = 7");
  } else if (turn && !position) {
    table.fail("turn", "`turn` goes with `position`; what is drawn is turned at random");
  } else if (placement.upright && drawn == 0) {
    table.fail("upright", "`upright` is for placements that are drawn");
  }
  if (drawn == 0) {
    placement.base_from_artefact = Rigid{turned(units.angle * turn.value_or(Eigen::Vector3d::Zero())),
                                         units.length * position.value_or(Eigen::Vector3d::Zero())};
  }
  read_temperature(table, "", placement.temperature, placement.temperature_end);
  read_temperature(table, "arm_", placement.arm_temperature, placement.arm_temperature_end);
  const std::string name = table.name_or("name", "");
  for (int i = 0; i < std::max(1, drawn); ++i) {
    const std::string number = fmt::format("{}", drawn == 0 || name.empty() ? plan.placements.size() + 1 : i + 1);
    placement.name = name.empty() ? number : drawn > 0 ? name + " " + number : name;
    plan.placements.push_back(placement);
  }
}

void check_names(const std::vector<PlannedPlacement>& placements, TomlTable& root) {
  std::vector<std::string> names;
  for (const auto& placement : placements) {
    names.push_back(placement.name);
  }
  std::sort(names.begin(), names.end());
  if (const auto twice = std::adjacent_find(names.begin(), names.end()); twice != names.end()) {
    root.fail("placement", fmt::format("two placements are called {}; give each its own name", in_quotes(*twice)));
  }
}

// Indices of the placements a table names: those called so, and the drawn ones "NAME 1", "NAME 2" …; all of
// the artefact where it names none.
std::vector<int> placements_at(TomlTable& table, const SimulationPlan& plan, int artefact) {
  const auto names = table.texts("placements");
  std::vector<int> found;
  std::vector<bool> used(names.size(), false);
  for (int p = 0; p < static_cast<int>(plan.placements.size()); ++p) {
    const PlannedPlacement& placement = plan.placements[p];
    bool wanted = names.empty();
    for (std::size_t i = 0; i < names.size(); ++i) {
      const bool drawn = !placement.base_from_artefact && placement.name.starts_with(names[i] + " ");
      const bool fits = placement.artefact == artefact && (placement.name == names[i] || drawn);
      used[i] = used[i] || fits;
      wanted = wanted || fits;
    }
    if (wanted && placement.artefact == artefact) {
      found.push_back(p);
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!used[i]) {
      std::vector<std::string> there;
      for (const PlannedPlacement& placement : plan.placements) {
        if (placement.artefact == artefact) {
          there.push_back(placement.name);
        }
      }
      table.fail("placements", fmt::format("the artefact {} has no placement {}; `placements` can be {}",
                                           in_quotes(plan.artefacts[artefact].certified.name), in_quotes(names[i]),
                                           listed_names(there)));
    }
  }
  return found;
}

std::vector<int> features_at(TomlTable& table, const Artefact& artefact) {
  std::vector<int> features;
  for (const auto& name : table.texts("features")) {
    const int feature = feature_called(table, "features", name, artefact);
    if (std::find(features.begin(), features.end(), feature) != features.end()) {
      table.fail("features", fmt::format("the feature {} is there twice", in_quotes(name)));
    }
    features.push_back(feature);
  }
  if (!table.has("features")) {
    features.resize(artefact.features.size());
    std::iota(features.begin(), features.end(), 0);
  }
  return features;
}

void read_pattern(TomlTable& table, PlannedProbing& probing, const Artefact& artefact) {
  const std::string pattern = table.text_or("pattern", "spread");
  if (pattern != "spread" && pattern != "iso25") {
    table.fail("pattern", fmt::format("the pattern is {}, expected \"spread\" or \"iso25\"", in_quotes(pattern)));
  }
  probing.pattern = pattern == "iso25" ? TouchPattern::Iso25 : TouchPattern::Spread;
  probing.points = count_at(table, "points", 25, 1, max_points);
  if (probing.pattern != TouchPattern::Iso25) {
    return;
  }
  if (probing.points != 25) {
    table.fail("points", "the pattern \"iso25\" has 25 points, no other number");
  }
  for (const int feature : probing.features) {
    if (artefact.features[feature].kind != FeatureKind::Sphere) {
      table.fail("pattern", fmt::format("the pattern \"iso25\" is for balls, but the feature {} is none",
                                        in_quotes(artefact.features[feature].name)));
    }
  }
}

void check_wishes(TomlTable& table, const PlannedProbing& probing, const Artefact& artefact) {
  const auto has = [&](FeatureKind kind) {
    return std::any_of(probing.features.begin(), probing.features.end(),
                       [&](int feature) { return artefact.features[feature].kind == kind; });
  };
  for (const auto& [key, kind, what] :
       {std::tuple("pole", FeatureKind::Sphere, "balls"), std::tuple("cap", FeatureKind::Sphere, "balls"),
        std::tuple("extent", FeatureKind::Plane, "planes"), std::tuple("lengths", FeatureKind::Anchor, "anchors")}) {
    if (table.has(key) && !has(kind)) {
      table.fail(key, fmt::format("`{}` is for {}, and there are none among these features", key, what));
    }
  }
  if (probing.orientations > 0 && (has(FeatureKind::Anchor) || has(FeatureKind::Coordinates))) {
    table.fail("orientations", "orientations are for what is touched; lengths and coordinates are read anywhere");
  }
}

void read_scan(TomlTable& table, PlannedProbing& probing, const Artefact& artefact) {
  probing.scan = table.truth_or("scan", false);
  const auto is_found = [&](int feature) {
    const CertifiedFeature& ball = artefact.features[static_cast<std::size_t>(feature)];
    return ball.kind == FeatureKind::Sphere && ball.radius;
  };
  if (probing.scan && !std::all_of(probing.features.begin(), probing.features.end(), is_found)) {
    table.fail("scan", "a scan is searched for balls of certified diameter, and not all of these features are such");
  }
}

PlannedProbing read_probing(TomlTable table, const SimulationPlan& plan, const PlanUnits& units) {
  PlannedProbing probing;
  probing.artefact = artefact_at(table, plan);
  const Artefact& artefact = plan.artefacts[probing.artefact].certified;
  probing.features = features_at(table, artefact);
  probing.placements = placements_at(table, plan, probing.artefact);
  const std::string probe = table.name_or("probe", plan.nominal.probes.front().name);
  probing.probe = probe_index(plan.nominal, probe);
  if (probing.probe < 0) {
    table.fail("probe", fmt::format("the arm has no probe {}; `probe` can be {}", in_quotes(probe),
                                    listed_names(names_of(plan.nominal.probes))));
    probing.probe = 0;
  }
  read_pattern(table, probing, artefact);
  read_scan(table, probing, artefact);
  probing.orientations = count_at(table, "orientations", 0, 0, 1000);
  probing.repeats = count_at(table, "repeats", 1, 1, max_points);
  probing.pole_in_base = direction_at(table, "pole").value_or(probing.pole_in_base);
  probing.cap = table.number_or("cap", probing.cap / units.angle) * units.angle;
  if (!(probing.cap > 0.0 && probing.cap <= std::numbers::pi * (1.0 + 1e-12))) {
    table.fail("cap", "the angle of the cap is out of range, expected more than 0 and at most 180 degrees");
  }
  if (const auto extent = pair_at(table, "extent")) {
    probing.extent = units.length * extent->cwiseMax(0.0);
    if (extent->minCoeff() < 0.0) {
      table.fail("extent", "the extent of a plane is negative");
    }
  }
  if (const auto lengths = pair_at(table, "lengths")) {
    probing.lengths = units.length * *lengths;
    if (!(lengths->x() >= 0.0 && lengths->x() < lengths->y())) {
      table.fail("lengths", "`lengths` are the shortest and the longest that can be measured, such as [100, 1500]");
    }
  }
  check_wishes(table, probing, artefact);
  return probing;
}

}  // namespace

void read_true_features(TomlTable& root, SimulationPlan& plan, const PlanUnits& units) {
  for (auto& table : root.tables("true_feature")) {
    PlannedArtefact& artefact = plan.artefacts[artefact_at(table, plan)];
    const int index = feature_called(table, "feature", table.name("feature"), artefact.certified);
    const FeatureKind kind = artefact.certified.features[index].kind;
    TrueFeature& feature = artefact.stated[index];
    if (const auto at = triple_at(table, "at")) {
      feature.at = units.length * *at;
    }
    feature.normal = direction_at(table, "normal");
    if (table.has("diameter")) {
      feature.radius = 0.5 * units.length * number_between(table, "diameter", 1.0, 1e-3, 1e5);
    }
    if ((feature.normal && kind != FeatureKind::Plane) || (feature.radius && kind != FeatureKind::Sphere) ||
        kind == FeatureKind::Coordinates) {
      table.fail("feature",
                 "a place belongs to points, balls, planes and anchors, a normal to planes, a diameter to balls");
    }
  }
}

void read_stand(TomlTable& root, SimulationPlan& plan, const PlanUnits& units) {
  TomlTable table = root.table("stand");
  const auto height = [&](std::string_view key) {
    const auto stated = table.optional_number(key);
    return stated ? std::optional(units.length * *stated) : std::nullopt;
  };
  Stand& stand = plan.stand;
  stand.floor = height("floor");
  stand.lowest = height("lowest");
  stand.highest = height("highest");
  if (stand.lowest && stand.highest && !(*stand.lowest < *stand.highest)) {
    table.fail("highest", "`highest` is not above `lowest`, so that the stand holds nothing");
  }
  for (TomlTable& stated : table.tables("table")) {
    const auto x = pair_at(stated, "x"), y = pair_at(stated, "y");
    const double top = stated.number("top");
    if (!x || !y || !((*x)[0] < (*x)[1]) || !((*y)[0] < (*y)[1])) {
      stated.fail("x", "a table states `x` and `y`, each from less to more, such as x = [300, 1100], and its `top`");
      continue;
    }
    stand.tables.push_back({units.length * *x, units.length * *y, units.length * top});
  }
}

void read_placements(TomlTable& root, SimulationPlan& plan, const PlanUnits& units) {
  for (auto& table : root.tables("placement")) {
    read_placement(std::move(table), plan, units);
    if (plan.placements.size() > max_planned_placements) {
      root.fail("placement", fmt::format("there are more than {} placements", max_planned_placements));
      return;
    }
  }
  if (plan.placements.empty()) {
    root.fail("placement", "the artefacts stand nowhere, expected at least one table headed [[placement]]");
  }
  check_names(plan.placements, root);
}

void read_probings(TomlTable& root, SimulationPlan& plan, const PlanUnits& units) {
  for (auto& table : root.tables("probing")) {
    plan.probings.push_back(read_probing(std::move(table), plan, units));
  }
  const double readings = planned_readings(plan);
  if (readings < 1.0) {
    root.fail("probing", "the plan makes no readings, expected at least one table headed [[probing]]");
  } else if (readings > max_planned_readings) {
    root.fail("probing",
              fmt::format("the plan makes {:.0f} readings, expected at most {}", readings, max_planned_readings));
  }
  std::vector<bool> probed(plan.placements.size(), false);
  for (const PlannedProbing& probing : plan.probings) {
    for (const int placement : probing.placements) {
      probed[placement] = true;
    }
  }
  if (const auto idle = std::find(probed.begin(), probed.end(), false); idle != probed.end()) {
    root.fail("probing", fmt::format("nothing is probed in the placement {}",
                                     in_quotes(plan.placements[idle - probed.begin()].name)));
  }
}

}  // namespace artcal
