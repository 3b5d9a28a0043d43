// How many simulated arms are found from how rough a start, by what was read: count_found_arms [SEEDS]. A table, and a
// line for each arm that was lost: refused, or worse, come back wrong.
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

#include "tests/support/programmes.h"

namespace artcal {
namespace {

constexpr double found_within = 0.05;  // mm rms of lengths in the volume; the noise alone gives some 0.005

struct Count {
  int found = 0;
  int wrong = 0;
};

Count count(std::size_t programme, testing::Difficulty difficulty, double ball_radius, int seeds) {
  Arm nominal = test::gao_arm();
  nominal.probes.front().radius = 3.0;
  IdentifyOptions options;
  options.leave_out = false;
  Count counted;
  for (int seed = 0; seed < seeds; ++seed) {
    const auto stream = static_cast<std::uint64_t>(seed);
    const Arm truth = testing::another_arm(nominal, difficulty, programme, stream);
    const test::Bound bound =
        testing::session_of(testing::programmes[programme], nominal, truth, 100 * programme + stream, ball_radius);
    const auto result = identify(bound.recording, bound.constraints, options);
    const double rms = result ? testing::length_rms(truth, result->arm) : 0.0;
    counted.found += result && rms < found_within ? 1 : 0;
    counted.wrong += rms >= found_within ? 1 : 0;
    if (rms >= found_within) {
      fmt::print("  seed {}: {:.3f} mm off\n", seed, rms);
      for (const std::string& warning : result->warnings) fmt::print("    warned: {}\n", warning);
    } else if (!result) {
      fmt::print("  seed {}: {}\n", seed, result.error().text().substr(0, 100));
    }
  }
  return counted;
}

}  // namespace
}  // namespace artcal

int main(int argc, char** argv) {
  using namespace artcal;
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 20;
  for (const double radius : {12.7, 6.0}) {
    for (const testing::Difficulty difficulty :
         {testing::Difficulty{0.3, 0.1}, {1.0, 0.5}, {3.0, 1.5}, {6.0, 3.0}, {10.0, 5.0}}) {
      for (std::size_t p = 0; p < testing::programmes.size(); ++p) {
        const Count counted = count(p, difficulty, radius, seeds);
        fmt::print("balls of {} mm, {} mm and {} deg, {}: {} of {} found, {} wrong\n", radius, difficulty.mm,
                   difficulty.degrees, testing::programmes[p].name, counted.found, seeds, counted.wrong);
        std::fflush(stdout);
      }
    }
  }
}
