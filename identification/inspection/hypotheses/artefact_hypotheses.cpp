#include "identification/inspection/hypotheses/artefact_hypotheses.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr double min_reach = 250.0;  // mm
constexpr double max_reach = 20'000.0;

struct OtherUnit {
  double factor;
  const char* text;  ///< what was really written
};
constexpr OtherUnit other_units[] = {{25.4, "inch"},
                                     {1.0 / 25.4, "mm, not inch"},
                                     {10.0, "cm"},
                                     {0.1, "mm, not cm"},
                                     {1000.0, "m (or mm, where um is stated)"},
                                     {0.001, "mm, not m (or um, where mm is stated)"},
                                     {0.001 * 25.4, "inch, not m"}};

void scale_distances(Artefact& artefact, double factor) {
  for (CertifiedDistance& distance : artefact.distances) {
    distance.value *= factor;
    distance.u *= factor;
    if (distance.stated) {
      distance.stated->value *= factor;
    }
  }
}

void scale_features(Artefact& artefact, double factor) {
  for (CertifiedFeature& feature : artefact.features) {
    if (feature.at) {
      *feature.at *= factor;
    }
    if (feature.radius) {
      *feature.radius *= factor;
    }
  }
}

void scale_arm(Arm& arm, double factor) {
  for (Joint& joint : arm.joints) {
    joint.a *= factor;
    joint.d *= factor;
  }
  for (Probe& probe : arm.probes) {
    probe.tip_in_last *= factor;
    probe.radius *= factor;
  }
}

void add_length_units(const Recording& recording, const std::vector<Artefact>& artefacts,
                      std::vector<Hypothesis>& hypotheses) {
  // Readings cannot tell a long arm from a short artefact; no arm is as short or as long as that.
  const double whole = reach(recording.arm);
  const bool is_arm = whole < min_reach || whole > max_reach;
  for (const OtherUnit& unit : other_units) {
    const double factor = unit.factor;
    for (std::size_t a = 0; a < artefacts.size() && !is_arm; ++a) {
      hypotheses.push_back(
          {FindingKind::LengthUnit, 0, artefact_path(recording, a),
           fmt::format("with the lengths of artefact {} taken for {}", in_quotes(artefacts[a].name), unit.text),
           "State the unit that the certificate has under units.length",
           [a, factor](Recording&, std::vector<Artefact>& changed) {
             scale_distances(changed[a], factor);
             scale_features(changed[a], factor);
           }});
      if (!artefacts[a].distances.empty()) {
        hypotheses.push_back(
            {FindingKind::LengthUnit, 0, artefact_path(recording, a),
             fmt::format("with the certified distances of artefact {} taken for {}", in_quotes(artefacts[a].name),
                         unit.text),
             "Give the distances in the file's unit",
             [a, factor](Recording&, std::vector<Artefact>& changed) { scale_distances(changed[a], factor); }});
      }
    }
    if (is_arm && factor * whole >= min_reach && factor * whole <= max_reach) {
      hypotheses.push_back({FindingKind::LengthUnit, 0, "",
                            fmt::format("with the lengths of the arm's file taken for {}", unit.text),
                            "State the unit of the arm's file under units.length",
                            [factor](Recording& changed, std::vector<Artefact>&) { scale_arm(changed.arm, factor); }});
    }
  }
}

// Whether the distances lead from one feature to the next and grow: what positions look like when they are taken for
// steps.
bool may_be_positions(const Artefact& artefact) {
  if (artefact.distances.size() < 2) {
    return false;
  }
  for (std::size_t d = 1; d < artefact.distances.size(); ++d) {
    const CertifiedDistance& before = artefact.distances[d - 1];
    const CertifiedDistance& distance = artefact.distances[d];
    if (distance.first != before.second || !(distance.value > before.value)) {
      return false;
    }
  }
  return true;
}

