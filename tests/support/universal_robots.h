#pragma once

#include <array>
#include <numbers>

#include "acquisition/arm/arm.h"

/// Published kinematics of robots whose axes 2, 3 and 4 are parallel to some tenths of a degree: factory calibrations
/// whose d are hundreds of metres that cancel.
namespace artcal::test {

using Six = std::array<double, 6>;

/// Standard DH, rad and m, on the flange.
inline Arm arm_in_metres(const char* name, const Six& theta, const Six& a, const Six& d, const Six& alpha) {
  Arm arm;
  arm.name = name;
  for (std::size_t i = 0; i < 6; ++i) {
    arm.joints.push_back({.a = 1000.0 * a[i], .d = 1000.0 * d[i], .theta = theta[i], .alpha = alpha[i]});
  }
  arm.probes.push_back({"flange", Eigen::Vector3d::Zero(), 0.0, false});
  return arm;
}

/// Nominal UR10e.
inline Arm nominal_ur10e() {
  constexpr double right = std::numbers::pi / 2;
  return arm_in_metres("UR10e", {}, {0.0, -0.6127, -0.57155, 0.0, 0.0, 0.0},
                       {0.1807, 0.0, 0.0, 0.17415, 0.11985, 0.11655}, {right, 0.0, 0.0, right, -right, 0.0});
}

/// A factory calibration: Universal_Robots_ROS2_Driver, ur_calibration/doc/algorithm.rst (BSD-3-Clause).
inline Arm calibrated_ur10e() {
  return arm_in_metres(
      "UR10e, calibrated",
      {-2.4147806894359e-07, 1.60233952386695, -1.68607190752171, 0.0837331147700119, -1.01260355871158e-07,
       3.91986209186124e-08},
      {2.12234865571206e-05, 0.0193171326277006, -0.569251663611088, -4.61409023720934e-05, -6.39280053471802e-05, 0.0},
      {0.180539811714259, 439.140974079901, -446.027059806332, 7.0603368964236, 0.119811341150314, 0.115670917257426},
      {1.57014608044242, 0.0013941666682559, 0.00693818880325995, 1.56998468543761, -1.57038519649543, 0.0});
}

/// A factory calibration of a UR5 as differences from nominal values: ros-industrial-attic/ur_modern_driver, issue 179.
inline Arm calibrated_ur5() {
  constexpr double right = std::numbers::pi / 2;
  return arm_in_metres(
      "UR5, calibrated",
      {2.07750978653505926e-05, 0.96821571555565844, -1.85685385014877657, 0.888647901450376643,
       5.66106814887767484e-05, -7.46310764096455082e-05},
      {0.000393621049984383038, -0.425 + 0.184093300397451837, -0.39225 + 0.14493953300732923, -6.43297403642304399e-05,
       7.76709040084077299e-06, 0.0},
      {0.089159 + 4.00263097760228392e-05, 278.244144925623573, -183.695513914913732, 0.10915 - 94.5471513669751289,
       0.09465 + 0.000304782681775556119, 0.0823 + 0.000123737941387466743},
      {right - 0.000271624944216508624, 0.00125856505456124258, -0.00322052070697146503, right + 0.00065153016530383745,
       -right - 0.00058700465721117645, 0.0});
}

}  // namespace artcal::test
