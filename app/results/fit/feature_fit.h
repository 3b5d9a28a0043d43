#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "acquisition/point_cloud/point_cloud.h"
#include "app/requests/points/fit_request.h"
#include "app/results/fit/feature_values.h"

namespace artcal {

/// A point that stands out, by its row in the file.
struct RowDeviation {
  int row = 0;
  double mm = 0.0;  ///< signed distance to the feature
};

/// A feature fitted to the points of a file, whatever its shape.
struct FeatureFit {
  std::vector<FeatureValue> values;
  std::vector<std::string> parameters;        ///< what `covariance` counts
  std::optional<Eigen::MatrixXd> covariance;  ///< mm, rad
  std::size_t points = 0;                     ///< fitted, outliers not among them
  double form = 0.0, rms = 0.0;               ///< mm
  std::optional<double> noise;                ///< mm
  int degrees_of_freedom = 0;
  int steps = 0;
  RowDeviation lowest, highest;               ///< of the points fitted
  std::vector<RowDeviation> outliers;         ///< ascending rows
  std::optional<FeatureValue> free_diameter;  ///< sphere of stated diameter: what the points alone say
  std::vector<std::string> warnings;
};

/// Fits what `request` asks for to the points. Errors are those of fit() and fit_robust(); NoSolution where the
/// fit did not converge; BadInput where a stated diameter and the points do not belong together.
Expected<FeatureFit> fit_feature(const PointCloud& cloud, const FitRequest& request);

}  // namespace artcal
