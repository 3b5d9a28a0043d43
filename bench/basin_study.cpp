// From how rough a nominal arm the solution is found: basin_study [SESSIONS] [SEED] [--list]
// A randomised design: for each kind of artefact and each roughness, SESSIONS sessions with stylus directions,
// placements, caps and noise drawn at random, identified by the library and by a plain Levenberg-Marquardt from the
// same start. Sessions with one reading under another feature's name are counted apart. The arm, the probing and the
// judging are tests/support/probing, which shares nothing with the library.
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include <fmt/format.h>

#include "identification/identify.h"
#include "tests/support/probing/outcome.h"
#include "tests/support/probing/plain_lm.h"

namespace artcal {
namespace {

using probing::Outcome;

struct Count {
  int sessions = 0, found = 0, refused = 0, wrong = 0;
  int plain = 0, plain_tried = 0;

  void add(Outcome outcome) {
    ++sessions;
    found += outcome == Outcome::Found ? 1 : 0;
    refused += outcome == Outcome::Refused ? 1 : 0;
    wrong += outcome == Outcome::Wrong ? 1 : 0;
  }
  [[nodiscard]] std::string row(const std::string& name) const {
    return fmt::format("| {} | {} | {} | {} | {} | {} |\n", name, sessions, found, refused, wrong,
                       plain_tried > 0 ? fmt::format("{} of {}", plain, plain_tried) : "–");
  }
};

template <typename Value, std::size_t size>
Value any(const Value (&values)[size], std::uint64_t& state) {
  state = state * 6364136223846793005ull + 1442695040888963407ull;
  return values[(state >> 33) % size];
}

void table(const char* heading, const std::map<std::string, Count>& counts) {
  fmt::print("\n| {} | sessions | found | refused | wrong | plain LM |\n|---|---|---|---|---|---|\n", heading);
  for (const auto& [name, count] : counts) {
    fmt::print("{}", count.row(name));
  }
}

void study(int sessions, std::uint64_t seed, bool list) {
  std::map<std::string, Count> by_kind, by_rough, by_stylus, by_placements, by_cap, by_noise, mislabelled;
  std::uint64_t state = seed * 2654435761u + 99;
  for (const double rough : {1.0, 2.0, 5.0, 10.0, 30.0}) {
    for (const probing::Kind kind : probing::all_kinds) {
      for (int i = 0; i < sessions; ++i) {
        probing::Probing asked;
        asked.kind = kind;
        asked.rough = rough;
        asked.stylus_within = any({10.0, 30.0, 60.0, 180.0}, state);
        asked.placements = any({4, 6, 8}, state);
        asked.cap = any({90.0, 60.0}, state);
        asked.noise = any({0.005, 0.015, 0.05}, state);
        const int labels[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
        asked.wrong_labels = kind == probing::Kind::Ball ? 0 : any(labels, state);
        asked.seed = seed + state % 1000003;
        const probing::Session session = probing::probe(asked);
        const probing::Bound bound = probing::bound(session, asked.noise);
        IdentifyOptions options;
        options.leave_out = false;
        const bool stated = any({true, true, false}, state);
        if (stated) {
          options.noise.reading = asked.noise;
        }
        const auto result = identify(bound.recording, bound.constraints, options);
        const Outcome outcome = probing::outcome(session, result);
        const std::string at = fmt::format("s = {:2g}, {}", rough, probing::name_of(kind));
        if (list && (outcome == Outcome::Wrong || (outcome == Outcome::Refused && asked.wrong_labels == 0))) {
          fmt::print("{}: stylus {}, placements {}, cap {}, noise {}, seed {}, wrong labels {}, noise {}: {}\n", at,
                     asked.stylus_within, asked.placements, asked.cap, asked.noise, asked.seed, asked.wrong_labels,
                     stated ? "stated" : "not stated",
                     result ? fmt::format("{:.3f} mm off, stated {:.3f}",
                                          probing::length_error(session.truth, probing::chain_of(result->arm)),
                                          probing::stated_length_error(*result))
                            : result.error().text().substr(0, 300));
          std::fflush(stdout);
        }
        if (asked.wrong_labels > 0) {
          mislabelled[at].add(outcome);
          continue;
        }
        Count& here = by_kind[at];
        here.add(outcome);
        if (i % 5 == 0 && probing::plain_lm_knows(session)) {
          // What the readings determine at all is judged by the library's result, as for the library itself.
          const double error = probing::length_error(session.truth, probing::plain_lm(session, asked.noise));
          ++here.plain_tried;
          here.plain += error < 0.05 || (result && error < 4.0 * probing::stated_length_error(*result)) ? 1 : 0;
        }
        if (rough <= 10.0) {
          by_stylus[fmt::format("stylus within {:3g} deg, s <= 10", asked.stylus_within)].add(outcome);
          by_noise[stated ? "noise stated, s <= 10" : "noise not stated, s <= 10"].add(outcome);
          by_placements[fmt::format("{} placements, s <= 10", asked.placements)].add(outcome);
          by_cap[fmt::format("cap of {} deg, s <= 10", asked.cap)].add(outcome);
          by_rough["s <= 10"].add(outcome);
        }
        by_rough[fmt::format("s = {:2g}", rough)].add(outcome);
      }
    }
  }
  table("roughness", by_rough);
  table("roughness, artefact", by_kind);
  table("stylus", by_stylus);
  table("placements", by_placements);
  table("cap", by_cap);
  table("noise", by_noise);
  table("one reading under another feature's name", mislabelled);
}

}  // namespace
}  // namespace artcal

int main(int argc, char** argv) {
  const int sessions = argc > 1 ? std::atoi(argv[1]) : 20;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  artcal::study(sessions, seed, argc > 3);
}
