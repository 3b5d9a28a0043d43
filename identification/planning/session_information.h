#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "acquisition/arm/arm.h"
#include "acquisition/arm/parameters.h"
#include "artefacts/artefact/artefact.h"
#include "identification/planning/goal.h"

namespace artcal {

/// A reading as a session in progress has it.
struct SessionReading {
  int artefact = 0;  ///< into the artefacts
  int feature = 0;   ///< into Artefact::features
  std::string placement;
  int probe = 0;  ///< into Arm::probes
  Eigen::VectorXd joints;
};

/// What the readings of a session determine, linearised at the nominal arm and brought up to date with each reading: a
/// reading is folded into the triangle of its placement by Householder reflections, so that the work does not grow with
/// the number of readings. Columns are the unknowns of the placement (centres, planes, a pose where coordinates are
/// certified) and, common to all, the errors of certified distances and the arm's parameters (parameters_of()) in
/// physical units. Every parameter counts as known to 10 units beforehand.
///
/// A ball's touches count from the fourth on, a plane's from the third: then the nominal arm has its place, which stays
/// what their directions are taken from. The radius of a ball counts as exact, or as an unknown of its placement.
class SessionInformation {
 public:
  /// `encoder` is the standard deviation of each joint, rad; `probing` that of each coordinate of the tip beside, mm.
  SessionInformation(const Arm& nominal, std::vector<Artefact> artefacts, double encoder, double probing,
                     std::uint64_t seed = 1);

  void add(const SessionReading& reading);

  [[nodiscard]] int parameters() const { return static_cast<int>(parameters_.size()); }
  /// Number of independent combinations of the arm's parameters that the readings determine.
  [[nodiscard]] int rank() const;
  /// Standard uncertainty of 200 lengths between random postures, as the identified arm will measure them, mm.
  [[nodiscard]] PredictedU u_of_length() const;

 private:
  /// What is known of a feature in a placement.
  struct Place {
    std::vector<SessionReading> waiting;  ///< touches until it is known
    bool is_known = false;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< a centre, or a point of a plane, in the base frame, mm
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    double spread = 1.0;  ///< of a plane's touches, mm: the unit of its tilts
  };
  struct Placement {
    std::map<int, Place> places;                 ///< by feature
    Eigen::MatrixXd triangle;                    ///< by [own | common]; no rows yet where empty
    std::optional<Eigen::Vector3d> pose_origin;  ///< what a pose's rotation is about, mm
    Eigen::MatrixXd of_common;  ///< the own columns eliminated; kept up to date while another placement is read
  };
  using Key = std::pair<int, std::string>;  // artefact and placement

  [[nodiscard]] Eigen::Index own_columns(int artefact) const;
  [[nodiscard]] Eigen::Index first_column(int artefact, int feature) const;
  [[nodiscard]] Eigen::Index common() const { return errors_ + parameters(); }
  void locate(const SessionReading& reading, Place& place) const;
  void fold(const SessionReading& reading, const Place& place, Placement& placement) const;
  void fold_certified(const SessionReading& reading, Placement& placement) const;
  void fold_rows(const Eigen::MatrixXd& rows, Placement& placement) const;
  [[nodiscard]] Eigen::MatrixXd eliminated(const Key& key, const Placement& placement) const;
  [[nodiscard]] Eigen::MatrixXd information() const;
  void turn_to(const Key& key);

  Arm arm_;
  std::vector<Artefact> artefacts_;
  double encoder_, probing_;
  std::vector<Parameter> parameters_;
  Eigen::VectorXd scale_;
  std::map<std::pair<int, int>, Eigen::Index> error_of_;  ///< artefact and distance → common column
  Eigen::Index errors_ = 0;
  Eigen::MatrixXd lengths_;       ///< a column each: derivative by the common columns
  Eigen::VectorXd length_noise_;  ///< variance that the readings of the length itself bring, mm²
  std::map<Key, Placement> placements_;
  Key current_;
  bool has_current_ = false;
  Eigen::MatrixXd others_;  ///< triangle of all placements but the current one
};

}  // namespace artcal
