#pragma once

#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace artcal {

/// A parameter as an identification left it, mm or rad.
struct CalibratedParameter {
  std::string name, unit, state;
  double value = 0.0;
  double u = 0.0;                                                       ///< standard uncertainty; 0 unless identified
  double degrees_of_freedom = std::numeric_limits<double>::infinity();  ///< effective, of u
};

/// Identified, if only weakly; all others were fixed.
bool is_identified(const CalibratedParameter& parameter);

/// All parameters of one identification.
struct CalibratedParameters {
  std::vector<CalibratedParameter> parameters;
  Eigen::MatrixXd covariance;      ///< of the identified ones, in their order
  Eigen::MatrixXd unidentifiable;  ///< by all parameters, a column for each combination that no reading sees
};

/// How a parameter changed from one identification to another.
struct ParameterChange {
  std::string name, unit;
  double then = 0.0, now = 0.0;
  double u = 0.0;            ///< √(u²(then) + u²(now)): the results are independent of one another
  double limit = 0.0;        ///< significance_factor() of all changes, by the effective degrees of freedom of u
  double expanded = 0.0;     ///< k·u, k = 2 or Student's factor where larger
  bool significant = false;  ///< beyond `limit` times u
};

/// What changed between two identifications of an arm. Parameters hang together: readings determine theta6 + a6/l, and
/// which of the two takes what depends on the value at which the other is fixed. Therefore the later one is stated in
/// the gauge of the earlier one (app/results/drift/gauge.h), where there is such a statement of it.
struct ParameterComparison {
  std::string not_comparable;            ///< why not; empty where it is
  std::vector<std::string> moved;        ///< fixed parameters whose value differed
  std::vector<ParameterChange> changes;  ///< of those that the earlier one identified, in their order
  double chi_squared = 0.0;              ///< of all changes together, by the sum of both covariances
  double limit = 0.0;                    ///< what chance stays below in 95 of 100 cases: χ², or Hotelling's T²
  [[nodiscard]] bool significant() const { return chi_squared > limit; }
};

ParameterComparison compare(const CalibratedParameters& then, const CalibratedParameters& now);

}  // namespace artcal
