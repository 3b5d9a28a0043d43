// Every result against docs/result-schema.md: what is there is described, what is described is there.
#include <map>
#include <regex>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"
#include "tests/support/example_recording.h"

namespace artcal {
namespace {

using Json = nlohmann::json;

/// The tables of the documentation: by name of the table and of the field, the type.
using Schema = std::map<std::string, std::map<std::string, std::string>>;

Schema read_schema() {
  std::istringstream lines(testing::read_all(std::string(ARTCAL_SOURCE_DIR) + "/docs/result-schema.md"));
  const std::regex row("\\| `(\\w+)` \\| ([^|]+) \\|.*");
  Schema schema;
  std::string table;
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("## ")) {
      table = line.substr(3);
    } else if (std::regex_match(line, match, row)) {
      schema[table][match[1]] = match[2];
    }
  }
  return schema;
}

class ResultSchema : public testing::ProgramTest {
 protected:
  // Sentences about what differs from the type; `path` is where.
  void compare(const Json& json, const std::string& type, const std::string& path) {
    if (const auto bar = type.find(" or "); bar != std::string::npos) {
      compare(json, json.is_null() ? "null" : type.substr(0, bar), path);
    } else if (type == "text" || type == "number" || type == "integer" || type == "truth" || type == "null") {
      const bool fits = type == "text"     ? json.is_string()
                        : type == "number" ? json.is_number()
                        : type == "truth"  ? json.is_boolean()
                        : type == "null"   ? json.is_null()
                                           : json.is_number_integer();
      EXPECT_TRUE(fits) << path << " is no " << type << ": " << json.dump();
    } else if (type.front() == '[') {
      ASSERT_TRUE(json.is_array()) << path;
      for (const Json& element : json) {
        compare(element, type.substr(1, type.size() - 2), path + "[]");
      }
      seen_.insert(json.empty() ? "" : path);
    } else if (type.front() == '{') {
      ASSERT_TRUE(json.is_object()) << path;
      for (const Json& element : json) {
        compare(element, type.substr(1, type.size() - 2), path + "{}");
      }
    } else {
      ASSERT_TRUE(schema_.contains(type)) << path << ": no table \"" << type << "\"";
      compare_object(json, schema_.at(type), path);
    }
  }

  void compare_object(const Json& json, const std::map<std::string, std::string>& table, const std::string& path) {
    ASSERT_TRUE(json.is_object()) << path;
    for (const auto& [key, value] : json.items()) {
      EXPECT_TRUE(table.contains(key)) << path << "." << key << " is not described";
    }
    for (const auto& [key, described] : table) {
      const auto comma = described.find(", optional");
      if (json.contains(key)) {
        compare(json[key], described.substr(0, comma), path + "." + key);
      } else {
        EXPECT_NE(comma, std::string::npos) << path << "." << key << " is described, but absent";
      }
    }
  }

  void check(const std::vector<std::string>& command, const std::string& table, int exit_code = 0) {
    const testing::Ended ended = run(command);
    ASSERT_EQ(ended.exit_code, exit_code) << ended.err;
    compare(Json::parse(ended.out), table, table);
  }

  const Schema schema_ = read_schema();
  std::set<std::string> seen_;  // lists that held something
};

TEST_F(ResultSchema, OfIdentifications) {
  take("two-socket-bar");
  take("ball-bar");
  check({"identify", "two-socket-bar/recording.toml", "--json", "-"}, "identification");
  check({"identify", "two-socket-bar/recording.toml", "--json", "-", "--hold", "lx", "--no-leave-out"},
        "identification");
  for (const char* list :
       {"inputs", "parameters", "left_out", "left_out[].lengths", "outliers", "coupling.unidentifiable",
        "coupling.weak", "covariance.matrix", "options.hold", "after.lengths", "arm_shape.path_mm", "residuals.reading",
        "residuals.joints_rad", "residuals.offset_mm"}) {
    EXPECT_TRUE(seen_.contains(std::string("identification.") + list)) << list << " was always empty";
  }
  check({"identify", "ball-bar/recording.toml", "--json", "-"}, "identification");
  write("ball-bar/bar.toml",
        "type = \"ball bar\"\ncertificate = { number = \"1\", date = 2026-03-02 }\n" + text_of("ball-bar/bar.toml"));
  write("ball-bar/recording.toml", "date = 2026-03-10\n" + text_of("ball-bar/recording.toml"));
  check({"identify", "ball-bar/recording.toml", "--json", "-", "--no-leave-out"}, "identification");
}