void add_positions(const Recording& recording, const std::vector<Artefact>& artefacts,
                   std::vector<Hypothesis>& hypotheses) {
  for (std::size_t a = 0; a < artefacts.size(); ++a) {
    const Artefact& artefact = artefacts[a];
    if (!may_be_positions(artefact)) {
      continue;
    }
    double whole = 0.0;
    for (const CertifiedDistance& distance : artefact.distances) {
      whole += distance.value;
    }
    const auto& names = artefact.features;
    const std::string first = in_quotes(names[static_cast<std::size_t>(artefact.distances.front().first)].name);
    const std::string last = in_quotes(names[static_cast<std::size_t>(artefact.distances.back().second)].name);
    hypotheses.push_back(
        {FindingKind::PositionsAsSteps, 0, artefact_path(recording, a),
         fmt::format("with the distances of artefact {}, as certified {:.7g} mm from {} to {} in all, taken for "
                     "positions from {}, {:.7g} mm in all",
                     in_quotes(artefact.name), whole, first, last, first, artefact.distances.back().value),
         "State them as positions, or the differences as steps", [a](Recording&, std::vector<Artefact>& changed) {
           double before = 0.0;
           for (CertifiedDistance& distance : changed[a].distances) {
             const double position = distance.value;
             distance.value -= before;
             if (distance.stated) {
               distance.stated->value -= before;
             }
             before = position;
           }
         }});
  }
}

bool has_balls(const Artefact& artefact) {
  return std::any_of(artefact.features.begin(), artefact.features.end(),
                     [](const CertifiedFeature& feature) { return feature.radius.value_or(0.0) > 0.0; });
}

}  // namespace

std::vector<Hypothesis> length_hypotheses(const Recording& recording, const std::vector<Artefact>& artefacts) {
  std::vector<Hypothesis> hypotheses;
  add_length_units(recording, artefacts, hypotheses);
  add_positions(recording, artefacts, hypotheses);
  return hypotheses;
}

std::vector<Hypothesis> radius_hypotheses(const Recording& recording, const std::vector<Artefact>& artefacts) {
  std::vector<Hypothesis> hypotheses;
  for (const double factor : {0.5, 2.0}) {
    const char* given = factor < 1.0 ? "diameter" : "half the radius";
    for (std::size_t p = 0; p < recording.arm.probes.size(); ++p) {
      const Probe& probe = recording.arm.probes[p];
      if (probe.radius > 0.0) {
        hypotheses.push_back(
            {FindingKind::TipRadius, 0, "",
             fmt::format("with a radius of {:.6g} mm for the tip of probe {}, as if {:.6g} mm were its {}",
                         factor * probe.radius, in_quotes(probe.name), probe.radius, given),
             "Correct `radius` in the arm's file: it is half the diameter of the tip's ball",
             [p, factor](Recording& changed, std::vector<Artefact>&) { changed.arm.probes[p].radius *= factor; }});
      }
    }
    for (std::size_t a = 0; a < artefacts.size(); ++a) {
      if (has_balls(artefacts[a])) {
        hypotheses.push_back({FindingKind::BallDiameter, 0, artefact_path(recording, a),
                              fmt::format("with balls of {} {} of the stated diameter", in_quotes(artefacts[a].name),
                                          factor < 1.0 ? "half" : "twice"),
                              "Correct `diameter` in the artefact's file",
                              [a, factor](Recording&, std::vector<Artefact>& changed) {
                                for (CertifiedFeature& feature : changed[a].features) {
                                  if (feature.radius) {
                                    *feature.radius *= factor;
                                  }
                                }
                              }});
      }
    }
  }
  return hypotheses;
}

std::vector<Hypothesis> free_radius_hypotheses(const Constraints& constraints) {
  const auto& features = constraints.features;
  const bool balls = std::any_of(features.begin(), features.end(), [](const FeatureConstraint& feature) {
    const auto* ball = feature.as<OnBall>();
    return ball != nullptr && ball->radius;
  });
  if (!balls) {
    return {};
  }
  std::vector<Hypothesis> hypotheses;
  for (const double start : {0.0, 3.0}) {  // mm beside what is stated: where a tip of no radius may begin
    hypotheses.push_back({FindingKind::TipRadius,
                          1,
                          "",
                          "",
                          "",
                          [start](Recording& changed, std::vector<Artefact>&) {
                            for (Probe& probe : changed.arm.probes) {
                              probe.radius += start;
                            }
                          },
                          {ParameterGroup::Radius}});
  }
  return hypotheses;
}

}  // namespace artcal
