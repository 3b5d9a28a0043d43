#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "acquisition/import/delimited_text.h"
#include "core/error.h"

namespace artcal {

/// A feature as the other program fitted it to its points: a check of what was understood. In the file's unit.
struct ReportedFeature {
  enum class Kind { Sphere, Circle, Cylinder };
  std::string name;
  Kind kind = Kind::Sphere;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< its centre, or a point of its axis
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();   ///< of a cylinder, normal of a circle; of any length but zero
  double diameter = 0.0;
};

/// Readings of another program's file as a table of readings.csv. Numbers keep their digits and their unit.
struct ImportedReadings {
  std::string format;                          ///< what the file was taken for
  std::vector<std::string> columns;            ///< columns of readings.csv
  std::vector<std::vector<std::string>> rows;  ///< a field each, numbers with decimal points
  std::vector<std::string> understood;         ///< sentences: which columns were used, what was passed over
  std::string length_unit;                     ///< where the file states it; else empty
  std::string probe_radius;                    ///< of the tip whose centres these are, likewise, in that unit
  std::vector<ReportedFeature> reported;       ///< features whose points are among the rows
};

struct TextImport {
  std::string columns;  ///< stated_roles(); empty: by the header
  std::optional<Delimiter> delimiter;
  int skipped = 0;  ///< lines above the table
};

/// Reads a text table: any delimiter, decimal points or commas, quotes, a header or stated columns.
///
/// Bad input: what split_text() refuses; no header where no columns are stated; decimal points and decimal commas in
/// one file; a field that is no number where one is expected; a column for x that counts the rows.
Expected<ImportedReadings> import_text(const TextFile& file, const TextImport& options);

/// The table as readings.csv.
std::string readings_csv(const ImportedReadings& readings);

}  // namespace artcal
