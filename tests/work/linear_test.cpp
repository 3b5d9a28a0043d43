// Twice as much input takes twice the steps, whatever is in it: each kind of input that took the square once, and its
// like. A little more is for sorting and for tables of hashes.
#include <functional>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "acquisition/point_cloud/point_cloud.h"
#include "acquisition/recording/recording_file.h"
#include "app/output/json_file.h"
#include "artefacts/artefact/artefact_file.h"
#include "artefacts/dcc/dcc_read.h"
#include "artefacts/dcc/dcc_select.h"
#include "core/toml/toml_document.h"
#include "tests/support/temporary_folder.h"
#include "tests/work/step_count.h"

namespace artcal {
namespace {

constexpr double max_growth = 2.4;  // of the steps, where the input doubles

std::string repeated(int count, const std::function<std::string(int)>& piece, const std::string& between = "") {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += (i > 0 ? between : "") + piece(i);
  }
  return text;
}

std::string same(int count, const std::string& piece) {
  return repeated(count, [&](int) { return piece; });
}

class Linear : public ::testing::Test {
 protected:
  /// Steps that a reader takes for a file with this text.
  std::uint64_t steps(const std::string& name, const std::string& text,
                      const std::function<void(const std::filesystem::path&)>& read) const {
    const auto path = folder_.write(name, text);
    const std::uint64_t before = testing::step_count();
    read(path);
    return testing::step_count() - before;
  }
  void expect_linear(const std::string& name, int count, const std::function<std::string(int)>& text,
                     const std::function<void(const std::filesystem::path&)>& read) const {
    const auto once = steps(name, text(count), read);
    const auto twice = steps(name, text(2 * count), read);
    EXPECT_GT(once, static_cast<std::uint64_t>(count)) << "the steps are counted";
    EXPECT_LT(static_cast<double>(twice), max_growth * static_cast<double>(once))
        << once << " steps for " << count << ", " << twice << " for twice that";
  }
  testing::TemporaryFolder folder_;
};

void read_toml(const std::filesystem::path& path) { (void)TomlDocument::read(path, "artcal-recording/1"); }
void read_dcc_of(const std::filesystem::path& path) {
  if (const auto certificate = read_dcc_file(path)) {
    (void)find_quantity(*certificate, "none");
  }
}
void read_json(const std::filesystem::path& path) { (void)parse_json(read_text_file(path)->text, "result", "r.json"); }
void read_cloud(const std::filesystem::path& path) { (void)read_point_cloud(path, {1.0, 1.0}); }

TEST_F(Linear, RunsOfQuotesInToml) {
  for (const char* quote : {"\"", "'"}) {
    expect_linear(
        "x.toml", 20'000, [&](int count) { return "x = " + same(count, quote); }, read_toml);
    expect_linear(
        "x.toml", 20'000, [&](int count) { return "x = a" + same(count, quote); }, read_toml);
  }
}

TEST_F(Linear, TablesKeysAndArraysInToml) {
  expect_linear(
      "x.toml", 2'000, [](int count) { return same(count, "[[feature]]\nname = \"a\"\n"); }, read_toml);
  expect_linear(
      "x.toml", 2'000, [](int count) { return "x = [" + same(count, "[1, 2], ") + "]\n"; }, read_toml);
  expect_linear(
      "x.toml", 2'000, [](int count) { return repeated(count, [](int i) { return fmt::format("k{} = 1\n", i); }); },
      read_toml);
  expect_linear(
      "x.toml", 4'000, [](int count) { return same(count, "# a comment\n"); }, read_toml);
}

TEST_F(Linear, ColumnsOfATable) {
  const auto arm =
      folder_.write("arm.toml",
                    "schema = \"artcal-arm/1\"\nname = \"a\"\nconvention = \"standard\"\nunits = { length = "
                    "\"mm\", angle = \"deg\" }\n[[joint]]\na = 1\nd = 0\ntheta = 0\nalpha = 0\n[[probe]]\n"
                    "l = 1\nradius = 1\n");
  const auto recording = folder_.write("recording.toml",
                                       "schema = \"artcal-recording/1\"\narm = \"arm.toml\"\nartefacts = [\"b.toml\"]\n"
                                       "readings = [\"r.csv\"]\nunits = { joint = \"deg\", length = \"mm\" }\n");
  expect_linear(
      "r.csv", 2'000,
      [](int count) {
        return "feature,q1" + repeated(count, [](int i) { return fmt::format(",x-{}", i); }) + "\nA,1" +
               same(count, ",") + "\n";
      },
      [&](const auto&) { (void)read_recording(recording); });
  expect_linear(
      "r.csv", 2'000,
      [](int count) {
        return "feature,placement,q1\n" + repeated(count, [](int i) { return fmt::format("F{0},P{0},1\n", i); });
      },
      [&](const auto&) { EXPECT_TRUE(read_recording(recording)); });
}

TEST_F(Linear, QuantitiesOfACertificate) {
  const auto certificate = [](int count) {
    return "<d:digitalCalibrationCertificate xmlns:d=\"https://ptb.de/dcc\" schemaVersion=\"3.3.0\">"
           "<d:administrativeData><d:coreData><d:endPerformanceDate>2026-03-02</d:endPerformanceDate></d:coreData>"
           "</d:administrativeData><d:measurementResults><d:measurementResult><d:results><d:result><d:data>" +
           repeated(count,
                    [](int i) {
                      return fmt::format(
                          "<d:quantity id=\"q{}\">\n<real><value>1</value>\n<unit>\\metre</unit></real></d:quantity>\n",
                          i);
                    }) +
           "</d:data></d:result></d:results></d:measurementResult></d:measurementResults>"
           "</d:digitalCalibrationCertificate>";
  };
  expect_linear("c.xml", 1'000, certificate, read_dcc_of);
}

TEST_F(Linear, WhatIsWrongInACertificate) {
  const auto many = [](const std::string& piece) {
    return [piece](int count) {
      return "<d:digitalCalibrationCertificate xmlns:d=\"https://ptb.de/dcc\" schemaVersion=\"3.3.0\">"
             "<d:administrativeData><d:coreData><d:endPerformanceDate>2026-03-02</d:endPerformanceDate></d:coreData>"
             "</d:administrativeData><d:measurementResults><d:measurementResult><d:results><d:result><d:data>" +
             same(count, piece) +
             "</d:data></d:result></d:results></d:measurementResult></d:measurementResults>"
             "</d:digitalCalibrationCertificate>";
    };
  };
  expect_linear("c.xml", 1'000, many("<d:quantity id=\"q\">\n<real><value>x</value></real></d:quantity>\n"),
                read_dcc_of);
  expect_linear(
      "c.xml", 1'000,
      [&](int count) {
        return many("<d:quantity><real><value>" + same(count, "1<!-- a -->") + "</value></real></d:quantity>")(1);
      },
      read_dcc_of);
  expect_linear(
      "c.xml", 1'000,
      [&](int count) {
        return many("<d:quantity>" + same(count, "<d:name><d:content>a</d:content></d:name>") + "</d:quantity>")(1);
      },
      read_dcc_of);
  expect_linear(
      "c.xml", 1'000,
      [&](int count) {
        return many("<d:quantity><d:name>" +
                    repeated(count, [](int i) { return fmt::format("<d:content>{}</d:content>", i); }) +
                    "</d:name></d:quantity>")(1);
      },
      read_dcc_of);
}

TEST_F(Linear, ObjectsAndArraysInJson) {
  expect_linear(
      "r.json", 200,
      [](int count) {
        return "[" +
               repeated(
                   count, [](int) { return same(50, "{\"a\":") + "1" + same(50, ",\"b\":1,\"c\":1}"); }, ",") +
               "]";
      },
      read_json);
  expect_linear(
      "r.json", 2'000,
      [](int count) {
        return "{" +
               repeated(
                   count, [](int i) { return fmt::format("\"k{}\":[{}]", i, i); }, ",") +
               "}";
      },
      read_json);
}

TEST_F(Linear, FieldsAndPointsOfClouds) {
  expect_linear(
      "a.pcd", 2'000,
      [](int count) {
        const std::string more = repeated(count, [](int i) { return fmt::format(" f{}", i); });
        return "VERSION 0.7\nFIELDS x y z" + more + "\nSIZE 4 4 4" + same(count, " 4") + "\nTYPE F F F" +
               same(count, " F") + "\nWIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3" + same(count, " 0") + "\n";
      },
      read_cloud);
  expect_linear(
      "a.ply", 2'000,
      [](int count) {
        return "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\n" +
               repeated(count, [](int i) { return fmt::format("property float f{}\n", i); }) + "end_header\n1 2 3" +
               same(count, " 0") + "\n4 5 6" + same(count, " 0") + "\n";
      },
      read_cloud);
  expect_linear(
      "a.ply", 2'000,
      [](int count) {
        return "ply\nformat ascii 1.0\n" + repeated(count, [](int i) { return fmt::format("element e{} 0\n", i); }) +
               "element vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n1 2 3\n4 5 6\n";
      },
      read_cloud);
  expect_linear(
      "a.xyz", 2'000,
      [](int count) {
        return "x,y,z" + repeated(count, [](int i) { return fmt::format(",f{}", i); }) + "\n1,2,3" + same(count, ",0") +
               "\n4,5,6" + same(count, ",0") + "\n";
      },
      read_cloud);
  expect_linear(
      "a.xyz", 5'000, [](int count) { return same(count, "1 2 3\n") + "4 5 6\n"; }, read_cloud);
}

TEST_F(Linear, RulesOfUncertainties) {
  expect_linear(
      "a.toml", 5'000,
      [](int count) {
        return "schema = \"artcal-artefact/1\"\nunits = { length = \"mm\" }\n[uncertainty]\nat = { rule = \"" +
               same(count, "*") + "\", a = \"1 um\", b = \"1 um/m\", k = 2 }\n";
      },
      [](const auto& path) { (void)read_artefact_file(path); });
}

}  // namespace
}  // namespace artcal
