#include "artefacts/scans/scan_refusal.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/text/in_quotes.h"
#include "core/text/point_text.h"

namespace artcal {
namespace {

std::string centres_of(const Segmentation& found) {
  constexpr std::size_t most = 6;
  std::vector<std::string> places;
  for (const auto& sphere : found.spheres) {
    if (sphere && places.size() < most) {
      places.push_back(point_text(sphere->fitted.feature.centre, 0.01 * sphere->radius_wanted));
    }
  }
  return fmt::format("{}{}", fmt::join(places, ", "), found.spheres.size() > most ? ", …" : "");
}

std::string unmet_text(const Segmentation& found, const ArtefactInScan& wanted, const Artefact& artefact,
                       const std::vector<PlaceHint>& hints) {
  std::vector<std::string> texts;
  for (const UnmetHint& unmet : found.matching.unmet) {
    const PlaceHint& hint = hints[static_cast<std::size_t>(unmet.hint)];
    const auto point = static_cast<std::size_t>(hint.point);
    const std::string& name = artefact.features[static_cast<std::size_t>(wanted.spheres[point])].name;
    texts.push_back(fmt::format("[[scan.place]] states the sphere {} at {} mm, but {}", in_quotes(name),
                                point_text(hint.near, 0.01 * wanted.contents.radii[point]), fault_text(unmet)));
  }
  return fmt::format("{}", fmt::join(texts, "; "));
}

}  // namespace

std::string scan_refusal(const Segmentation& found, const ArtefactInScan& wanted, const Artefact& artefact,
                         const std::vector<PlaceHint>& hints) {
  const std::string& first = artefact.features[static_cast<std::size_t>(wanted.spheres.front())].name;
  switch (found.status) {
    case SegmentStatus::Ambiguous:
      return fmt::format(
          "the certified distances fit the spheres in {}{} ways, so that which is which is not determined: say where "
          "one is with place = [{{ sphere = {}, at = [x, y, z] }}], or lower tolerance (now {:.3g} mm); spheres stand "
          "at {} mm in the arm's base frame",
          found.matching.there_are_more ? "more than " : "", found.matching.ways.size(), in_quotes(first),
          found.tolerance, centres_of(found));
    case SegmentStatus::NotThere:
      return fmt::format(
          "{}; spheres were found at {} mm in the arm's base frame: correct the place, or state that of another sphere",
          unmet_text(found, wanted, artefact, hints), centres_of(found));
    case SegmentStatus::NoMatch:
      return fmt::format(
          "{} spheres of the right radius were found, at {} mm in the arm's base frame, but they are not at the "
          "certified distances to {:.3g} mm; is it this artefact, and this arm? A larger tolerance of the scan allows "
          "more",
          found.spheres.size(), centres_of(found), found.tolerance);
    default: break;
  }
  return fmt::format(
      "none of the spheres of {} was found where the tip was; are the arm, the probe and the unit of the joint angles "
      "the right ones?{}",
      in_quotes(artefact.name),
      found.rejected.empty() ? "" : fmt::format(" Nearest to one: {}", found.rejected.front().why));
}

}  // namespace artcal
