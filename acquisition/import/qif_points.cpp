#include "acquisition/import/qif_points.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "acquisition/import/delimited_text.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

std::optional<std::size_t> count_of(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && !text.empty() ? std::optional(value)
                                                                                   : std::nullopt;
}

Expected<std::optional<bool>> compensated_of(const XmlSource& source, const pugi::xml_node& set) {
  std::optional<bool> compensated;
  const pugi::xml_node one = child_of(set, "Compensated"), each = child_of(set, "Compensations");
  for (const std::string& word : words_of(text_of(one ? one : each))) {
    const bool yes = word == "true" || word == "1";
    if (!yes && word != "false" && word != "0") {
      return bad_input(fmt::format("compensation is {}, expected true or false", in_quotes(word)),
                       source.place_of(set));
    }
    if (compensated && *compensated != yes) {
      return bad_input("some points of the set are compensated for the tip, some are not", source.place_of(set));
    }
    compensated = yes;
  }
  return compensated;
}

Expected<std::string> probe_radius_of(const XmlSource& source, const pugi::xml_node& set) {
  std::string radius;
  const pugi::xml_node one = child_of(set, "ProbeRadius"), each = child_of(set, "ProbeRadii");
  for (const std::string& word : words_of(text_of(one ? one : each))) {
    const auto number = qif_number(source, set, word);
    if (!number) {
      return tl::unexpected(number.error());
    }
    if (!radius.empty() && radius != *number) {
      return bad_input(fmt::format("the set has points of tips of radius {} and {}, expected one tip", radius, *number),
                       source.place_of(set));
    }
    radius = *number;
  }
  return radius;
}

Expected<void> check_form(const XmlSource& source, const pugi::xml_node& set, const std::string& linear_unit) {
  for (const char* element : {"CoordinateSystemId", "TransformId", "TranformId"}) {
    if (const pugi::xml_node own = child_of(set, element)) {
      return bad_input(
          fmt::format("the points are stated in a coordinate system of their own ({}), which is not read", element),
          source.place_of(own));
    }
  }
  for (const pugi::xml_node& child : set.children()) {
    const std::string_view name = local_name(child);
    if (name == "BinaryPoints" || name == "BinaryCompensated" || name == "BinaryProbeRadii") {
      return bad_input(fmt::format("the set has {}, which is not read; export points as text", name),
                       source.place_of(child));
    }
  }
  const std::string unit = set.attribute("linearUnit").value();
  if (!unit.empty() && unit != linear_unit) {
    return bad_input(fmt::format("the set has the unit {}, expected that of the file", in_quotes(unit)),
                     source.place_of(set));
  }
  return {};
}

Expected<std::vector<QifPoint>> points_of(const XmlSource& source, const pugi::xml_node& set) {
  const pugi::xml_node node = child_of(set, "Points");
  if (!node) {
    return bad_input("the set has no Points", source.place_of(set));
  }
  const std::vector<std::string> words = words_of(text_of(node));
  std::vector<QifPoint> points;
  for (std::size_t i = 0; i < words.size(); ++i) {
    auto number = qif_number(source, node, words[i]);
    if (!number) {
      return tl::unexpected(number.error());
    }
    if (i % 3 == 0) {
      points.emplace_back();
    }
    points.back()[i % 3] = std::move(*number);
  }
  const std::string stated = set.attribute("count").value();
  if (words.size() % 3 != 0 || (!stated.empty() && count_of(stated) != points.size())) {
    return bad_input(fmt::format("the set states {} points and has {} numbers, expected three a point",
                                 stated.empty() ? "no count of" : in_quotes(stated), words.size()),
                     source.place_of(node));
  }
  return points;
}

