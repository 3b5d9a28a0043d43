#include "app/results/uncertainty/recorded_uncertainty.h"

#include <gtest/gtest.h>

#include "app/results/uncertainty/recorded_monte_carlo.h"

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

template <typename Read>
std::string refusal(const Json& json, Read&& read) {
  try {
    (void)read(RecordedObject(json));
  } catch (const NotAsInSchema& reason) {
    return reason.what();
  }
  return "read";
}

// As docs/result-schema.md has them.
const char* const uncertainty = R"({"probe": "tip", "encoder_noise_rad": 1e-5, "probing_noise_mm": 0.003,
  "lengths": [{"length_mm": 500, "u": {"count": 3, "rms_mm": 0.01, "quantile_95_mm": 0.02, "maximum_mm": 0.03},
               "u_of_the_arm": {"count": 3, "rms_mm": 0.004, "quantile_95_mm": 0.005, "maximum_mm": 0.006}}],
  "sphere_diameter": {"count": 0, "rms_mm": 0, "quantile_95_mm": 0, "maximum_mm": 0},
  "map": [{"from_axis_mm": 100, "height_mm": -200,
           "u_of_a_point": {"count": 7, "rms_mm": 0.07, "quantile_95_mm": 0.08, "maximum_mm": 0.09}}]})";

TEST(RecordedUncertainty, HasLengthsASphereAndAMap) {
  const Json json = Json::parse(uncertainty);
  const RecordedUncertainty read = recorded_uncertainty(RecordedObject(json));
  EXPECT_EQ(read.probe, "tip");
  EXPECT_EQ(read.encoder, 1e-5);
  EXPECT_EQ(read.probing, 0.003);
  ASSERT_EQ(read.volume.lengths.size(), 1u);
  EXPECT_EQ(read.volume.lengths[0].u.maximum, 0.03);
  EXPECT_EQ(read.volume.lengths[0].u_of_arm.quantile_95, 0.005);
  EXPECT_EQ(read.volume.sphere_diameter.count, 0);
  ASSERT_EQ(read.volume.map.size(), 1u);
  EXPECT_EQ(read.volume.map[0].height, -200.0);
  EXPECT_EQ(read.volume.map[0].u.rms, 0.07);
}

TEST(RecordedUncertainty, IsRefusedByThePlaceOfWhatIsWrong) {
  Json json = Json::parse(uncertainty);
  json["map"][0]["u_of_a_point"]["count"] = 1e30;
  EXPECT_EQ(refusal(json, recorded_uncertainty), "map[0].u_of_a_point.count is 1e+30, expected a whole number");
  json = Json::parse(uncertainty);
  json["lengths"] = "none";
  EXPECT_EQ(refusal(json, recorded_uncertainty), "lengths is a text, expected a list");
}

const char* const monte_carlo = R"({"seed": 18446744073709551615, "model": "dh",
  "options": {"noise": {"reading_mm": null, "encoder_rad": 1e-5, "probing_mm": 0.003}, "probe": "tip", "digits": 2},
  "trials": {"made": 1000, "not_converged": 1, "complete": true}, "warnings": ["the bar is warm"],
  "quantities": [
    {"kind": "parameter", "name": "d3", "unit": "mm", "estimate": 100, "u_first_order": 0.03, "u": 0.04,
     "interval_95": [99.9, 100.3], "stable": true, "differs_from_first_order": true},
    {"kind": "L_Dia", "name": "1", "unit": "mm", "estimate": 0, "u_first_order": null, "u": 0.009,
     "interval_95": null, "stable": false, "differs_from_first_order": false}]})";

TEST(RecordedMonteCarlo, HasItsQuantities) {
  const Json json = Json::parse(monte_carlo);
  const RecordedMonteCarlo read = recorded_monte_carlo(RecordedObject(json));
  EXPECT_EQ(read.seed, 18446744073709551615u);
  EXPECT_FALSE(read.noise.reading);
  EXPECT_EQ(read.noise.encoder, 1e-5);
  EXPECT_EQ(read.trials, 1000u);
  EXPECT_TRUE(read.is_complete);
  ASSERT_EQ(read.quantities.size(), 2u);
  EXPECT_TRUE(read.quantities[0].is_parameter());
  EXPECT_EQ(read.quantities[0].interval_95->high, 100.3);
  EXPECT_FALSE(read.quantities[1].u_first_order || read.quantities[1].interval_95 || read.quantities[1].is_stable);
}

TEST(RecordedMonteCarlo, IsRefusedByThePlaceOfWhatIsWrong) {
  Json json = Json::parse(monte_carlo);
  json["quantities"][1]["interval_95"] = {1.0, 2.0, 3.0};
  EXPECT_EQ(refusal(json, recorded_monte_carlo), "quantities[1].interval_95 is a list of 3, expected two numbers");
  json = Json::parse(monte_carlo);
  json["trials"]["made"] = -1;
  EXPECT_EQ(refusal(json, recorded_monte_carlo), "trials.made is -1, expected a whole number, 0 or more");
  json = Json::parse(monte_carlo);
  json["options"]["noise"].erase("encoder_rad");
  EXPECT_EQ(refusal(json, recorded_monte_carlo), "read") << "a noise that was not stated";
}

}  // namespace
}  // namespace artcal
