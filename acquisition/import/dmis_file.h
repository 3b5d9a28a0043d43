#pragma once

#include "acquisition/import/imported_readings.h"

namespace artcal {

/// Whether the text is DMIS (ANSI/DMSC 105.0-1, ISO 22093): it has a statement DMISMN/, …=FEAT/ or PTMEAS/.
bool is_dmis_file(const TextFile& file);

/// The measured coordinates of a DMIS file. `points_are_measured` false: of each actual feature FA(name)=FEAT/… that
/// has a place (POINT, EDGEPT, SPHERE, CIRCLE) that place. True: each PTMEAS between MEAS and ENDMES as a reading of
/// the feature that it measures, and actual spheres, circles and cylinders as a check.
///
/// Bad input: nothing measured (nominal features F(name) and the PTMEAS of a program are targets, not results); PTMEAS
/// that are their feature's nominal place digit by digit; polar coordinates; another number of PTMEAS than MEAS states;
/// another coordinate system or another PRCOMP between two of the readings; a unit that is not read, or two of them.
Expected<ImportedReadings> import_dmis(const TextFile& file, bool points_are_measured);

}  // namespace artcal
