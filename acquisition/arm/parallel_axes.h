#pragma once

#include <cstddef>
#include <string>

#include "acquisition/arm/arm.h"

namespace artcal {

/// Whether the joint's link (in modified DH the one before it) joins two axes that are parallel to 5 degrees.
bool joins_parallel_axes(const Arm& arm, std::size_t joint);

/// Which neighbouring axes of the arm are nearly parallel, such as "axes 2 and 3 (0.06 deg)"; empty if none are.
/// Without Hayati's angle between them Denavit and Hartenberg's parameters change without bound there.
std::string parallel_axes(const Arm& arm);

/// The same arm with Hayati's β at every link that joins nearly parallel axes, as a parameter (Hayati, Mirmirani 1985).
/// Where d along such an axis is larger than the arm's reach, the parameters of the link and of the next joint are
/// replaced by those of the same two axes with d = 0: every tip stays where it is, to rounding. An arm that expands or
/// bends keeps its numbers, because its lengths and torques belong to the links as they are stated.
Arm with_hayati_angles(Arm arm);

}  // namespace artcal
