#include "acquisition/import/qif_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pugixml.hpp>

#include "acquisition/import/qif_features.h"
#include "core/text/in_quotes.h"
#include "core/unit_names.h"
#include "core/units.h"

namespace artcal {
namespace {

/// The unit of lengths as the document calls it, and ours.
struct LinearUnit {
  std::string in_file, name;  ///< both empty where the document states none
};

Expected<LinearUnit> linear_unit_of(const XmlSource& source, const pugi::xml_node& document) {
  const pugi::xml_node node = child_of(child_of(child_of(document, "FileUnits"), "PrimaryUnits"), "LinearUnit");
  if (!node) {
    return LinearUnit{};
  }
  LinearUnit unit{text_of(child_of(node, "UnitName")), ""};
  const std::string base = text_of(child_of(node, "SIUnitName"));
  const pugi::xml_node conversion = child_of(node, "UnitConversion");
  double factor = 1.0;  // m
  if (conversion) {
    const pugi::xml_node stated = child_of(conversion, "Factor");
    const auto number = qif_number(source, stated ? stated : conversion, text_of(stated));
    if (!number) {
      return tl::unexpected(number.error());
    }
    factor = std::strtod(number->c_str(), nullptr);
  }
  for (const char* name : {"mm", "m", "in", "um"}) {
    const double metres = *length_unit(name) / units::metre;
    if ((base == "meter" || base == "metre") && std::abs(factor / metres - 1.0) < 1e-9) {
      unit.name = name;
      return unit;
    }
  }
  return bad_input(fmt::format("the unit of lengths is {} times {}, expected m, mm, um or in", factor, in_quotes(base)),
                   source.place_of(node));
}

bool has_place(const QifFeature& feature) {
  static constexpr std::array kinds{"Point", "EdgePoint", "Sphere", "SphericalSegment", "Circle", "CircularArc"};
  return feature.place && std::find(kinds.begin(), kinds.end(), feature.kind) != kinds.end();
}

std::optional<ReportedFeature> reported(const QifFeature& feature) {
  using Kind = ReportedFeature::Kind;
  const bool is_sphere = feature.kind == "Sphere" || feature.kind == "SphericalSegment";
  const bool is_circle = feature.kind == "Circle" || feature.kind == "CircularArc";
  const bool is_cylinder = feature.kind == "Cylinder" || feature.kind == "CylindricalSegment";
  if (!(is_sphere || is_circle || is_cylinder) || !feature.place || !feature.diameter ||
      (!is_sphere && !(feature.axis && feature.axis->norm() > 0.0))) {
    return std::nullopt;
  }
  const auto value = [&](std::size_t i) { return std::strtod((*feature.place)[i].c_str(), nullptr); };
  return ReportedFeature{feature.name,
                         is_sphere   ? Kind::Sphere
                         : is_circle ? Kind::Circle
                                     : Kind::Cylinder,
                         {value(0), value(1), value(2)},
                         feature.axis.value_or(Eigen::Vector3d::Zero()),
                         *feature.diameter};
}

/// What the point sets that are used say of the tip, all of them.
struct Tip {
  std::string radius;  ///< empty: not stated
  std::string said;
};

Expected<Tip> tip_of(const std::vector<QifResults>& all) {
  std::vector<QifTip> tips;
  for (const QifResults& results : all) {
    tips.insert(tips.end(), results.tips.begin(), results.tips.end());
  }
  const auto radius_text = [](const QifTip& tip) { return tip.radius.empty() ? "not stated" : tip.radius; };
  for (const QifTip& tip : tips) {
    if (tip.compensated != tips.front().compensated) {
      return bad_input("some points are compensated for the tip and some are not, or it is not stated of all sets",
                       tip.where);
    }
    if (tip.compensated != std::optional(true) && tip.radius != tips.front().radius) {
      return bad_input(fmt::format("the tip's radius is {} here and {} in another set, expected one tip",
                                   radius_text(tip), radius_text(tips.front())),
                       tip.where);
    }
  }
  if (tips.empty() || !tips.front().compensated) {
    return Tip{"", "whether the points are compensated for the tip is not stated"};
  }
  if (*tips.front().compensated) {
    return Tip{"0", "the points are compensated for the tip, whose radius is 0 then"};
  }
  return Tip{tips.front().radius, "the points are centres of the tip"};
}

class QifImport {
 public:
  explicit QifImport(std::vector<QifResults> all) : all_(std::move(all)) {}

