#include "app/report/over_time/calibrated_parameters.h"

#include <map>
#include <string>

#include "app/results/result_names.h"

namespace artcal {

CalibratedParameters calibrated_parameters(const RecordedIdentification& identification) {
  CalibratedParameters calibrated;
  std::map<std::string, Eigen::Index> places;
  for (const RecordedParameter& parameter : identification.parameters) {
    calibrated.parameters.push_back({parameter.name, parameter.unit, result_name(parameter.state), parameter.identified,
                                     parameter.u, parameter.degrees_of_freedom});
    places[parameter.name] = static_cast<Eigen::Index>(places.size());
  }
  calibrated.covariance = identification.covariance.matrix;
  const auto& combinations = identification.identifiability.unidentifiable;
  calibrated.unidentifiable = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(calibrated.parameters.size()),
                                                    static_cast<Eigen::Index>(combinations.size()));
  for (std::size_t k = 0; k < combinations.size(); ++k) {
    for (const auto& [name, coefficient] : combinations[k].motion) {
      calibrated.unidentifiable(places.at(name), static_cast<Eigen::Index>(k)) = coefficient;
    }
  }
  return calibrated;
}

}  // namespace artcal
