#pragma once

#include <string>

#include "acquisition/arm/arm.h"
#include "acquisition/arm/parameters.h"
#include "core/toml/toml_document.h"

namespace artcal {

/// The keys of a [[joint]] of arm.toml that say what the joint does beside turning: its JointErrors and the mass of
/// its link. `angle` is the file's unit. Each error has a key in the file's or in radians and one in the field's
/// unit (cos_q or cos_q_arcsec, gain or gain_ppm, …), of which one may be stated. Whatever is wrong is noted in the
/// table.
void read_joint_errors(TomlTable& table, double angle, Joint& joint);

/// More of an error (ParameterKind from Cosine1 on) than any joint has that works: an arm file that states more is
/// refused. In the parameter's unit.
double most_of(ParameterKind joint_error);

/// What of it is not zero, a line each, with every digit, in an arm file whose unit is rad.
std::string joint_errors_text(const Joint& joint);

/// The key gravity_m_s2; without it the arm keeps its own.
void read_gravity(TomlTable& root, Arm& arm);

/// The keys of arm.toml that go with them: gravity_m_s2 and reference_temperature_C.
void read_surroundings(TomlTable& root, Arm& arm);

/// These, where an arm has errors that ask for them or where they are not the usual ones.
std::string surroundings_text(const Arm& arm);

}  // namespace artcal
