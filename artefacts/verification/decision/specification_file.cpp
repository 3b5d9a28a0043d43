#include "artefacts/verification/decision/specification_file.h"

#include <cmath>

#include <fmt/format.h>

#include "core/text/in_quotes.h"
#include "core/toml/toml_document.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

constexpr std::string_view schema = "artcal-specification/1";

double positive(TomlTable& table, std::string_view key) {
  const double value = table.number(key);
  if (!(value > 0.0)) {
    table.fail(key, fmt::format("`{}` is {}, expected a number above zero", key, value));
  }
  return value;
}

double not_negative(TomlTable& table, std::string_view key) {
  const double value = table.number_or(key, 0.0);
  if (value < 0.0) {
    table.fail(key, fmt::format("`{}` is {}, expected a number of zero or more", key, value));
  }
  return value;
}

int count(TomlTable& table, std::string_view key) {
  const double value = table.number_or(key, 0.0);
  if (value < 0.0 || value > 1e6 || value != std::floor(value)) {
    table.fail(key, fmt::format("`{}` is {}, expected a whole number of zero or more", key, value));
    return 0;
  }
  return static_cast<int>(value);
}

// B; A and K; A, K and B. The length that K divides is in units.length, what comes out in units.limit.
Limit read_limit(TomlTable& table, double length, double limit) {
  if (table.has("A") != table.has("K")) {
    table.fail("A", "a limit is stated as B, as A + L/K, or as min(A + L/K, B): A and K belong together");
    return {};
  }
  if (!table.has("A")) {
    return {positive(table, "B") * limit, 0.0, {}};
  }
  Limit stated{not_negative(table, "A") * limit, limit / (positive(table, "K") * length), {}};
  if (table.has("B")) {
    stated.most = positive(table, "B") * limit;
  }
  return stated;
}

DecisionRule read_rule(TomlTable table) {
  const std::string rule = table.text_or("rule", "iso14253-1:2017");
  if (rule == "iso14253-1:2013") return DecisionRule::Iso14253_2013;
  if (rule == "simple") return DecisionRule::Simple;
  if (rule != "iso14253-1:2017") {
    table.fail("rule", fmt::format("the decision rule is {}, expected \"iso14253-1:2017\", \"iso14253-1:2013\" or "
                                   "\"simple\"",
                                   in_quotes(rule)));
  }
  return DecisionRule::Iso14253_2017;
}

PlannedPosition read_position(TomlTable table) {
  PlannedPosition position;
  position.placement = table.name_or("placement", "");
  const auto from = table.texts("from");
  const auto to = table.texts("to");
  if (from.size() != to.size()) {
    table.fail("from", fmt::format("`from` names {} features and `to` {}; they make pairs", from.size(), to.size()));
    return position;
  }
  for (std::size_t i = 0; i < from.size(); ++i) {
    position.lengths.emplace_back(from[i], to[i]);
  }
  return position;
}

TestPlan read_plan(TomlTable table) {
  TestPlan plan;
  plan.sphere_positions = count(table, "sphere_positions");
  plan.points = count(table, "points");
  plan.orientations = count(table, "orientations");
  plan.points_per_orientation = count(table, "points_per_orientation");
  plan.lengths = count(table, "lengths");
  plan.positions = count(table, "positions");
  plan.repeats = count(table, "repeats");
  plan.longest_share = not_negative(table, "longest_share");
  plan.effective_diameter_repeats = count(table, "effective_diameter_repeats");
  plan.articulation_positions = count(table, "articulation_positions");
  plan.articulation_readings = count(table, "articulation_readings");
  plan.volumetric_lengths = count(table, "volumetric_lengths");
  for (auto& position : table.tables("position")) {
    plan.named.push_back(read_position(position));
  }
  return plan;
}

void read_limits(TomlTable& root, double length, double limit, Specification& specification) {
  for (auto& table : root.tables("limit")) {
    const std::string name = table.text("of");
    const auto quantity = quantity_named(name);
    if (!quantity) {
      table.fail("of", fmt::format("the limit is of {}, expected {}", in_quotes(name), quantity_names()));
      return;
    }
    if (!specification.limits.emplace(*quantity, read_limit(table, length, limit)).second) {
      table.fail("of", fmt::format("the limit of {} is stated twice", name));
    }
  }
}

std::set<Evidence> read_waived(TomlTable& root) {
  std::set<Evidence> waived;
  for (const std::string& name : root.texts("waive")) {
    if (const auto evidence = evidence_named(name)) {
      waived.insert(*evidence);
    } else {
      root.fail("waive", fmt::format("`waive` names {}, expected {}", in_quotes(name), evidence_names()));
    }
  }
  return waived;
}

Specification read_specification(TomlTable& root, const std::filesystem::path& path) {
  Specification specification;
  specification.name = root.name_or("name", truncated(80, path.stem().string()));
  TomlTable units = root.table("units");
  const double length = length_unit(units, "length");
  const double limit = length_unit(units, "limit");
  read_limits(root, length, limit, specification);
  specification.rule = read_rule(root.table("decision"));
  if (root.has("measuring_range")) {
    specification.measuring_range = positive(root, "measuring_range") * length;
  }
  TomlTable temperature = root.table("temperature");
  specification.lowest_temperature = temperature.optional_number("lowest_C");
  specification.highest_temperature = temperature.optional_number("highest_C");
  if (specification.lowest_temperature && specification.highest_temperature &&
      *specification.lowest_temperature > *specification.highest_temperature) {
    temperature.fail("lowest_C", "the lowest temperature is above the highest");
  }
  TomlTable uncertainty = root.table("uncertainty");
  if (uncertainty.has("temperature_K")) {
    specification.u_temperature = positive(uncertainty, "temperature_K");
  }
  specification.u_alignment = not_negative(uncertainty, "alignment") * limit;
  specification.u_fixture = not_negative(uncertainty, "fixture") * limit;
  if (root.has("plan")) {
    specification.plan = read_plan(root.table("plan"));
  }
  specification.waived = read_waived(root);
  TomlTable outliers = root.table("outliers");
  specification.outliers = {count(outliers, "sets"), count(outliers, "values"), count(outliers, "again")};
  return specification;
}

}  // namespace

Expected<SpecificationFile> read_specification_file(const std::filesystem::path& path) {
  auto document = TomlDocument::read(path, schema);
  if (!document) {
    return tl::unexpected(document.error());
  }
  SpecificationFile result{read_specification(document->root(), path), {path.string(), document->sha256()}};
  if (auto finished = document->finish(); !finished) {
    return tl::unexpected(finished.error());
  }
  return result;
}

}  // namespace artcal
