#include "app/results/planning/plan_result.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "acquisition/csv/csv_text.h"
#include "app/output/table.h"
#include "app/results/result_head.h"
#include "app/results/shown_unit.h"
#include "artefacts/verification/point_uncertainty.h"
#include "core/text/in_quotes.h"
#include "core/units.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

Json coordinates(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Json u_json(const PredictedU& u) { return {{"mean_mm", u.mean}, {"worst_mm", u.worst}}; }

Json expectation_json(const Expectation& expectation) {
  const Observability& o = expectation.observability;
  return {{"u_of_a_length", u_json(expectation.u)},
          {"u_of_the_arm", u_json(expectation.u_of_arm)},
          {"observability", {o.o1, o.o2, o.o3, o.o4, o.o5}}};
}

Json chosen_json(const PlanResult& result, const ChosenPlacement& chosen) {
  const Recording& recording = result.possible.recording;
  const RealPlacement& place = result.possible.placements[static_cast<std::size_t>(chosen.candidate)];
  const StandingEnds ends = ends_of(result.possible, chosen.candidate);
  Json rotation = Json::array();
  for (int row = 0; row < 3; ++row) {
    rotation.push_back(coordinates(place.base_from_artefact.rotation.row(row)));
  }
  Json readings = Json::array();
  for (const int reading : chosen.readings) {
    const Eigen::VectorXd q = recording.joints.col(reading);
    readings.push_back({{"feature", recording.features.name(recording.readings[reading].feature)},
                        {"joints_rad", std::vector<double>(q.begin(), q.end())}});
  }
  Json balls = Json::array();
  for (const PlannedBall& ball : chosen.balls) {
    balls.push_back({{"feature", ball.feature},
                     {"touches", ball.touches},
                     {"dilution", std::isfinite(ball.dilution) ? Json(ball.dilution) : Json(nullptr)}});
  }
  return {{"placement", place.name},
          {"artefact", result.plan.artefacts[static_cast<std::size_t>(place.artefact)].certified.name},
          {"first_feature_mm", coordinates(ends.first_in_base)},
          {"last_feature_mm", coordinates(ends.last_in_base)},
          {"rotation", rotation},
          {"translation_mm", coordinates(place.base_from_artefact.translation)},
          {"balls", balls},
          {"readings", readings}};
}

std::string expectations_text(const PlanResult& result) {
  Table table({"", "mean", "worst", "arm's share: mean", "worst", "O1", "O2", "O3", "O4", "O5"});
  const auto add = [&](const std::string& what, const Expectation& expectation) {
    const Observability& o = expectation.observability;
    std::vector<std::string> row{what, in_micrometres(expectation.u.mean), in_micrometres(expectation.u.worst),
                                 in_micrometres(expectation.u_of_arm.mean), in_micrometres(expectation.u_of_arm.worst)};
    for (const double index : {o.o1, o.o2, o.o3, o.o4, o.o5}) {
      row.push_back(fmt::format("{:.3g}", index));
    }
    table.add(row);
  };
  if (result.planning.measured) {
    add("as measured so far", *result.planning.measured);
  }
  add("with this plan", result.planning.planned);
  table.add({fmt::format("as many by chance (median of {})", result.options.random_plans),
             in_micrometres(result.planning.random.mean), in_micrometres(result.planning.random.worst),
             in_micrometres(result.planning.random_of_arm.mean), in_micrometres(result.planning.random_of_arm.worst)});
  add("with everything possible", result.planning.all);
  return table.text();
}

std::string placements_text(const PlanResult& result) {
  const Recording& recording = result.possible.recording;
  Table table({"placement", "artefact", "from x, y, z mm", "to x, y, z mm", "readings"});
  for (const ChosenPlacement& chosen : result.planning.chosen) {
    const RealPlacement& place = result.possible.placements[static_cast<std::size_t>(chosen.candidate)];
    const StandingEnds ends = ends_of(result.possible, chosen.candidate);
    const auto told = [](const Eigen::Vector3d& at) {
      return fmt::format("{:.0f}, {:.0f}, {:.0f}", at.x(), at.y(), at.z());
    };
    std::map<std::string, int> counts;
    for (const int reading : chosen.readings) {
      ++counts[recording.features.name(recording.readings[reading].feature)];
    }
    std::string readings;
    for (const auto& [feature, count] : counts) {
      readings += fmt::format("{}{} {}", readings.empty() ? "" : ", ", truncated(20, feature), count);
    }
    const auto& artefact = result.plan.artefacts[static_cast<std::size_t>(place.artefact)].certified;
    table.add({truncated(30, place.name), truncated(30, artefact.name), told(ends.first_in_base),
               told(ends.last_in_base), truncated(60, readings)});
  }
  return table.text();
}

// Balls whose centre their touches determine so poorly that verification shows nothing by them.
std::string dilution_text(const PlanResult& result) {
  std::string text;
  for (const ChosenPlacement& chosen : result.planning.chosen) {
    for (const PlannedBall& ball : chosen.balls) {
      if (ball.dilution > max_dilution) {
        text += fmt::format(
            "Warning: placement {}, {}: {} touches determine the ball's centre with {} the scatter of one touch; take "
            "more, spread over the ball\n",
            in_quotes(result.possible.placements[static_cast<std::size_t>(chosen.candidate)].name),
            in_quotes(ball.feature), ball.touches,
            std::isfinite(ball.dilution) ? fmt::format("{:.1f} times", ball.dilution) : "no bound beside");
      }
    }
  }
  return text.empty() ? "" : "\n" + text;
}

std::string prior_text(const PlanResult& result) {
  return result.measured_readings > 0
             ? fmt::format("beside {} readings that are there already", result.measured_readings)
             : std::string("as the first readings of this arm");
}

// As plan.toml states it: the artefact's origin, and turns about the base's x, then y, then z.
std::string pose_cells(const Rigid& base_from_artefact) {
  const Eigen::Matrix3d& r = base_from_artefact.rotation;
  const std::array turns{std::atan2(r(2, 1), r(2, 2)), std::asin(std::clamp(-r(2, 0), -1.0, 1.0)),
                         std::atan2(r(1, 0), r(0, 0))};
  std::string text;
  for (const double length : base_from_artefact.translation) {
    text += fmt::format(",{:.2f}", length);
  }
  for (const double angle : turns) {
    text += fmt::format(",{:.3f}", angle / units::degree);
  }
  return text;
}

Json length_or_null(const std::optional<double>& length) { return length ? Json(*length) : Json(nullptr); }

Json stand_json(const Stand& stand) {
  Json tables = Json::array();
  for (const Obstacle& table : stand.tables) {
    tables.push_back({{"x_mm", {table.x[0], table.x[1]}}, {"y_mm", {table.y[0], table.y[1]}}, {"top_mm", table.top}});
  }
  return {{"floor_mm", length_or_null(stand.floor)},
          {"lowest_mm", length_or_null(stand.lowest)},
          {"highest_mm", length_or_null(stand.highest)},
          {"tables", tables}};
}

}  // namespace

