#pragma once

#include "acquisition/arm/arm.h"

namespace artcal {

/// An upper bound of how far a tip gets from the first joint's far end (d along its axis), mm, which does not depend on
/// where the parameters put the frames behind it: a point anywhere on each axis keeps its distance from the points on
/// its neighbours in every posture, so that the length of the chain of such points bounds the distance between its
/// ends. The points are taken where the chain is shortest (a convex problem, by iterated weighted least squares:
/// Weiszfeld 1937; every iteration is a bound). Travels of prismatic joints are not counted.
double stretched_length(const Arm& arm);

/// A lower bound of stretched_length(), mm, from eight passes along the arm: a chain is never shorter than the straight
/// line between its ends, in whatever posture.
double least_stretched_length(const Arm& arm);

}  // namespace artcal
