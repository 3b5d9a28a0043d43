// What is told of single readings agrees with what is told of all of them, and with geometry.
#include "app/results/identification/readings_json.h"

#include <cmath>

#include <gmock/gmock.h>

#include "acquisition/recording/recording_file.h"
#include "app/results/identification/result_json.h"
#include "artefacts/constraints/bound_recording.h"
#include "identification/identify.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;
using ::testing::DoubleNear;
using ::testing::Le;

Json identified(const std::string& example) {
  const auto [recording, constraints] =
      bind_recording(
          read_recording(std::string(ARTCAL_SOURCE_DIR) + "/examples/" + example + "/recording.toml").value())
          .value();
  IdentifyOptions options;
  options.leave_out = false;
  const auto result = identify(recording, constraints, options).value();
  Json json = to_json(recording, constraints, options, result, {});
  json["residuals"] = residuals_json(recording, constraints, result);
  return json;
}

Eigen::Vector3d vector_of(const Json& columns, std::size_t i) {
  return {columns[0][i].get<double>(), columns[1][i].get<double>(), columns[2][i].get<double>()};
}
Eigen::Vector3d point_of(const Json& json) { return {json[0].get<double>(), json[1], json[2]}; }

double rms_of(const Json& values) {
  double squares = 0.0;
  for (const double value : values) {
    squares += value * value;
  }
  return std::sqrt(squares / static_cast<double>(values.size()));
}

// Where each tip should have been, less its feature's point or centre.
std::vector<Eigen::Vector3d> demanded_from_points(const Json& result) {
  const Json& residuals = result["residuals"];
  std::vector<Eigen::Vector3d> all;
  for (std::size_t i = 0; i < residuals["feature"].size(); ++i) {
    const Json& feature = result["after"]["features"][residuals["feature"][i].get<std::size_t>()];
    all.push_back(vector_of(residuals["tip_mm"], i) - vector_of(residuals["offset_mm"], i) -
                  point_of(feature["at_mm"]));
  }
  return all;
}

TEST(Residuals, MakeTheRmsOfTheResult) {
  const Json result = identified("two-socket-bar");
  for (const char* when : {"before", "after"}) {
    EXPECT_THAT(rms_of(result["residuals"][std::string(when) + "_mm"]),
                DoubleNear(result[when]["overall"]["rms_mm"], 1e-12));
  }
}

TEST(Residuals, LeadFromTheSocketToTheTip) {
  const Json result = identified("two-socket-bar");
  for (const Eigen::Vector3d& off : demanded_from_points(result)) {
    EXPECT_THAT(off.norm(), Le(1e-9));
  }
}

TEST(Residuals, LeadFromTheSurfaceOfTheBallToTheTip) {
  const Json result = identified("ball-bar");
  const Json& residuals = result["residuals"];
  const auto demanded = demanded_from_points(result);
  for (std::size_t i = 0; i < demanded.size(); ++i) {
    EXPECT_THAT(demanded[i].norm(), DoubleNear(12.7 + 3.0, 1e-6));  // radii of ball and tip
    EXPECT_THAT(vector_of(residuals["offset_mm"], i).norm(),
                DoubleNear(std::abs(residuals["after_mm"][i].get<double>()), 1e-9));
  }
}

TEST(ArmShape, GoesFromTheBaseToTheTip) {
  for (const char* example : {"two-socket-bar", "ball-bar"}) {  // modified and standard Denavit-Hartenberg
    const Json result = identified(example);
    const Json& shape = result["arm_shape"];
    const Json& residuals = result["residuals"];
    const auto of_reading = std::find(residuals["reading"].begin(), residuals["reading"].end(), shape["reading"]);
    const auto i = static_cast<std::size_t>(of_reading - residuals["reading"].begin());
    EXPECT_THAT(point_of(shape["path_mm"].front()).norm(), Le(1e-9)) << example;
    EXPECT_THAT((point_of(shape["path_mm"].back()) - vector_of(residuals["tip_mm"], i)).norm(), Le(1e-9)) << example;
    const std::size_t joints = residuals["joints_rad"].size();
    EXPECT_EQ(shape["path_mm"].size(), 2 * joints + 1) << example;
    // Along each joint's axis as far as its d says.
    for (std::size_t joint = 0; joint < joints; ++joint) {
      const std::string name = "d" + std::to_string(joint + 1);
      const Json& parameters = result["parameters"];
      const auto d =
          std::find_if(parameters.begin(), parameters.end(), [&](const Json& p) { return p["name"] == name; });
      const double step = (point_of(shape["path_mm"][2 * joint + 1]) - point_of(shape["path_mm"][2 * joint])).norm();
      EXPECT_THAT(step, DoubleNear(std::abs((*d)["identified"].get<double>()), 1e-9)) << example << " " << name;
    }
  }
}

TEST(Temperature, IsTheRangeThatWasRead) {
  Recording recording;
  recording.readings.resize(3);
  EXPECT_TRUE(temperature_json(recording).is_null());
  recording.readings[0].temperature = 21.5;
  recording.readings[2].temperature = 19.0;
  EXPECT_EQ(temperature_json(recording), (Json{{"lowest_C", 19.0}, {"highest_C", 21.5}}));
}

}  // namespace
}  // namespace artcal
