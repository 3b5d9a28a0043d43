#pragma once

#include <vector>

#include <Eigen/Core>

#include "acquisition/recording/recording.h"
#include "identification/models/model_study.h"
#include "identification/problem/system.h"

namespace artcal {

/// Some columns that belong together: one effect at one joint.
struct EffectFamily {
  Effect effect = Effect::OncePerTurn;
  int joint = 0;
  int first = 0;  ///< of its columns
  int columns = 0;
};

/// What each effect would add to the readings of the joints: the columns of all families, for one reading at a time.
class EffectColumns {
 public:
  EffectColumns(const System& system, const Recording& recording);

  [[nodiscard]] const std::vector<EffectFamily>& families() const { return families_; }
  [[nodiscard]] int size() const { return size_; }

  /// Motion of the tip by a unit of each column's coefficient, 3 × size(), mm; and the change of the joint's reading
  /// behind each column (0 for Expansion). Returns where the tip is, in the base frame.
  Eigen::Vector3d at(int reading, const ForwardKinematics& kinematics, Eigen::Ref<Eigen::Matrix3Xd> tips,
                     Eigen::Ref<Eigen::VectorXd> rotations) const;

 private:
  const System& system_;
  const Recording& recording_;
  std::vector<EffectFamily> families_;
  int size_ = 0;
  double mean_temperature_ = 0.0;
  bool temperature_varies_ = false;
};

}  // namespace artcal
