#include "identification/uncertainty/correlated_errors.h"

#include <map>

#include "identification/least_squares/rows.h"
#include "identification/monte_carlo/arrow_factor.h"
#include "identification/problem/certified_distances.h"

namespace artcal {
namespace {

/// Answers to one error that several distances share: of the shared numbers, then the arm's.
class ArtefactParameterError {
 public:
  void add(const Eigen::VectorXd& answer, Eigen::Index arm_size) {
    const auto arm = answer.tail(arm_size);
    if (sum_.size() == 0) {
      sum_ = answer;
      squares_ = answer.cwiseAbs2();
      of_arm_ = arm * arm.transpose();
    } else {
      sum_ += answer;
      squares_ += answer.cwiseAbs2();
      of_arm_ += arm * arm.transpose();
    }
  }
  void add_lacking_to(CommonErrors& lacking) const {
    const Eigen::Index shared = lacking.of_shared.size();
    const auto arm = sum_.tail(lacking.of_arm.rows());
    lacking.of_shared += (sum_.cwiseAbs2() - squares_).head(shared);
    lacking.of_arm += arm * arm.transpose() - of_arm_;
  }

 private:
  Eigen::VectorXd sum_, squares_;
  Eigen::MatrixXd of_arm_;
};

std::vector<const CertifiedDistance*> all_certified(const Constraints& constraints) {
  std::vector<const CertifiedDistance*> all;
  for (const Artefact& artefact : constraints.artefacts) {
    for (const CertifiedDistance& distance : artefact.distances) {
      all.push_back(&distance);
    }
  }
  return all;
}

}  // namespace

Expected<CommonErrors> correlated_certificate_errors(const System& system, const ArmFit& fit,
                                                     const Recording& recording) {
  const Constraints& constraints = *system.constraints;
  const int common = system.shared_size() + system.arm_size();
  CommonErrors lacking{Eigen::VectorXd::Zero(system.shared_size()),
                       Eigen::MatrixXd::Zero(system.arm_size(), system.arm_size())};
  if (constraints.binding_distance_count() == 0) {
    return lacking;
  }
  const auto factor = ArrowFactor::of(fit.linearisation);
  if (!factor) {
    return tl::unexpected(factor.error());
  }
  Eigen::VectorXd scale = Eigen::VectorXd::Ones(common);
  scale.tail(system.arm_size()) = system.scale;
  const auto certificates = certified_distances(constraints);
  const auto certified = all_certified(constraints);
  const auto above = above_reference(constraints, recording);
  std::map<int, ArtefactParameterError> of_certificates;
  std::map<int, ArtefactParameterError> of_expansions;
  for (std::size_t d = 0; d < constraints.distances.size(); ++d) {
    const DistanceConstraint& distance = constraints.distances[d];
    if (!distance.binds || certificates[d] < 0) {
      continue;
    }
    const FeatureConstraint& first = constraints.features[distance.first];
    Eigen::VectorXd slope(constraints.groups[*first.group].size);
    weighted_distance(distance, constraints, fit.counted.distances[d], state_of(first, fit.unknowns).values.data(),
                      slope.data());
    // δ = (RᵀR)⁻¹ Jᵀ w·(change of the length), in mm and rad per mm.
    const Eigen::VectorXd answer =
        fit.counted.distances[d] * scale.cwiseProduct(factor->solve_for_common(*first.group, slope));
    const CertifiedDistance& certificate = *certified[certificates[d]];
    of_certificates[certificates[d]].add(first.expansion * certificate.u * answer, system.arm_size());
    const double u_expansion = constraints.artefacts[first.artefact].u_expansion;
    if (u_expansion > 0.0) {
      of_expansions[first.artefact].add(certificate.value * above[distance.first] * u_expansion * answer,
                                        system.arm_size());
    }
  }
  for (const auto* errors : {&of_certificates, &of_expansions}) {
    for (const auto& [key, error] : *errors) {
      error.add_lacking_to(lacking);
    }
  }
  return lacking;
}

}  // namespace artcal
