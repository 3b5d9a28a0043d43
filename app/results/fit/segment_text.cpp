#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/output/table.h"
#include "app/results/fit/segment_result.h"
#include "app/results/shown_text.h"
#include "core/text/in_quotes.h"
#include "core/text/point_text.h"

namespace artcal {
namespace {

constexpr std::size_t max_distances = 12;
constexpr std::size_t max_rejected = 12;
constexpr std::size_t max_ways = 8;

std::string percent(double share) { return fmt::format("{:.0f} %", 100.0 * share); }

// In the scan's unit, to a hundredth of the smallest radius: near enough to be handed to --place.
std::string place(const SegmentResult& result, const Eigen::Vector3d& in_mm) {
  const auto& radii = result.wanted.contents.radii;
  const double resolution = 0.01 * *std::min_element(radii.begin(), radii.end());
  return point_text(in_mm / result.unit_in_mm, resolution / result.unit_in_mm);
}

std::string spheres_table(const SegmentResult& result) {
  Table table({"sphere", "x", "y", "z", "radius seen", "points", "seen", "noise", "form"});
  for (std::size_t i = 0; i < result.segmentation.spheres.size(); ++i) {
    if (const auto& sphere = result.segmentation.spheres[i]) {
      const Eigen::Vector3d& c = sphere->fitted.feature.centre;
      table.add({shown_name(sphere_name(result, i)), mm_text(c.x()), mm_text(c.y()), mm_text(c.z()),
                 mm_text(sphere->seen_radius), fmt::format("{}", sphere->points.size()), percent(sphere->coverage),
                 mm_text(sphere->fitted.rms), mm_text(sphere->fitted.form)});
    }
  }
  return table.text();
}

std::string planes_table(const SegmentResult& result) {
  Table table({"plane", "x", "y", "z", "normal x", "normal y", "normal z", "points", "noise", "form"});
  for (std::size_t i = 0; i < result.segmentation.planes.size(); ++i) {
    const FoundPlane& plane = result.segmentation.planes[i];
    const Plane& p = plane.fitted.feature;
    table.add({shown_name(plane_name(result, i)), mm_text(p.point.x()), mm_text(p.point.y()), mm_text(p.point.z()),
               fmt::format("{:.6f}", p.normal.x()), fmt::format("{:.6f}", p.normal.y()),
               fmt::format("{:.6f}", p.normal.z()), fmt::format("{}", plane.points.size()), mm_text(plane.fitted.rms),
               mm_text(plane.fitted.form)});
  }
  return table.text();
}

std::string distances_table(const SegmentResult& result) {
  auto distances = seen_distances(result);
  if (distances.empty()) {
    return "";
  }
  std::stable_sort(distances.begin(), distances.end(), [](const SeenDistance& a, const SeenDistance& b) {
    return std::abs(a.measured - a.at_temperature) > std::abs(b.measured - b.at_temperature);
  });
  Table table({"distance", "certified", "at, degC", "at temperature", "in the scan", "error"});
  for (std::size_t i = 0; i < std::min(distances.size(), max_distances); ++i) {
    const SeenDistance& d = distances[i];
    table.add({fmt::format("{} - {}", shown_name(sphere_name(result, static_cast<std::size_t>(d.first))),
                           shown_name(sphere_name(result, static_cast<std::size_t>(d.second)))),
               mm_text(d.certified.value), fmt::format("{:.4g}", d.certified.temperature), mm_text(d.at_temperature),
               mm_text(d.measured), fmt::format("{:+.4f}", d.measured - d.at_temperature)});
  }
  const std::string more = distances.size() > max_distances
                               ? fmt::format("  ({} more, all nearer)\n", distances.size() - max_distances)
                               : "";
  return "\n" + table.text() + more;
}

std::string rejected_text(const SegmentResult& result) {
  std::string text;
  const auto& rejected = result.segmentation.rejected;
  for (std::size_t i = 0; i < std::min(rejected.size(), max_rejected); ++i) {
    text += fmt::format("  {}\n", rejected[i].why);
  }
  if (rejected.size() > max_rejected) {
    text += fmt::format("  ({} more, all in the JSON result)\n", rejected.size() - max_rejected);
  }
  return text.empty() ? text : "\nNot taken:\n" + text;
}

// Only as many of the names as tell the ways apart would have to be given; the first is where to start.
std::string ways_text(const SegmentResult& result) {
  const auto& ways = result.segmentation.matching.ways;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < std::min(ways.size(), max_ways); ++i) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < ways[i].found.size() && names.size() < 3; ++k) {
      if (ways[i].found[k] >= 0) {
        const auto& sphere = result.segmentation.spheres[static_cast<std::size_t>(ways[i].found[k])];
        names.push_back(
            fmt::format("{} at {}", shown_name(sphere_name(result, k)), place(result, sphere->fitted.feature.centre)));
      }
    }
    texts.push_back(fmt::format("{} (distances within {:.2g} mm)", fmt::join(names, ", "), ways[i].worst));
  }
  return fmt::format("{}{}", fmt::join(texts, "; or "), ways.size() > max_ways ? "; or others" : "");
}

