#pragma once

#include <string_view>

#include "acquisition/point_cloud/read_cloud.h"
#include "core/files/file_bytes.h"

namespace artcal {

/// The vertices of a Wavefront OBJ, as read_cloud.h has it.
Expected<ReadCloud> parse_obj(const FileBytes& file, const CloudUnits& units);

/// Whether the bytes are nothing but the keywords of an OBJ until the first vertex.
bool looks_like_obj(std::string_view bytes);

}  // namespace artcal
