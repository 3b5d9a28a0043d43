#include "artefacts/verification/decision/completeness.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "acquisition/recording/tip_centres.h"
#include "artefacts/verification/iso10360_12/sphere_tests.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// Touches nearer to each other than this share of the radius (0.3 mm on a ball of 25 mm) are one touch: hands that try
// to repeat a place miss it by more, and an arm that stands still by less.
constexpr double one_place = 0.02;
constexpr std::size_t most_listed = 20;  // of the same kind; nobody reads a thousand lines of what is missing

using Length = std::pair<std::string, std::string>;
/// By placement: how often each length was measured there.
using Measured = std::map<std::string, std::map<Length, int>>;

Length sorted(const Length& length) { return std::minmax(length.first, length.second); }

Measured measured_lengths(const Verification& verification) {
  Measured measured;
  for (const TestValue& value : verification.values) {
    if (value.quantity == Quantity::LengthUni || value.quantity == Quantity::LengthBi) {
      ++measured[value.placement][sorted({value.first, value.second})];
    }
  }
  return measured;
}

std::string plural(int count, const char* noun) { return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s"); }

void check_repeats(const std::string& placement, const Length& length, int repeats, int wanted,
                   std::vector<std::string>& missing) {
  if (repeats < wanted) {
    missing.push_back(fmt::format("placement {}, {} - {}: {} of {} repeats", in_quotes(placement), length.first,
                                  length.second, repeats, wanted));
  }
}

void check_named(const TestPlan& plan, const Measured& measured, std::vector<std::string>& missing) {
  for (const PlannedPosition& position : plan.named) {
    const auto there = measured.find(position.placement);
    if (there == measured.end()) {
      missing.push_back(fmt::format("placement {}: no length was measured there", in_quotes(position.placement)));
      continue;
    }
    for (const Length& length : position.lengths) {
      const auto repeats = there->second.find(sorted(length));
      check_repeats(position.placement, length, repeats == there->second.end() ? 0 : repeats->second, plan.repeats,
                    missing);
    }
  }
}

void check_longest(const Session& session, const Verification& verification, std::vector<std::string>& missing) {
  const double share = session.specification.plan->longest_share;
  if (share == 0.0) {
    return;
  }
  if (!session.specification.measuring_range) {
    missing.push_back("the specification states no measuring_range to hold the longest length against");
    return;
  }
  double longest = 0.0;
  for (const TestValue& value : verification.values) {
    longest = std::max(longest, value.certified);
  }
  if (longest < share * *session.specification.measuring_range) {
    missing.push_back(
        fmt::format("the longest length is {:.1f} mm, {:.0f} % of the measuring range; {:.0f} % are asked for", longest,
                    100.0 * longest / *session.specification.measuring_range, 100.0 * share));
  }
}

void add_some(std::vector<std::string> found, std::vector<std::string>& missing) {
  if (found.size() > most_listed) {
    const std::size_t more = found.size() - most_listed;
    found.resize(most_listed);
    found.push_back(fmt::format("and {} more of this kind", more));
  }
  missing.insert(missing.end(), found.begin(), found.end());
}

// Touches of a ball at places of their own, counted up to `wanted`.
int distinct_touches(const Session& session, const Touched& touched, int wanted) {
  const CertifiedFeature& ball = session.constraints.artefacts[touched.artefact].features[touched.feature];
  const double radius =
      ball.radius.value_or(0.0) + tip_radius(session.recording, touched.readings.front(), session.arm);
  std::vector<Eigen::Vector3d> places;
  for (const int reading : touched.readings) {
    const Eigen::Vector3d tip = session.tips.in_base.col(reading);
    const bool is_new = std::none_of(places.begin(), places.end(), [&](const Eigen::Vector3d& place) {
      return (tip - place).norm() < one_place * radius;
    });
    if (is_new) {
      places.push_back(tip);
    }
    if (static_cast<int>(places.size()) >= wanted) {
      break;
    }
  }
  return static_cast<int>(places.size());
}

}  // namespace

void check_length_plan(const Session& session, Verification& verification) {
  if (!session.specification.plan) {
    verification.missing.push_back("the specification has no [plan]: whether enough was measured cannot be determined");
    return;
  }
  const TestPlan& plan = *session.specification.plan;
  const Measured measured = measured_lengths(verification);
  std::vector<std::string> found;
  int complete = 0;
  for (const auto& [placement, lengths] : measured) {
    int enough = 0;
    std::vector<std::string> here;
    for (const auto& [length, repeats] : lengths) {
      enough += repeats >= plan.repeats ? 1 : 0;
      check_repeats(placement, length, repeats, plan.repeats, here);
    }
    if (enough < plan.lengths) {
      found.push_back(fmt::format("placement {}: {} of {} with all their repeats", in_quotes(placement),
                                  plural(enough, "length"), plan.lengths));
      found.insert(found.end(), here.begin(), here.end());
    } else {
      ++complete;
    }
  }
  if (complete < plan.positions) {
    found.insert(found.begin(),
                 fmt::format("lengths: {} of {} complete", plural(complete, "position"), plan.positions));
  }
  check_named(plan, measured, found);
  check_longest(session, verification, found);
  add_some(std::move(found), verification.missing);
}

void check_sphere_plan(const Session& session, Verification& verification) {
  if (!session.specification.plan) {
    return;  // said for the lengths
  }
  const TestPlan& plan = *session.specification.plan;
  std::set<std::pair<int, int>> size_positions, location_positions;
  std::map<std::tuple<int, int, int>, int> orientations;
  std::vector<std::string> found;
  for (const Touched& touched : touched_features(session, Orientations::Apart)) {
    if (!is_single_ball(session.constraints.artefacts[touched.artefact])) {
      continue;
    }
    const bool articulated = !session.recording.orientations.name(touched.orientation).empty();
    const int wanted = articulated ? plan.points_per_orientation : plan.points;
    const auto place = std::pair{touched.artefact, touched.placement};
    const std::string where =
        fmt::format("ball, placement {}", in_quotes(session.recording.placements.name(touched.placement)));
    if (const int points = distinct_touches(session, touched, wanted); points < wanted) {
      const std::string of =
          articulated
              ? fmt::format(", orientation {}", in_quotes(session.recording.orientations.name(touched.orientation)))
              : "";
      report_missing(verification, session.specification, Evidence::DistinctPoints,
                     fmt::format("{}{}: {} of {} points at places of their own", where, of, points, wanted));
    }
    if (articulated) {
      location_positions.insert(place);
      ++orientations[{touched.artefact, touched.placement, touched.repeat}];
    } else {
      size_positions.insert(place);
    }
  }
  for (const auto& [key, count] : orientations) {
    if (count < plan.orientations) {
      found.push_back(fmt::format("ball, placement {}: {} of {} of the wrist",
                                  in_quotes(session.recording.placements.name(std::get<1>(key))),
                                  plural(count, "orientation"), plan.orientations));
    }
  }
  const auto check_positions = [&](std::size_t there, const char* what) {
    if (static_cast<int>(there) < plan.sphere_positions) {
      found.push_back(fmt::format("{}: {} of {} of the ball", what, plural(static_cast<int>(there), "position"),
                                  plan.sphere_positions));
    }
  };
  check_positions(size_positions.size(), "P_Size and P_Form");
  check_positions(location_positions.size(), "L_Dia");
  add_some(std::move(found), verification.missing);
}

}  // namespace artcal