std::string found_text(const SegmentResult& result) {
  std::vector<std::string> places;
  for (const auto& sphere : result.segmentation.spheres) {
    if (sphere && places.size() < 6) {
      places.push_back(place(result, sphere->fitted.feature.centre));
    }
  }
  return fmt::format("{}{}", fmt::join(places, ", "), result.segmentation.spheres.size() > 6 ? ", …" : "");
}

// Each statement that no sphere answers, and what was found instead.
std::string unmet_text(const SegmentResult& result) {
  std::vector<std::string> texts;
  for (const UnmetHint& unmet : result.segmentation.matching.unmet) {
    const PlaceHint& hint = result.options.hints[static_cast<std::size_t>(unmet.hint)];
    texts.push_back(fmt::format("--place states {} at {} {}, but {}",
                                in_quotes(sphere_name(result, static_cast<std::size_t>(hint.point))),
                                place(result, hint.near), result.unit, fault_text(unmet)));
    for (const RejectedSphere& rejected : result.segmentation.rejected) {
      if ((rejected.sphere.centre - hint.near).norm() <= unmet.limit) {
        texts.back() += fmt::format(" (not taken there: {})", rejected.why);
      }
    }
  }
  return fmt::format("{}", fmt::join(texts, "; "));
}

}  // namespace

std::string to_text(const SegmentResult& result) {
  std::string text = fmt::format("{} in {}\n{} points in {}, x, y, z from {}\n\n", shown_name(result.artefact.name),
                                 truncated(80, result.inputs.front().path), result.points, result.unit, result.columns);
  if (!result.wanted.spheres.empty()) {
    text += spheres_table(result);
  }
  if (!result.segmentation.planes.empty()) {
    text += planes_table(result);
  }
  text += distances_table(result);
  text += rejected_text(result);
  if (const auto missing = missing_names(result); !missing.empty()) {
    text += fmt::format("\nMissing in this scan: {}\n", truncated(400, fmt::format("{}", fmt::join(missing, ", "))));
  }
  for (const auto& warning : result.warnings) {
    text += fmt::format("Warning: {}\n", warning);
  }
  return text;
}

std::string refusal_text(const SegmentResult& result) {
  const Segmentation& s = result.segmentation;
  const auto hints = s.warnings.empty() ? std::string() : fmt::format("; {}", fmt::join(s.warnings, "; "));
  switch (s.status) {
    case SegmentStatus::Ambiguous:
      return fmt::format(
          "the certified distances fit in {}{} ways, so that which sphere is which is not determined: {}. Say where "
          "spheres are, such as --place {}=x,y,z in {}, or lower --tolerance (now {:.3g} mm)",
          s.matching.there_are_more ? "more than " : "", s.matching.ways.size(), ways_text(result),
          in_quotes(sphere_name(result, 0)), result.unit, s.tolerance);
    case SegmentStatus::NotThere:
      return fmt::format(
          "{}; spheres were found at {} {}: correct the place, or state that of another sphere, because one that is "
          "not in the scan cannot show which is which{}",
          unmet_text(result), found_text(result), result.unit, hints);
    case SegmentStatus::NoMatch:
      return fmt::format(
          "{} spheres of the right radius were found, at {} {}, but they are not at the certified distances to {:.3g} "
          "mm{}; is it this artefact, and is the arm identified? --tolerance allows more{}",
          s.spheres.size(), found_text(result), result.unit, s.tolerance,
          result.options.hints.empty() ? "" : " with the names that --place states", hints);
    default:
      return fmt::format("none of the artefact's features was found in {} points{}{}", result.points, hints,
                         s.rejected.empty() ? "" : fmt::format("; nearest to one: {}", s.rejected.front().why));
  }
}

}  // namespace artcal