Expected<QifPointSet> point_set(const XmlSource& source, const pugi::xml_node& node, const std::string& linear_unit) {
  if (auto form = check_form(source, node, linear_unit); !form) {
    return tl::unexpected(form.error());
  }
  auto points = points_of(source, node);
  const auto compensated = compensated_of(source, node);
  const auto radius = probe_radius_of(source, node);
  if (!points || !compensated || !radius) {
    return tl::unexpected(!points ? points.error() : !compensated ? compensated.error() : radius.error());
  }
  return QifPointSet{std::move(*points), {source.place_of(node), *compensated, *radius}};
}

// Which points of a set an element of a PointList names, from and to, counted from 1.
std::optional<std::pair<std::size_t, std::size_t>> range_of(const pugi::xml_node& item, std::size_t points) {
  const std::string_view kind = local_name(item);
  if (kind == "WholePointSetId") {
    return std::pair<std::size_t, std::size_t>{1, points};
  }
  const auto words = words_of(item.attribute(kind == "RangePointSetId" ? "range" : "index").value());
  if (words.size() != (kind == "RangePointSetId" ? 2 : 1)) {
    return std::nullopt;
  }
  const auto from = count_of(words.front()), to = count_of(words.back());
  return from && to && *from >= 1 && *from <= *to && *to <= points ? std::optional(std::pair{*from, *to})
                                                                   : std::nullopt;
}

}  // namespace

Expected<std::string> qif_number(const XmlSource& source, const pugi::xml_node& node, const std::string& word) {
  bool comma = false, point = false;
  const auto number = number_text(word, comma, point);
  if (!number || comma) {
    return bad_input(fmt::format("{} of {} is no number", in_quotes(word), local_name(node)), source.place_of(node));
  }
  return *number;
}

QifPointSets read_qif_point_sets(const XmlSource& source, const pugi::xml_node& results,
                                 const std::string& linear_unit) {
  QifPointSets sets;
  for (const pugi::xml_node& node : child_of(results, "MeasuredPointSets").children()) {
    if (local_name(node) == "MeasuredPointSet") {
      sets.emplace(node.attribute("id").value(), point_set(source, node, linear_unit));
    }
  }
  return sets;
}

Expected<std::vector<QifPoint>> QifPointLists::points_of(const pugi::xml_node& list) {
  std::vector<QifPoint> points;
  for (const pugi::xml_node& item : list.children()) {
    if (item.type() != pugi::node_element) {
      continue;
    }
    const std::string_view kind = local_name(item);
    if (kind != "WholePointSetId" && kind != "RangePointSetId" && kind != "SinglePointSetId") {
      return bad_input(fmt::format("{} in a PointList, expected WholePointSetId, RangePointSetId or SinglePointSetId",
                                   in_quotes(kind)),
                       source_.place_of(item));
    }
    const std::string id = text_of(item);
    const auto found = sets_.find(id);
    if (found == sets_.end()) {
      return bad_input(fmt::format("there is no MeasuredPointSet {}", in_quotes(id)), source_.place_of(item));
    }
    if (!found->second) {
      return tl::unexpected(found->second.error());
    }
    const std::vector<QifPoint>& all = found->second->points;
    const auto range = range_of(item, all.size());
    if (!range) {
      return bad_input(
          fmt::format("{} names points that the set does not have, expected some of 1 to {}", kind, all.size()),
          source_.place_of(item));
    }
    const std::size_t count = all.empty() ? 0 : range->second - range->first + 1;
    if (count > room_) {
      return bad_input("the features name more points together than the file can hold", source_.place_of(item));
    }
    room_ -= count;
    used_.emplace(id, found->second->tip);
    if (count > 0) {
      const auto first = all.begin() + static_cast<std::ptrdiff_t>(range->first) - 1;
      points.insert(points.end(), first, first + static_cast<std::ptrdiff_t>(count));
    }
  }
  return points;
}

std::vector<QifTip> QifPointLists::tips() const {
  std::vector<QifTip> tips;
  for (const auto& [id, tip] : used_) {
    tips.push_back(tip);
  }
  return tips;
}

}  // namespace artcal
