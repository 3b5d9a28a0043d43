#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "acquisition/point_cloud/point_cloud.h"

namespace artcal {

/// Which columns of a text are x, y and z, from 1, whatever a header says. Without it the header tells, and without a
/// header they are the first three, unless their numbers look like something else (column_shape.h).
using TextColumns = std::optional<std::array<int, 3>>;

/// A cloud and what of its file it was read from.
struct ReadCloud {
  PointCloud cloud;
  std::string columns;  ///< such as "columns 1, 2, 3 of 7, without a header"
};

/// Reads points as read_point_cloud does, and says which columns were taken. Beside the formats stated there:
///  - A byte-order mark is passed over.
///  - Text: columns may be separated by semicolons, and then numbers may have a decimal comma; 1.5D+02 is 150. A first
///    line of one whole number is the number of points (PTS), which is checked.
///  - PTX: the points of its scans, each moved by its scan's matrix; 0 0 0 in the scanner's frame is left out.
///  - Wavefront OBJ: the vertices `v`. STL in text and binary: the vertices of its triangles, each once.
///    A name in .ptx, .obj or .stl promises that format.
/// Errors (BadInput) beside those of read_point_cloud: more than three columns without a header of which the first
/// looks like a running number, a label or a time, unless `columns` are stated; columns stated for PCD, PLY, PTX, OBJ
/// or STL, or that are not there; a matrix of a PTX that is no rigid motion; free-form surfaces in an OBJ.
Expected<ReadCloud> read_cloud(const std::filesystem::path& path, const CloudUnits& units,
                               const TextColumns& columns = std::nullopt);

}  // namespace artcal
