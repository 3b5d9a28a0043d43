#pragma once

#include "acquisition/point_cloud/read_cloud.h"
#include "core/files/file_bytes.h"

namespace artcal {

/// The points of a table in text; read_cloud.h says which columns they are taken from.
Expected<ReadCloud> parse_xyz(const FileBytes& file, const CloudUnits& units, const TextColumns& columns);

}  // namespace artcal
