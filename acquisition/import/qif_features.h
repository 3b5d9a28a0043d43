#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "acquisition/import/qif_points.h"

namespace artcal {

/// A FeatureMeasurement of QIF 3.
struct QifFeature {
  std::string kind;  ///< "Sphere" of SphereFeatureMeasurement
  std::string name;  ///< of its feature item
  std::string where;
  std::vector<QifPoint> points;         ///< of its PointList
  std::optional<QifPoint> place;        ///< its Location, or the point of its axis
  std::optional<Eigen::Vector3d> axis;  ///< its Normal or the direction of its axis
  std::optional<double> diameter;
};

/// What one MeasurementResults element holds.
struct QifResults {
  std::vector<QifFeature> features;
  std::vector<QifTip> tips;  ///< of the point sets whose points are features'
};

/// Names of the feature items of a document by their ids.
std::map<std::string, std::string> qif_feature_names(const pugi::xml_node& document);

/// Reads a MeasurementResults element.
///
/// Bad input: numbers that are none; points that are not there or cannot be read (qif_points.h); two features of a
/// name.
Expected<QifResults> read_qif_results(const XmlSource& source, const pugi::xml_node& results,
                                      const std::map<std::string, std::string>& names, const std::string& linear_unit);

}  // namespace artcal
