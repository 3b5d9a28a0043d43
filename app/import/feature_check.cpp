#include "app/import/feature_check.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "app/output/phrases.h"
#include "core/text/in_quotes.h"
#include "fitting/fit.h"

namespace artcal {
namespace {

constexpr double noticeable = 0.01;  // mm: programs filter points and choose other criteria
constexpr std::size_t max_listed = 12;

/// By how much a fit to the points differs from what was reported, mm.
struct Difference {
  std::string name;
  double place = 0.0, diameter = 0.0;
};

std::map<std::string, std::vector<Eigen::Vector3d>> points_by_name(const ImportedReadings& readings, double mm) {
  const auto column = [&](const char* name) {
    return static_cast<std::size_t>(std::find(readings.columns.begin(), readings.columns.end(), name) -
                                    readings.columns.begin());
  };
  const std::size_t feature = column("feature"), x = column("x"), y = column("y"), z = column("z");
  std::map<std::string, std::vector<Eigen::Vector3d>> points;
  for (const auto& row : readings.rows) {
    const auto value = [&](std::size_t i) { return mm * std::strtod(row[i].c_str(), nullptr); };
    points[row[feature]].emplace_back(value(x), value(y), value(z));
  }
  return points;
}

// The tip's centres lie a radius outside of a ball or shaft, and a radius inside of a hole: whichever is nearer.
double diameter_difference(double of_centres, double reported, double tip_radius) {
  const double outside = of_centres - 2.0 * tip_radius - reported, inside = of_centres + 2.0 * tip_radius - reported;
  return std::abs(outside) < std::abs(inside) ? outside : inside;
}

Expected<Difference> difference_of(const ReportedFeature& reported, const std::vector<Eigen::Vector3d>& points,
                                   double mm, double tip_radius) {
  Eigen::Matrix3Xd columns(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    columns.col(static_cast<Eigen::Index>(i)) = points[i];
  }
  const Eigen::Vector3d place = mm * reported.place;
  const auto difference = [&](double distance, double radius) {
    return Difference{reported.name, distance, diameter_difference(2.0 * radius, mm * reported.diameter, tip_radius)};
  };
  switch (reported.kind) {
    case ReportedFeature::Kind::Sphere:
      return fit<Sphere>(columns).map([&](const Fitted<Sphere>& fitted) {
        return difference((fitted.feature.centre - place).norm(), fitted.feature.radius);
      });
    case ReportedFeature::Kind::Circle: {
      FitOptions options;
      options.circle_normal = reported.axis;
      return fit<Circle>(columns, options).map([&](const Fitted<Circle>& fitted) {
        // Across the normal: which plane the centre lies in is each program's own choice.
        const Eigen::Vector3d normal = reported.axis.normalized();
        return difference((fitted.feature.centre - place).cross(normal).norm(), fitted.feature.radius);
      });
    }
    case ReportedFeature::Kind::Cylinder: break;
  }
  return fit<Cylinder>(columns).map([&](const Fitted<Cylinder>& fitted) {
    return difference((place - fitted.feature.point).cross(fitted.feature.direction).norm(), fitted.feature.radius);
  });
}

}  // namespace

std::string feature_check(const ImportedReadings& readings, double mm, double tip_radius_mm) {
  if (readings.reported.empty()) {
    return "";
  }
  const auto points = points_by_name(readings, mm);
  std::vector<Difference> differences;
  std::size_t not_fitted = 0;
  for (const ReportedFeature& reported : readings.reported) {
    const auto found = points.find(reported.name);
    const auto difference = found == points.end() ? Expected<Difference>(bad_input(""))
                                                  : difference_of(reported, found->second, mm, tip_radius_mm);
    if (difference) {
      differences.push_back(*difference);
    } else {
      ++not_fitted;
    }
  }
  std::string text;
  if (!differences.empty()) {
    const auto largest = [&](double Difference::*of) {
      double value = 0.0;
      for (const Difference& each : differences) {
        value = std::max(value, std::abs(each.*of));
      }
      return value;
    };
    text = fmt::format(
        "  check: {} fitted to {} points {} from the file's by at most {:.4f} mm in place, {:.4f} mm in "
        "diameter\n",
        plural(differences.size(), "feature"), differences.size() == 1 ? "its" : "their",
        differences.size() == 1 ? "differs" : "differ", largest(&Difference::place), largest(&Difference::diameter));
  }
  std::size_t listed = 0;
  for (const Difference& each : differences) {
    if ((each.place > noticeable || std::abs(each.diameter) > noticeable) && listed++ < max_listed) {
      text += fmt::format("  check {}: its points say another feature, {:.4f} mm away, diameter {:+.4f} mm\n",
                          in_quotes(each.name), each.place, each.diameter);
    }
  }
  if (not_fitted > 0) {
    text += fmt::format("  check: {} could not be fitted to {} points\n", plural(not_fitted, "feature"),
                        not_fitted == 1 ? "its" : "their");
  }
  return text;
}

}  // namespace artcal
