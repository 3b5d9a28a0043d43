// A folder with a file of each kind that other programs export: each goes in, and comes out as what was measured. The
// measured values are those of two examples; the files around them are written here, as each program writes its own.
#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.h"

namespace artcal {
namespace {

using testing::Ended;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using Json = nlohmann::json;
using Strings = std::vector<std::string>;

Strings split(const std::string& line, char separator) {
  Strings parts;
  std::istringstream stream(line);
  for (std::string part; std::getline(stream, part, separator);) {
    parts.push_back(part);
  }
  return parts;
}

std::vector<Strings> table(const std::string& text) {
  std::vector<Strings> rows;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    rows.push_back(split(line, ','));
  }
  return rows;
}

std::string with_comma(std::string number) {
  std::replace(number.begin(), number.end(), '.', ',');
  return number;
}

Strings joined(Strings one, const Strings& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

class ImportFolder : public testing::ProgramTest {
 protected:
  /// name, x, y, z of the first placement of the sphere plate.
  std::vector<Strings> touches_;

  ImportFolder() {
    take("sphere-plate");
    for (const Strings& row : table(text_of("sphere-plate/readings.csv"))) {
      if (row[0] == "1") {
        touches_.push_back({row[1], row[3], row[4], row[5]});
      }
    }
  }

  [[nodiscard]] std::string lines(const std::function<std::string(const Strings&)>& line) const {
    std::string text;
    for (const Strings& touch : touches_) {
      text += line(touch);
    }
    return text;
  }

  /// Test values, verdict and features of a recording of the plate.
  [[nodiscard]] Json verified(const std::string& recording) const {
    const Ended ended = run({"verify", recording, "--standard", "sphere-plate", "--specification",
                             "sphere-plate/specification.toml", "--json", "-"});
    EXPECT_TRUE(ended.exit_code == 0 || ended.exit_code == 1) << recording << ended.err;
    Json json = Json::parse(ended.out, nullptr, false);
    for (const char* of_the_file : {"inputs", "name", "recording", "warnings"}) {
      json.erase(of_the_file);
    }
    return json;
  }

  void expect_as_native(const std::string& file, const Strings& options) const {
    const std::string folder = "from " + file;
    const Ended made = run(joined({"import", file, "--artefact", "sphere-plate/plate.toml", "-o", folder}, options));
    ASSERT_EQ(made.exit_code, 0) << file << ": " << made.err;
    EXPECT_EQ(verified(folder + "/recording.toml"), verified("native/recording.toml")) << file;
  }
};

TEST_F(ImportFolder, CoordinatesOfEveryProgramAreVerifiedAlike) {
  ASSERT_GT(touches_.size(), 100u);
  write("native/readings.csv", "feature,x,y,z\n" + lines([](const Strings& t) {
                                 return fmt::format("{},{},{},{}\n", t[0], t[1], t[2], t[3]);
                               }));
  write("native/recording.toml",
        "schema = \"artcal-recording/1\"\nartefacts = [\"../sphere-plate/plate.toml\"]\nreadings = [\"readings.csv\"]\n"
        "units = { length = \"mm\" }\n[[probe]]\nradius = 3\n");
  const Strings tip{"--unit", "mm", "--probe-radius", "3 mm"};

  write("spreadsheet.csv", "\xEF\xBB\xBFName;X [mm];Y [mm];Z [mm]\r\n" + lines([](const Strings& t) {
                             return fmt::format("{};{};{};{}\r\n", t[0], with_comma(t[1]), with_comma(t[2]),
                                                with_comma(t[3]));
                           }));
  expect_as_native("spreadsheet.csv", tip);

  write("powerinspect.txt", lines([](const Strings& t) {
          return fmt::format("\"{}\" {} {} {} 0 0 1 0.0 -0.1 0.1 SP\n", t[0], t[1], t[2], t[3]);
        }));
  expect_as_native("powerinspect.txt", joined({"--columns", "name,x,y,z"}, tip));

  int number = 0;
  write("cam2.txt", "Session;today\n" + lines([&](const Strings& t) {
                      return fmt::format("{};{};{};{};{}\n", ++number, t[0], t[1], t[2], t[3]);
                    }));
  expect_as_native("cam2.txt", joined({"--skip", "1", "--columns", "-,name,x,y,z"}, tip));

  std::string dmis = "DMISMN/'plate',05.2\nUNITS/MM,ANGDEC\nPRCOMP/OFF\n";
  std::map<std::string, std::vector<Strings>> by_ball;
  Strings order;
  for (const Strings& touch : touches_) {
    order.insert(order.end(), by_ball.contains(touch[0]) ? 0 : 1, touch[0]);
    by_ball[touch[0]].push_back(touch);
  }
  std::string items, features, sets;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto& touches = by_ball[order[i]];
    dmis += fmt::format("F({0})=FEAT/SPHERE,OUTER,CART,0,0,0,22\nMEAS/SPHERE,F({0}),{1}\n", order[i], touches.size());
    std::string points;
    for (const Strings& t : touches) {
      dmis += fmt::format("PTMEAS/CART,{},{},$\n  {},0,0,1\n", t[1], t[2], t[3]);
      points += fmt::format("{} {} {}\n", t[1], t[2], t[3]);
    }
    dmis += "ENDMES\n";
    const std::size_t id = 10 * (i + 1);
    items +=
        fmt::format("<SphereFeatureItem id=\"{}\"><FeatureName>{}</FeatureName></SphereFeatureItem>\n", id, order[i]);
    features += fmt::format(
        "<SphereFeatureMeasurement id=\"{}\"><FeatureItemId>{}</FeatureItemId><PointList n=\"1\">"
        "<WholePointSetId>{}</WholePointSetId></PointList></SphereFeatureMeasurement>\n",
        id + 1, id, id + 2);
    sets += fmt::format(
        "<MeasuredPointSet id=\"{}\" count=\"{}\"><Points>{}</Points><Compensated>false</Compensated>"
        "<ProbeRadius>3</ProbeRadius></MeasuredPointSet>\n",
        id + 2, touches.size(), points);
  }
  write("program.dmo", dmis);
  expect_as_native("program.dmo", {"--measured-points", "--probe-radius", "3 mm"});

  write("results.qif",
        "<?xml version=\"1.0\"?>\n<QIFDocument xmlns=\"http://qifstandards.org/xsd/qif3\" versionQIF=\"3.0.0\">\n"
        "<FileUnits><PrimaryUnits><LinearUnit><SIUnitName>meter</SIUnitName><UnitName>mm</UnitName><UnitConversion>"
        "<Factor>0.001</Factor></UnitConversion></LinearUnit></PrimaryUnits></FileUnits>\n<Features><FeatureItems>\n" +
            items +
            "</FeatureItems></Features>\n<Results><MeasurementResultsSet><MeasurementResults "
            "id=\"1\"><MeasuredFeatures>\n" +
            features + "</MeasuredFeatures><MeasuredPointSets>\n" + sets +
            "</MeasuredPointSets></MeasurementResults></MeasurementResultsSet></Results></QIFDocument>\n");
  expect_as_native("results.qif", {});
}

// Fitted centres are what these programs report: balls of a plate as they are certified, moved by (500, -200, 300).
TEST_F(ImportFolder, FittedCentresAreVerifiedAlike) {
  write(
      "plate.toml",
      "schema = \"artcal-artefact/1\"\ntype = \"sphere plate\"\nunits = { length = \"mm\" }\n[uncertainty]\nat = { U = "
      "\"1 um\", k = 2 }\n[[feature]]\nname = \"A\"\nkind = \"point\"\nat = [0, 0, 0]\n[[feature]]\nname = \"B\"\nkind "
      "= "
      "\"point\"\nat = [100, 0, 0]\n[[feature]]\nname = \"C\"\nkind = \"point\"\nat = [0, 80, 5]\n");
  const std::vector<Strings> centres{
      {"A", "500", "-200", "300"}, {"B", "600", "-200", "300"}, {"C", "500", "-120", "305"}};
  std::string report, dmo = "UNITS/MM,ANGDEC\n", items, features;
  for (const Strings& c : centres) {
    report += fmt::format(
        "DIM L{0}= LOCATION OF SPHERE {0}  UNITS=MM ,$\nAX  NOMINAL  MEAS  DEV\nX 0.0 {1} 0.0\nY 0.0 {2} 0.0\nZ 0.0 "
        "{3} 0.0\n"
        "END OF DIMENSION L{0}\n",
        c[0], c[1], c[2], c[3]);
    dmo += fmt::format("F({0})=FEAT/SPHERE,OUTER,CART,0,0,0,22\nFA({0})=FEAT/SPHERE,OUTER,CART,{1},{2},{3},22.0003\n",
                       c[0], c[1], c[2], c[3]);
    items += fmt::format("<SphereFeatureItem id=\"{0}\"><FeatureName>{0}</FeatureName></SphereFeatureItem>", c[0]);
    features += fmt::format(
        "<SphereFeatureMeasurement id=\"m\"><FeatureItemId>{0}</FeatureItemId><Location>{1} {2} {3}"
        "</Location></SphereFeatureMeasurement>",
        c[0], c[1], c[2], c[3]);
  }
  write("report.txt", report);
  write("results.dmo", dmo);
  write("results.qif",
        "<QIFDocument "
        "versionQIF=\"3.0.0\"><FileUnits><PrimaryUnits><LinearUnit><SIUnitName>meter</SIUnitName><UnitName>mm"
        "</UnitName><UnitConversion><Factor>0.001</Factor></UnitConversion></LinearUnit></PrimaryUnits></"
        "FileUnits><Features>"
        "<FeatureItems>" +
            items + "</FeatureItems></Features><Results><MeasurementResultsSet><MeasurementResults><MeasuredFeatures>" +
            features + "</MeasuredFeatures></MeasurementResults></MeasurementResultsSet></Results></QIFDocument>");
  for (const std::string file : {"report.txt", "results.dmo", "results.qif"}) {
    const Ended made =
        run({"import", file, "--artefact", "plate.toml", "--probe-radius", "0 mm", "-o", "from " + file});
    ASSERT_EQ(made.exit_code, 0) << made.err;
    EXPECT_EQ(text_of("from " + file + "/readings.csv"),
              "feature,x,y,z\nA,500,-200,300\nB,600,-200,300\nC,500,-120,305\n");
    const Ended ended =
        run({"verify", "from " + file + "/recording.toml", "--standard", "sphere-plate", "--json", "-"});
    ASSERT_TRUE(ended.exit_code == 0 || ended.exit_code == 1) << file << ended.err;
    const Json values = Json::parse(ended.out).at("values");
    EXPECT_THAT(values, SizeIs(3)) << "the three distances";
    for (const Json& value : values) {
      EXPECT_NEAR(value.at("value_mm").get<double>(), 0.0, 1e-9) << value.dump();
    }
  }
}

TEST_F(ImportFolder, JointAnglesAreIdentifiedAlike) {
  take("two-socket-bar");
  std::string text;
  for (const Strings& row : table(text_of("two-socket-bar/readings.csv"))) {
    const bool is_header = row[0] == "placement";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string cell = is_header && i > 1 ? fmt::format("Joint {} (rad)", i - 1) : row[i];
      text += (i == 0 ? "" : "\t") + (is_header ? cell : with_comma(cell));
    }
    text += "\n";
  }
  write("robot.txt", text);
  const Ended made = run({"import", "robot.txt", "--artefact", "two-socket-bar/bar.toml", "--arm",
                          "two-socket-bar/arm.toml", "--joint-unit", "rad", "-o", "imported"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const auto result = [&](const std::string& folder) {
    const Ended ended = run({"identify", folder + "/recording.toml", "--no-leave-out"});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    const std::string said = ended.out.substr(ended.out.find('\n'));
    return std::regex_replace(said, std::regex(folder + "/"), "");  // places of readings
  };
  EXPECT_EQ(result("imported"), result("two-socket-bar"));
}

// One ball in every format of clouds; the fit is that of the text, whose points the example holds.
TEST_F(ImportFolder, CloudsOfEveryFormatAreFittedAlike) {
  take("points");
  std::vector<Strings> points;
  std::istringstream stream(text_of("points/ball.xyz"));
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    Strings row{std::istream_iterator<std::string>(words), {}};
    if (row.size() == 3 && row[0] != "#") {
      points.push_back(row);
    }
  }
  ASSERT_GT(points.size(), 4u);
  const auto all = [&](const std::function<std::string(const Strings&)>& line) {
    std::string text;
    for (const Strings& p : points) {
      text += line(p);
    }
    return text;
  };
  const std::string rows = all([](const Strings& p) { return fmt::format("{} {} {}\n", p[0], p[1], p[2]); });
  const std::size_t n = points.size();
  write("a.xyz", rows);
  write("a.pts", fmt::format("{}\n{}", n, rows));
  write("a.ptx", fmt::format("{}\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n{}", n, rows));
  write("a.obj", "# a mesh without faces\n" +
                     all([](const Strings& p) { return fmt::format("v {} {} {}\n", p[0], p[1], p[2]); }));
  write("a.ply",
        fmt::format("ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double "
                    "z\nend_header\n{}",
                    n, rows));
  write("a.pcd", fmt::format("VERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\nTYPE F F F\nWIDTH {0}\nHEIGHT 1\nPOINTS {0}\nDATA "
                             "ascii\n{1}",
                             n, rows));
  std::string stl = "solid ball\n";
  for (std::size_t i = 0; i < n; ++i) {
    stl += "facet normal 0 0 1\nouter loop\n";
    for (std::size_t k = 0; k < 3; ++k) {
      const Strings& p = points[(i + k) % n];
      stl += fmt::format("vertex {} {} {}\n", p[0], p[1], p[2]);
    }
    stl += "endloop\nendfacet\n";
  }
  write("a.stl", stl + "endsolid ball\n");
  const auto fitted = [&](const std::string& name) {
    const Ended ended = run({"fit", name, "--shape", "sphere", "--unit", "mm", "--json", "-"});
    EXPECT_EQ(ended.exit_code, 0) << name << ended.err;
    const Json json = Json::parse(ended.out, nullptr, false);
    Json values;
    for (const char* key : {"values", "covariance", "form_mm"}) {
      values[key] = json.at(key);
    }
    return values.dump();
  };
  const std::string expected = fitted("a.xyz");
  EXPECT_THAT(expected, HasSubstr("diameter"));
  for (const char* name : {"a.pts", "a.ptx", "a.obj", "a.stl", "a.ply", "a.pcd"}) {
    EXPECT_EQ(fitted(name), expected) << name;
  }
  for (const char* name : {"a.ptx", "a.obj", "a.stl", "a.ply", "a.pcd"}) {
    EXPECT_THAT(run({"import", name}).err, HasSubstr("the file is a point cloud (")) << name;
  }
}

}  // namespace
}  // namespace artcal
