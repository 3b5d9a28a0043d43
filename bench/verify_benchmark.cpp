// What a verification takes: 105 lengths (six balls, seven placements, three repeats), 25 points on each ball.
#include <benchmark/benchmark.h>

#include <fmt/format.h>

#include "artefacts/verification/verify.h"
#include "tests/support/reported_readings.h"

namespace {

using namespace artcal;

Artefact bar_of_six() {
  Artefact bar;
  bar.name = "bar";
  for (int i = 0; i < 6; ++i) {
    bar.features.push_back(testing::ball(fmt::format("{}", i), 25.0));
  }
  for (int i = 1; i < 6; ++i) {
    bar.distances.push_back({0, i, 200.0 * i, 0.4e-3});
  }
  return bar;
}

Recording lengths() {
  testing::ReportedReadings readings;
  RandomStream random(1, "verify_benchmark");
  for (int placement = 0; placement < 7; ++placement) {
    const Rigid base_from_bar{random.rotation(), 300.0 * random.direction()};
    for (int repeat = 0; repeat < 3; ++repeat) {
      for (int i = 0; i < 6; ++i) {
        readings.touch_ball({"bar", fmt::format("{}", placement), fmt::format("{}", i), "", fmt::format("{}", repeat)},
                            base_from_bar * Eigen::Vector3d(200.0 * i, 0.0, 0.0), 12.5, testing::pattern_25(), 0.01,
                            random);
      }
    }
  }
  return readings.recording();
}

// From readings in memory to 105 values and verdicts: binding, fits, lengths, budgets, completeness.
void verify_105_lengths(benchmark::State& state) {
  const Recording recording = lengths();
  const Specification by;
  for (auto _ : state) {
    const auto constraints = build_constraints(recording, {bar_of_six()});
    const auto tips = tip_centres(recording);
    const Session session{recording, *constraints, recording.arm, *tips, by};
    const auto result = verify(session, Standard::Iso10360_12);
    if (!result || result->verification.values.size() != 105) {
      state.SkipWithError("not 105 lengths");
    }
    benchmark::DoNotOptimize(result);
  }
}
BENCHMARK(verify_105_lengths)->Unit(benchmark::kMillisecond);

}  // namespace
