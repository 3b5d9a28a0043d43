// Speed of the readers, in bytes of the file a second, against a plain read of the same file into memory. Files
// lie in the page cache: what a disk adds, it adds to both.
#include <algorithm>
#include <cstring>
#include <fstream>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "acquisition/point_cloud/point_cloud.h"
#include "acquisition/recording/readings_file.h"
#include "core/files/hash.h"
#include "core/random.h"
#include "core/units.h"
#include "tests/support/temporary_folder.h"

namespace artcal {
namespace {

constexpr std::size_t points = 10'000'000;
constexpr int readings = 200'000;

const testing::TemporaryFolder& folder() {
  static const testing::TemporaryFolder one;
  return one;
}

std::string pcd_header(const char* data, std::size_t count) {
  return fmt::format(
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
      "WIDTH {0}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {0}\nDATA {1}\n",
      count, data);
}

// 120 MB: ten million points of a random walk.
const std::filesystem::path& binary_pcd() {
  static const std::filesystem::path file = [] {
    std::string bytes = pcd_header("binary", points);
    const std::size_t start = bytes.size();
    bytes.resize(start + points * 12);
    RandomStream random(1, "reading benchmark");
    for (std::size_t i = 0; i < 3 * points; ++i) {
      const auto value = static_cast<float>(random.uniform(-1000.0, 1000.0));
      std::memcpy(bytes.data() + start + 4 * i, &value, 4);
    }
    return folder().write("binary.pcd", bytes);
  }();
  return file;
}

const std::filesystem::path& text_points() {
  static const std::filesystem::path file = [] {
    std::string text;
    RandomStream random(2, "reading benchmark");
    for (int i = 0; i < 1'000'000; ++i) {
      text += fmt::format("{:.4f} {:.4f} {:.4f}\n", random.uniform(-1000.0, 1000.0), random.uniform(-1000.0, 1000.0),
                          random.uniform(-1000.0, 1000.0));
    }
    return folder().write("points.xyz", text);
  }();
  return file;
}

const std::filesystem::path& csv() {
  static const std::filesystem::path file = [] {
    std::string text = "artefact,placement,feature,temperature,q1,q2,q3,q4,q5,q6\n";
    RandomStream random(3, "reading benchmark");
    for (int i = 0; i < readings; ++i) {
      text += fmt::format("bar,p{},{},20.{}", i / 1000, "ABCD"[i % 4], i % 10);
      for (int joint = 0; joint < 6; ++joint) {
        text += fmt::format(",{:.6f}", random.uniform(-180.0, 180.0));
      }
      text += '\n';
    }
    return folder().write("readings.csv", text);
  }();
  return file;
}

void count_bytes(benchmark::State& state, const std::filesystem::path& file) {
  state.SetBytesProcessed(static_cast<std::int64_t>(std::filesystem::file_size(file)) * state.iterations());
}

void plain_read(benchmark::State& state, const std::filesystem::path& (*file)()) {
  const auto& path = file();
  for (auto _ : state) {
    std::string bytes(std::filesystem::file_size(path), '\0');
    std::ifstream(path, std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    benchmark::DoNotOptimize(bytes.data());
  }
  count_bytes(state, path);
}
BENCHMARK_CAPTURE(plain_read, binary_pcd_10M, binary_pcd)->Unit(benchmark::kMillisecond);

// What every result rests on: the hash of its input.
void plain_read_and_hash(benchmark::State& state) {
  const auto& path = binary_pcd();
  for (auto _ : state) {
    std::string bytes(std::filesystem::file_size(path), '\0');
    std::ifstream(path, std::ios::binary).read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    benchmark::DoNotOptimize(sha256(bytes));
  }
  count_bytes(state, path);
}
BENCHMARK(plain_read_and_hash)->Unit(benchmark::kMillisecond);

void point_cloud(benchmark::State& state, const std::filesystem::path& (*file)()) {
  const auto& path = file();
  for (auto _ : state) {
    const auto cloud = read_point_cloud(path, {});
    if (!cloud) {
      state.SkipWithError("the points were refused");
    }
    benchmark::DoNotOptimize(cloud);
  }
  count_bytes(state, path);
}
BENCHMARK_CAPTURE(point_cloud, binary_pcd_10M, binary_pcd)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(point_cloud, text_1M, text_points)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plain_read, text_1M, text_points)->Unit(benchmark::kMillisecond);

void readings_csv(benchmark::State& state) {
  const auto& path = csv();
  Recording empty;
  empty.arm.joints.resize(6);
  empty.arm.probes.resize(1);
  for (auto _ : state) {
    Recording recording = empty;
    if (!read_readings(path, {units::degree, 1.0}, recording)) {
      state.SkipWithError("the readings were refused");
    }
    benchmark::DoNotOptimize(recording);
  }
  count_bytes(state, path);
}
BENCHMARK(readings_csv)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plain_read, readings_csv, csv)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace artcal