StandingEnds ends_of(const Simulation& possible, int candidate) {
  const RealPlacement& place = possible.placements[static_cast<std::size_t>(candidate)];
  const RealArtefact& artefact = possible.artefacts[static_cast<std::size_t>(place.artefact)];
  return {place.base_from_artefact * artefact.features.front().at,
          place.base_from_artefact * artefact.features.back().at};
}

Json to_json(const PlanResult& result) {
  Json json = result_head("plan");
  json["arm"] = result.plan.nominal.name;
  json["inputs"] = inputs_json(result.inputs);
  json["seed"] = result.options.seed;
  json["goal"] = result.options.goal == Goal::Worst ? "worst" : "mean";
  json["possible_placements"] = result.possible.placements.size();
  json["possible_readings"] = result.possible.recording.readings.size();
  json["stand"] = stand_json(result.plan.stand);
  json["measured_readings"] = result.measured_readings;
  json["free"] = Json::array();
  for (const Parameter& parameter : result.planning.free) {
    json["free"].push_back(parameter.name);
  }
  json["chosen"] = Json::array();
  for (const ChosenPlacement& chosen : result.planning.chosen) {
    json["chosen"].push_back(chosen_json(result, chosen));
  }
  if (result.planning.measured) {
    json["measured"] = expectation_json(*result.planning.measured);
  }
  json["planned"] = expectation_json(result.planning.planned);
  json["everything"] = expectation_json(result.planning.all);
  json["by_chance"] = {{"u_of_a_length", u_json(result.planning.random)},
                       {"u_of_the_arm", u_json(result.planning.random_of_arm)}};
  return json;
}

std::string to_text(const PlanResult& result) {
  const Planning& planning = result.planning;
  return fmt::format(
      "arm {}: {} of {} possible placements, {} readings of each feature, {}\n\n{}{}\n"
      "Standard uncertainty (k = 1, um) of a length anywhere in the volume, as the arm so identified will measure it,\n"
      "and what the readings tell of its {} parameters (O1 to O5, larger is better):\n\n{}\n"
      "Joint angles of the readings are in the JSON result and, with -o, in a table. Any posture near them will do.\n",
      in_quotes(truncated(60, result.plan.nominal.name)), planning.chosen.size(), result.possible.placements.size(),
      result.options.readings, prior_text(result), placements_text(result), dilution_text(result), planning.free.size(),
      expectations_text(result));
}

std::string to_csv(const PlanResult& result) {
  const Recording& recording = result.possible.recording;
  std::string text = "placement,artefact,feature";
  for (Eigen::Index i = 0; i < recording.joints.rows(); ++i) {
    text += fmt::format(",q{}", i + 1);
  }
  text += ",x_mm,y_mm,z_mm,turn_x_deg,turn_y_deg,turn_z_deg\n";
  for (const ChosenPlacement& chosen : result.planning.chosen) {
    const RealPlacement& place = result.possible.placements[static_cast<std::size_t>(chosen.candidate)];
    const auto& artefact = result.plan.artefacts[static_cast<std::size_t>(place.artefact)].certified;
    for (const int reading : chosen.readings) {
      text += fmt::format("{},{},{}", csv_field(place.name), csv_field(artefact.name),
                          csv_field(recording.features.name(recording.readings[reading].feature)));
      for (Eigen::Index i = 0; i < recording.joints.rows(); ++i) {
        const double unit = recording.arm.joints[static_cast<std::size_t>(i)].is_prismatic() ? 1.0 : units::degree;
        text += fmt::format(",{:.4f}", recording.joints(i, reading) / unit);
      }
      text += pose_cells(place.base_from_artefact);
      text += '\n';
    }
  }
  return text;
}

}  // namespace artcal
