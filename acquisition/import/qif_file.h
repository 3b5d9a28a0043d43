#pragma once

#include "acquisition/import/imported_readings.h"

namespace artcal {

/// Whether the text is a QIF document (ANSI QIF, ISO 23952): XML whose root is QIFDocument.
bool is_qif_file(const TextFile& file);

/// The measured coordinates of a QIF 3 document: the points of its measured features, with the tip's radius where the
/// file states it, and fitted spheres, circles and cylinders as a check; in a document without points the places of its
/// fitted points, spheres and circles. Results of several parts become repeats.
///
/// Bad input: no XML, another version; a unit of lengths other than m, mm, um or in; points of different tips, or some
/// compensated and some not; what qif_points.h and qif_features.h refuse; nothing measured.
Expected<ImportedReadings> import_qif(const TextFile& file);

}  // namespace artcal
