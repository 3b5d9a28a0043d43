#include "app/report/over_time/calibrated_parameters.h"

#include <map>
#include <stdexcept>
#include <string>

namespace artcal {
namespace {

using Json = nlohmann::ordered_json;

CalibratedParameter calibrated_parameter(const Json& json) {
  CalibratedParameter parameter{json.at("name"), json.at("unit"), json.at("state"), json.at("identified")};
  if (is_identified(parameter)) {
    parameter.u = json.at("standard_uncertainty");
    if (json.contains("degrees_of_freedom") && json["degrees_of_freedom"].is_number()) {
      parameter.degrees_of_freedom = json["degrees_of_freedom"];
    }
  }
  return parameter;
}

Eigen::MatrixXd square_matrix(const Json& rows, std::size_t size) {
  const auto count = static_cast<Eigen::Index>(size);
  Eigen::MatrixXd matrix(count, count);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = rows.at(i).at(j);
    }
  }
  return matrix;
}

// The covariance must be of what is identified, in that order: it is read by place.
void check_names(const Json& names, const std::vector<CalibratedParameter>& parameters) {
  std::size_t k = 0;
  for (const CalibratedParameter& parameter : parameters) {
    if (is_identified(parameter) && names.at(k++) != parameter.name) {
      throw std::out_of_range("the covariance is not of the identified parameters");
    }
  }
  if (k != names.size()) {
    throw std::out_of_range("the covariance is not of the identified parameters");
  }
}

}  // namespace

CalibratedParameters calibrated_parameters(const Json& result) {
  CalibratedParameters calibrated;
  std::map<std::string, Eigen::Index> places;
  for (const Json& json : result.at("parameters")) {
    calibrated.parameters.push_back(calibrated_parameter(json));
    places[calibrated.parameters.back().name] = static_cast<Eigen::Index>(places.size());
  }
  const Json& covariance = result.at("covariance");
  check_names(covariance.at("parameters"), calibrated.parameters);
  calibrated.covariance = square_matrix(covariance.at("matrix"), covariance.at("parameters").size());
  const Json& combinations = result.at("coupling").at("unidentifiable");
  calibrated.unidentifiable = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(calibrated.parameters.size()),
                                                    static_cast<Eigen::Index>(combinations.size()));
  for (std::size_t k = 0; k < combinations.size(); ++k) {
    for (const auto& [name, coefficient] : combinations[k].at("motion").items()) {
      calibrated.unidentifiable(places.at(name), static_cast<Eigen::Index>(k)) = coefficient;
    }
  }
  return calibrated;
}

}  // namespace artcal
