#include "acquisition/import/qif_features.h"

#include <cstdlib>
#include <set>

#include <fmt/format.h>
#include <pugixml.hpp>

#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr std::string_view measurement_suffix = "FeatureMeasurement", item_suffix = "FeatureItem";

// Three numbers of an element; nothing where it is not there.
Expected<std::optional<QifPoint>> triple_of(const XmlSource& source, const pugi::xml_node& node,
                                            const std::string& linear_unit) {
  if (!node) {
    return std::nullopt;
  }
  const std::vector<std::string> words = words_of(text_of(node));
  if (words.size() != 3) {
    return bad_input(fmt::format("{} has {} numbers, expected three", local_name(node), words.size()),
                     source.place_of(node));
  }
  const std::string unit = node.attribute("linearUnit").value();
  if (!unit.empty() && unit != linear_unit) {
    return bad_input(fmt::format("{} has the unit {}, expected that of the file", local_name(node), in_quotes(unit)),
                     source.place_of(node));
  }
  QifPoint triple;
  for (std::size_t i = 0; i < 3; ++i) {
    auto number = qif_number(source, node, words[i]);
    if (!number) {
      return tl::unexpected(number.error());
    }
    triple[i] = std::move(*number);
  }
  return triple;
}

double qif_value(const std::string& number) { return std::strtod(number.c_str(), nullptr); }

Eigen::Vector3d qif_vector(const QifPoint& point) {
  return {qif_value(point[0]), qif_value(point[1]), qif_value(point[2])};
}

Expected<QifFeature> feature_of(const XmlSource& source, const pugi::xml_node& node, QifPointLists& lists,
                                const std::map<std::string, std::string>& names, const std::string& linear_unit) {
  QifFeature feature;
  feature.where = source.place_of(node);
  const std::string_view element = local_name(node);
  feature.kind = element.substr(0, element.size() - measurement_suffix.size());
  const std::string id = text_of(child_of(node, "FeatureItemId"));
  const auto name = names.find(id);
  feature.name =
      name == names.end() ? fmt::format("feature {}", id.empty() ? node.attribute("id").value() : id) : name->second;
  if (find_control(feature.name)) {
    return bad_input("the feature's name has a control character", feature.where);
  }
  auto points = lists.points_of(child_of(node, "PointList"));
  if (!points) {
    return tl::unexpected(points.error());
  }
  feature.points = std::move(*points);
  const pugi::xml_node axis = child_of(node, "Axis");
  const auto place = triple_of(source, axis ? child_of(axis, "AxisPoint") : child_of(node, "Location"), linear_unit);
  const auto direction = triple_of(source, axis ? child_of(axis, "Direction") : child_of(node, "Normal"), "");
  if (!place || !direction) {
    return tl::unexpected(!place ? place.error() : direction.error());
  }
  feature.place = *place;
  if (*direction) {
    feature.axis = qif_vector(**direction);
  }
  if (const pugi::xml_node diameter = child_of(node, "Diameter")) {
    const auto number = qif_number(source, diameter, text_of(diameter));
    if (!number) {
      return tl::unexpected(number.error());
    }
    feature.diameter = qif_value(*number);
  }
  return feature;
}

}  // namespace

std::map<std::string, std::string> qif_feature_names(const pugi::xml_node& document) {
  std::map<std::string, std::string> names;
  for (const pugi::xml_node& node : child_of(child_of(document, "Features"), "FeatureItems").children()) {
    if (local_name(node).ends_with(item_suffix)) {
      const std::string name = in_one_line_of_words(text_of(child_of(node, "FeatureName")));
      if (!name.empty()) {
        names.emplace(node.attribute("id").value(), name);
      }
    }
  }
  return names;
}

Expected<QifResults> read_qif_results(const XmlSource& source, const pugi::xml_node& results,
                                      const std::map<std::string, std::string>& names, const std::string& linear_unit) {
  QifResults read;
  // A point of three numbers takes six bytes, and may be one of a few features.
  QifPointLists lists(source, read_qif_point_sets(source, results, linear_unit), source.file().text.size());
  std::set<std::string> seen;
  for (const pugi::xml_node& node : child_of(results, "MeasuredFeatures").children()) {
    if (!local_name(node).ends_with(measurement_suffix)) {
      continue;
    }
    auto feature = feature_of(source, node, lists, names, linear_unit);
    if (!feature) {
      return tl::unexpected(feature.error());
    }
    if (!seen.insert(feature->name).second) {
      return bad_input(fmt::format("{} is measured twice in one MeasurementResults, expected names that differ",
                                   in_quotes(feature->name)),
                       feature->where);
    }
    read.features.push_back(std::move(*feature));
  }
  read.tips = lists.tips();
  return read;
}

}  // namespace artcal
