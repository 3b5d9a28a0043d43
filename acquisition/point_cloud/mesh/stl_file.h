#pragma once

#include <string_view>

#include "acquisition/point_cloud/read_cloud.h"
#include "core/files/file_bytes.h"

namespace artcal {

/// The vertices of the triangles of an STL, in text or binary, each once (read_cloud.h).
Expected<ReadCloud> parse_stl(const FileBytes& file, const CloudUnits& units);

/// Whether the bytes begin with `solid` and a facet, or their size is that of the number of triangles that they state.
bool looks_like_stl(std::string_view bytes);

}  // namespace artcal
