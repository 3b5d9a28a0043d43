#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "acquisition/arm/arm.h"
#include "core/error.h"
#include "core/random.h"
#include "identification/uncertainty/uncertain_arm.h"

namespace artcal {

/// What an identified arm is asked to measure, so that it can be seen how uncertain the answers are: fixed postures,
/// read anew in every trial.
struct MeasuringPlan {
  struct Point {
    std::string name;
    Eigen::VectorXd q;  ///< rad
  };
  struct Length {
    std::string name;
    std::array<Eigen::VectorXd, 2> q;
  };
  /// 25 points on a sphere, each in a posture of its own.
  struct Ball {
    std::string name;
    Eigen::Vector3d centre_in_base;
    std::vector<Eigen::VectorXd> q;
  };
  /// Five points on a sphere in each of five orientations, orientation after orientation.
  struct Articulation {
    std::string name;
    std::vector<Eigen::VectorXd> q;
  };
  int probe = 0;
  std::vector<Point> points;
  std::vector<Length> lengths;
  std::vector<Ball> balls;
  std::vector<Articulation> articulations;
};

struct MeasuringRequest {
  int probe = 0;
  std::vector<Eigen::Vector3d> points_in_base;  ///< asked for, mm; without any, places of the working volume are drawn
  int points = 6;                               ///< drawn, where none are asked for
  int lengths = 4;                              ///< drawn, of each of five sizes (see survey())
  int balls = 3;
  double diameter = 25.0;  ///< of the balls, mm
  std::uint64_t seed = 1;
};

/// Draws places and postures; the lengths between points that were asked for, one after the other, come first. An arm
/// without end stops is assumed. Bad input: a point asked for that the arm does not reach.
Expected<MeasuringPlan> plan_measuring(const Arm& arm, const MeasuringRequest& request);

/// A number that a Monte Carlo follows.
struct Measurand {
  enum class Kind {
    Parameter,
    Coordinate,  ///< of a point in the base frame, without the noise of reading it
    Length,      ///< between two points, without the noise of reading them
    EUni,        ///< E_Uni of the same two points, each read once: length measured less the true one
    PSize,       ///< P_Size: diameter of a ball from the least-squares sphere of 25 points read, less the true one;
                 ///< the tip's own diameter, as the arm has it, is taken off
    LDia,        ///< L_Dia: diameter of the minimum sphere around the centres from five orientations
  };
  Kind kind = Kind::Parameter;
  std::string name;
  std::string_view unit = "mm";    ///< of all its numbers; of a parameter Parameter::unit()
  double estimate = 0.0;           ///< of the identified arm; of the last three 0
  std::optional<double> u_linear;  ///< first order; absent for LDia, which is none
};

/// What an arm measures by a plan, being at its reference temperature. Const: threads share it.
class Measuring {
 public:
  Measuring(MeasuringPlan plan, const UncertainArm& arm, double encoder, double probing);

  [[nodiscard]] const std::vector<Measurand>& quantities() const { return quantities_; }
  /// The quantities' values as `arm` has them, its readings with noise from `random`; in order of quantities(). Not a
  /// number where a sphere cannot be fitted.
  void measure(const Arm& arm, RandomStream& random, double* values) const;

 private:
  MeasuringPlan plan_;
  std::vector<Measurand> quantities_;
  std::vector<double> true_values_;  // that are taken off, a quantity each
  double encoder_, probing_;
  // Of all postures: points, both ends of lengths, balls, articulations.
  struct Posture {
    std::vector<double> angles, sines;
  };
  std::vector<Posture> postures_;
};

}  // namespace artcal
