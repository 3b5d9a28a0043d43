#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/xml/xml.h"

namespace artcal {

/// A point with its digits.
using QifPoint = std::array<std::string, 3>;

/// What a point set says of the tip that took its points.
struct QifTip {
  std::string where;                ///< of the set
  std::optional<bool> compensated;  ///< whether the tip's radius is taken off; nothing where not stated
  std::string radius;               ///< in the file's unit; empty where not stated
};

/// A MeasuredPointSet of QIF 3, its points with their digits.
struct QifPointSet {
  std::vector<QifPoint> points;
  QifTip tip;
};

/// The point sets of a MeasurementResults element by their ids. Those that features do not name may be of any kind;
/// what cannot be read of one is an error only where it is named, so that it is kept as one.
using QifPointSets = std::map<std::string, Expected<QifPointSet>>;
QifPointSets read_qif_point_sets(const XmlSource& source, const pugi::xml_node& results,
                                 const std::string& linear_unit);

/// The points of features by the point sets that they name.
class QifPointLists {
 public:
  /// Lists may name at most `max_points` points together: a short list can name a long set often.
  QifPointLists(const XmlSource& source, QifPointSets sets, std::size_t max_points)
      : source_(source), sets_(std::move(sets)), room_(max_points) {}

  /// The points of a feature's PointList, in its order: whole sets, ranges of one and single points, counted from 1.
  ///
  /// Bad input: a set that is not there, a range outside of it, an element of another kind, too many points.
  Expected<std::vector<QifPoint>> points_of(const pugi::xml_node& list);

  /// Of the sets whose points were asked for, in the order of their ids.
  [[nodiscard]] std::vector<QifTip> tips() const;

 private:
  const XmlSource& source_;
  QifPointSets sets_;
  std::map<std::string, QifTip> used_;
  std::size_t room_;
};

/// A number as XML writes it, digits unchanged; refused: anything else.
Expected<std::string> qif_number(const XmlSource& source, const pugi::xml_node& node, const std::string& word);

}  // namespace artcal
