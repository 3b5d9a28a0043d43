#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "acquisition/recording/recording.h"
#include "artefacts/artefact/artefact.h"
#include "artefacts/simulation/stand.h"
#include "artefacts/simulation/virtual_arm.h"
#include "core/rigid.h"

namespace artcal {

/// What limits of a plan keep it from taking all memory and all day.
inline constexpr int max_planned_readings = 1'000'000;
inline constexpr int max_planned_placements = 10'000;

/// Sizes of what is drawn for the true arm: standard deviations of normal errors.
struct ArmErrors {
  double length = 0.0;             ///< of a, d and tips, mm
  double angle = 0.0;              ///< of theta, alpha and beta, rad
  double eccentricity = 0.0;       ///< of both quadrature parts of each encoder's first harmonic, rad
  double second_harmonic = 0.0;    ///< the same of the second
  std::vector<std::string> exact;  ///< parameters that keep their nominal value
  double radius = 0.0;             ///< of each tip's radius, mm
  double gain = 0.0;               ///< of each joint, rad/rad
  double coupling = 0.0;           ///< of each joint but the first to the one before, rad/rad
  double compliance = 0.0;         ///< of each joint, rad/(N·mm); what is drawn below zero counts above it
  double expansion = 0.0;          ///< of each link, 1/K
};

/// Standard deviations of what the readings' numbers are off beside the encoders.
struct PlannedNoise {
  double probing = 0.0;              ///< of each coordinate of the tip, mm
  double temperature = 0.0;          ///< of a temperature reading, K
  std::optional<double> instrument;  ///< of measured lengths and coordinates, mm; absent: as the artefact states
};

/// What is true of a feature although its certificate does not say so. Lengths in mm at the reference
/// temperature, in the artefact's frame.
struct TrueFeature {
  std::optional<Eigen::Vector3d> at;
  std::optional<Eigen::Vector3d> normal;  ///< unit
  std::optional<double> radius;
};

/// An artefact with its file, and what else is true of it, a TrueFeature a feature.
struct PlannedArtefact {
  Artefact certified;
  std::vector<TrueFeature> stated;
};

/// Where an artefact stands.
struct PlannedPlacement {
  std::string name;
  int artefact = 0;
  std::optional<Rigid> base_from_artefact;  ///< absent: drawn so that all its readings can be taken
  bool upright = false;                     ///< a drawn one is turned about the vertical only
  std::optional<double> temperature;  ///< of the artefact at the first reading, °C; absent: the reference, not read
  double temperature_end = 0.0;       ///< at the last; linear between
  std::optional<double> arm_temperature;  ///< of the arm, in the same way
  double arm_temperature_end = 0.0;
  std::string where;  ///< in the plan, for messages
};

/// How points lie on a feature.
enum class TouchPattern {
  Spread,  ///< at random: on a ball's cap, on a plane's rectangle, anywhere for lengths and coordinates
  Iso25,   ///< ISO 10360's 25 points on a hemisphere
};

/// What is probed.
struct PlannedProbing {
  int artefact = 0;
  std::vector<int> features;    ///< into Artefact::features
  std::vector<int> placements;  ///< into SimulationPlan::placements
  int probe = 0;                ///< into Arm::probes
  TouchPattern pattern = TouchPattern::Spread;
  int points = 25;       ///< a feature
  bool scan = false;     ///< balls only: the points of all features go into one scan, each taken from one posture
  int orientations = 0;  ///< postures of the wrist, each of which takes all points; 0: each point has its own
  int repeats = 1;
  Eigen::Vector3d pole_in_base = Eigen::Vector3d::UnitZ();  ///< of a ball's cap
  double cap = 1.5707963267948966;                          ///< angle from the pole that points keep to, rad
  Eigen::Vector2d extent{100.0, 100.0};                     ///< of the rectangle on a plane, mm
  Eigen::Vector2d lengths{0.0, 1e9};                        ///< that the instrument measures, mm
};

/// A virtual session, complete.
struct SimulationPlan {
  std::string name;
  Arm nominal;
  VirtualArm arm;    ///< the true one, before errors are drawn
  ArmErrors errors;  ///< drawn on top
  PlannedNoise noise;
  std::vector<PlannedArtefact> artefacts;
  bool draw_artefacts = false;  ///< the true artefacts differ from their certificates by what these allow for
  std::vector<PlannedPlacement> placements;
  std::vector<PlannedProbing> probings;
  Stand stand;  ///< which the artefacts are held by; drawn placements keep to it, stated ones are refused beyond it
  std::uint64_t seed = 1;
};

/// Readings that a plan makes.
double planned_readings(const SimulationPlan& plan);

}  // namespace artcal
