#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "acquisition/arm/arm.h"
#include "artefacts/artefact/artefact.h"

namespace artcal {

/// What a touch is of, and where the arm's file has its tip.
struct Touch {
  std::string artefact, placement, feature;
  int probe = 0;  ///< into Arm::probes
  Eigen::Vector3d tip_in_base = Eigen::Vector3d::Zero();
};

/// Compares each touch with what is known of its feature: the earlier touches in the placement, and the certified
/// distances. By the nominal arm, so that it shows mistakes of millimetres, not the arm's errors.
class TouchCheck {
 public:
  TouchCheck(const Arm& arm, std::vector<Artefact> artefacts) : arm_(arm), artefacts_(std::move(artefacts)) {}

  struct Said {
    std::string note;     ///< "+0.012 mm from the ball of the touches before"; empty where nothing is known yet
    std::string warning;  ///< what cannot be the arm's error; else empty
  };
  Said add(const Touch& touch);
  void undo() { touches_.pop_back(); }

  /// Distance from a certified ball, seat or plane by its earlier touches, mm; of the last touch.
  [[nodiscard]] std::optional<double> deviation_of_last() const;

 private:
  [[nodiscard]] const CertifiedFeature* feature_of(const Touch& touch) const;
  [[nodiscard]] Eigen::Matrix3Xd tips_of(const Touch& touch, bool with_last) const;
  [[nodiscard]] std::optional<Eigen::Vector3d> centre_of(const Touch& touch) const;
  void compare_distances(Said& said) const;

  Arm arm_;
  std::vector<Artefact> artefacts_;
  std::vector<Touch> touches_;
};

}  // namespace artcal