  Expected<ImportedReadings> readings(const std::string& path) {
    const bool has_points = std::any_of(all_.begin(), all_.end(), [](const QifResults& r) { return !r.tips.empty(); });
    imported_.format = "QIF 3";
    imported_.columns = {"feature", "x", "y", "z"};
    if (all_.size() > 1) {
      imported_.columns.insert(imported_.columns.begin() + 1, "repeat");
    }
    for (std::size_t part = 0; part < all_.size(); ++part) {
      for (const QifFeature& feature : all_[part].features) {
        take(feature, part, has_points);
      }
    }
    if (imported_.rows.empty()) {
      return bad_input("the document has no measured points and no fitted point, sphere or circle with its place",
                       path);
    }
    imported_.understood.emplace_back(has_points
                                          ? "feature = FeatureName, x, y, z = the points of its measured point sets"
                                          : "feature = FeatureName, x, y, z = the Location of points, spheres "
                                            "and circles as they were fitted");
    if (all_.size() > 1) {
      imported_.understood.push_back(fmt::format("repeat = which of the {} MeasurementResults", all_.size()));
    }
    if (passed_ > 0) {
      imported_.understood.push_back(fmt::format("passed over: {} features without {}", passed_,
                                                 has_points ? "points" : "a place of their own (planes, lines, axes)"));
    }
    if (has_points) {
      const auto tip = tip_of(all_);
      if (!tip) {
        return tl::unexpected(tip.error());
      }
      imported_.probe_radius = tip->radius;
      imported_.understood.push_back(tip->said);
    }
    return std::move(imported_);
  }

 private:
  void take(const QifFeature& feature, std::size_t part, bool has_points) {
    if (!has_points && has_place(feature)) {
      add(feature.name, part, *feature.place);
      return;
    }
    if (!has_points || feature.points.empty()) {
      ++passed_;
      return;
    }
    for (const auto& point : feature.points) {
      add(feature.name, part, point);
    }
    // With repeats a name is there once for each part: its points are told apart by no reader of this list.
    if (const auto fitted = reported(feature); fitted && all_.size() == 1) {
      imported_.reported.push_back(*fitted);
    }
  }

  void add(const std::string& name, std::size_t part, const std::array<std::string, 3>& point) {
    std::vector<std::string>& row = imported_.rows.emplace_back();
    row.push_back(name);
    if (all_.size() > 1) {
      row.push_back(fmt::format("{}", part + 1));
    }
    row.insert(row.end(), point.begin(), point.end());
  }

  std::vector<QifResults> all_;
  ImportedReadings imported_;
  std::size_t passed_ = 0;
};

Expected<void> check_qif_version(const XmlSource& source, const pugi::xml_node& document) {
  const std::string version = document.attribute("versionQIF").value();
  return version.starts_with("3.")
             ? Expected<void>{}
             : bad_input(fmt::format("the document is QIF {}, expected QIF 3", in_quotes(version)),
                         source.place_of(document));
}

}  // namespace

bool is_qif_file(const TextFile& file) {
  constexpr std::size_t head = 4096;
  const std::string_view start = std::string_view(file.text).substr(0, head);
  return start.find("<QIFDocument") != std::string_view::npos || start.find(":QIFDocument") != std::string_view::npos;
}

Expected<ImportedReadings> import_qif(const TextFile& file) {
  const XmlSource source(file);
  pugi::xml_document xml;
  if (auto parsed = parse_xml(source, xml); !parsed) {
    return tl::unexpected(parsed.error());
  }
  const pugi::xml_node document = xml.document_element();
  if (local_name(document) != "QIFDocument") {
    return bad_input(fmt::format("the root of the file is {}, expected QIFDocument", in_quotes(local_name(document))),
                     source.place_of(document));
  }
  if (auto version = check_qif_version(source, document); !version) {
    return tl::unexpected(version.error());
  }
  const auto unit = linear_unit_of(source, document);
  if (!unit) {
    return tl::unexpected(unit.error());
  }
  const auto names = qif_feature_names(document);
  std::vector<QifResults> all;
  for (const pugi::xml_node& node : child_of(child_of(document, "Results"), "MeasurementResultsSet").children()) {
    if (local_name(node) != "MeasurementResults") {
      continue;
    }
    auto results = read_qif_results(source, node, names, unit->in_file);
    if (!results) {
      return tl::unexpected(results.error());
    }
    all.push_back(std::move(*results));
  }
  return QifImport(std::move(all)).readings(file.path.string()).map([&](ImportedReadings&& readings) {
    readings.length_unit = unit->name;
    return std::move(readings);
  });
}

}  // namespace artcal