TEST_F(ResultSchema, OfInspections) {
  take("ball-bar");
  take("sphere-plate");
  write("stream.toml",
        "schema = \"artcal-stream/1\"\nform = \"columns\"\njoints = [\"1\", \"2\", \"3\", \"4\", \"5\", \"6\"]\n"
        "xyz = [\"7\", \"8\", \"9\"]\nunits = { joint = \"deg\" }\n");
  write("events.csv",
        "10,20,30,40,50,60,0,0,0\nx\n90,20,30,40,50,60,1,0,0\n-90,20,30,40,50,60,2,0,0\n"
        "10,90,30,40,50,60,3,0,0\n");
  check({"record", "stream.toml", "--arm", "ball-bar/arm.toml", "--artefact", "ball-bar/bar.toml", "-o", "today",
         "--source", "events.csv", "--json", "-"},
        "record", 1);
  check({"inspect", "ball-bar/recording.toml", "--json", "-"}, "inspection");
  check({"inspect", "sphere-plate/recording.toml", "--json", "-"}, "inspection");
  write("ball-bar/recording.toml", "date = 1926-03-10\n" + text_of("ball-bar/recording.toml"));
  std::string readings = text_of("ball-bar/readings.csv");
  readings += readings.substr(readings.find('\n') + 1, 400);
  readings.resize(readings.rfind('\n') + 1);
  write("ball-bar/readings.csv", readings);
  check({"inspect", "ball-bar/recording.toml", "--json", "-"}, "inspection", 1);
  for (const char* list : {"findings", "remarks", "usage.joints"}) {
    EXPECT_TRUE(seen_.contains(std::string("inspection.") + list)) << list << " was always empty";
  }
}

TEST_F(ResultSchema, OfPlans) {
  take("ball-bar");
  check({"plan",
         "ball-bar/arm.toml",
         "--artefact",
         "ball-bar/bar.toml",
         "--placements",
         "2",
         "--readings",
         "6",
         "--possible",
         "6",
         "--postures",
         "8",
         "--measured",
         "ball-bar/recording.toml",
         "--encoder-noise",
         "2 arcsec",
         "--probing-noise",
         "3 um",
         "--json",
         "-"},
        "plan_result");
}

TEST_F(ResultSchema, OfSegmentations) {
  take("ball-bar-scan");
  check({"segment", "ball-bar-scan/scan.xyz", "--artefact", "ball-bar-scan/bar.toml", "--unit", "mm", "--json", "-"},
        "segmentation");
  for (const char* list : {"inputs", "spheres", "spheres[].rows", "distances", "rejected"}) {
    EXPECT_TRUE(seen_.contains(std::string("segmentation.") + list)) << list << " was always empty";
  }
  write("table.toml", text_of("ball-bar-scan/bar.toml") + "\n[[feature]]\nname = \"table\"\nkind = \"plane\"\n");
  check({"segment", "ball-bar-scan/scan.xyz", "--artefact", "table.toml", "--unit", "mm", "--json", "-"},
        "segmentation");
  EXPECT_TRUE(seen_.contains("segmentation.planes"));
}

TEST_F(ResultSchema, OfSimulations) {
  take("simulate");
  check({"simulate", "simulate/plan.toml", "-o", "made", "--json", "-"}, "simulation");
  for (const char* list : {"inputs", "parameters", "joints", "artefacts", "artefacts[].features", "placements"}) {
    EXPECT_TRUE(seen_.contains(std::string("simulation.") + list)) << list << " was always empty";
  }
  compare(Json::parse(text_of("made/truth.json")), "simulation", "truth");
}

TEST_F(ResultSchema, OfCouplings) {
  take("two-socket-bar");
  check({"coupling", "two-socket-bar/recording.toml", "--json", "-", "--free", "d7"}, "coupling_result");
  check({"coupling", "two-socket-bar/arm.toml", "--json", "-", "--kind", "point", "--readings", "60"},
        "coupling_result");
}

TEST_F(ResultSchema, OfEvaluations) {
  take("ball-bar");
  check({"evaluate", "ball-bar/recording.toml", "--json", "-"}, "evaluation_result");
  for (const char* list : {"inputs", "artefacts", "readings", "evaluation.lengths"}) {
    EXPECT_TRUE(seen_.contains(std::string("evaluation_result.") + list)) << list << " was always empty";
  }
}

