#pragma once

#include <string_view>

#include "acquisition/point_cloud/read_cloud.h"
#include "core/files/file_bytes.h"

namespace artcal {

/// The points of the scans of a PTX, each moved by its scan's matrix (read_cloud.h).
Expected<ReadCloud> parse_ptx(const FileBytes& file, const CloudUnits& units);

/// Whether the bytes begin with two lines of a whole number and one of three numbers.
bool looks_like_ptx(std::string_view bytes);

}  // namespace artcal