TEST_F(ResultSchema, OfFits) {
  take("points");
  check({"fit", "points/ball.xyz", "--shape", "sphere", "--unit", "mm", "--diameter", "25.4 mm", "--tip-diameter",
         "6 mm", "--towards", "0,0,1", "--json", "-"},
        "fit");
  check({"fit", "points/ball.xyz", "--shape", "sphere", "--unit", "mm", "--criterion", "minimum-zone", "--json", "-"},
        "fit");
  check({"fit", "points/ball-scan.pcd", "--shape", "sphere", "--unit", "m", "--diameter", "25.4mm", "--noise", "20um",
         "--robust", "--json", "-"},
        "fit");
  for (const char* list : {"inputs", "values", "outliers", "warnings", "covariance.matrix", "options.towards"}) {
    EXPECT_TRUE(seen_.contains(std::string("fit.") + list)) << list << " was always empty";
  }
}

TEST_F(ResultSchema, OfUncertainties) {
  take("ball-bar");
  ASSERT_EQ(run({"identify", "ball-bar/recording.toml", "-o", "arm.toml", "--no-leave-out"}).exit_code, 0);
  check({"uncertainty", "arm.toml", "--json", "-", "--lengths", "5", "--rings", "2"}, "uncertainty_result");
  check({"uncertainty", "ball-bar/recording.toml", "--monte-carlo", "--trials", "50", "--model", "dh+gain", "--json",
         "-"},
        "monte_carlo");
}

TEST_F(ResultSchema, OfVerifications) {
  take("iso10360-12");
  take("sphere-plate");
  const std::vector<std::string> iso{"verify", "iso10360-12/recording.toml", "--standard", "iso10360-12"};
  const auto with = [](std::vector<std::string> command, const std::vector<std::string>& more) {
    command.insert(command.end(), more.begin(), more.end());
    return command;
  };
  ASSERT_EQ(run(with(iso, {"--json", "then.json", "--quiet"})).exit_code, 0);
  check(with(iso, {"--json", "-", "--against", "then.json"}), "verification");
  check({"verify", "iso10360-12/recording.toml", "--standard", "b89.4.22", "--json", "-"}, "verification", 1);
  check({"verify", "sphere-plate/recording.toml", "--standard", "sphere-plate", "--json", "-"}, "verification", 1);
  for (const char* list : {"inputs", "values", "plates", "plates[].balls", "interim.drifts", "missing", "warnings"}) {
    EXPECT_TRUE(seen_.contains(std::string("verification.") + list)) << list << " was always empty";
  }
}

TEST_F(ResultSchema, OfBatches) {
  take("gao2013");
  write("bad.toml", "schema = \"artcal-recording/1\"\n");
  check({"batch", "gao2013", "bad.toml", "--store", "s.sqlite", "--json", "-"}, "batch", 3);
}

TEST_F(ResultSchema, OfHistories) {
  take("two-socket-bar");
  take("iso10360-12");
  for (const char* example : {"two-socket-bar", "iso10360-12"}) {
    const std::string recording = std::string(example) + "/recording.toml";
    std::string text = text_of(recording);
    if (const auto own = text.find("\ndate = "); own != std::string::npos) {
      text.erase(own, text.find('\n', own + 1) - own);
    }
    write(std::string(example) + "/later-recording.toml", "date = 2030-01-01\n" + text);
  }
  // In 2030 the certificates have lapsed: conformity is not shown.
  ASSERT_EQ(run({"batch", "two-socket-bar", "iso10360-12", "--store", "s.sqlite"}).exit_code, 1);
  check({"history", "Franka Emika Panda", "--store", "s.sqlite", "--json", "-"}, "history");
  const Json verification = Json::parse(run({"verify", "iso10360-12/recording.toml", "--json", "-"}).out);
  check({"history", verification["arm"].get<std::string>(), "--store", "s.sqlite", "--json", "-"}, "history");
}

TEST_F(ResultSchema, OfReportedModels) {
  take("gao2013");
  check({"arm", "from-coordinates", "gao2013/recording.toml", "--json", "-"}, "reported_model");
}

TEST_F(ResultSchema, OfPoints) {
  take("ball-bar");
  check({"points", "ball-bar/recording.toml", "--json", "-"}, "points");
}

}  // namespace
}  // namespace artcal
