#pragma once

#include <string_view>

#include "acquisition/point_cloud/read_cloud.h"
#include "core/files/file_bytes.h"

namespace artcal {

/// Any cloud from bytes that are in memory; `file.path` names them in messages and as the cloud's input.
Expected<PointCloud> parse_point_cloud(const FileBytes& file, const CloudUnits& units);
Expected<ReadCloud> parse_cloud(const FileBytes& file, const CloudUnits& units, const TextColumns& columns);

/// One reader a format; point_cloud.h says what each takes.
Expected<PointCloud> parse_pcd(const FileBytes& file, const CloudUnits& units);
Expected<PointCloud> parse_ply(const FileBytes& file, const CloudUnits& units);
Expected<ReadCloud> parse_ptx(const FileBytes& file, const CloudUnits& units);
Expected<ReadCloud> parse_obj(const FileBytes& file, const CloudUnits& units);
Expected<ReadCloud> parse_stl(const FileBytes& file, const CloudUnits& units);
Expected<ReadCloud> parse_xyz(const FileBytes& file, const CloudUnits& units, const TextColumns& columns);

/// Whether the bytes begin as this format does. PTX: two lines of a whole number and one of three numbers. OBJ: nothing
/// but its keywords until the first vertex. STL: `solid` and a facet, or a size that is that of its number of
/// triangles.
bool looks_like_pcd(std::string_view bytes);
bool looks_like_ply(std::string_view bytes);
bool looks_like_ptx(std::string_view bytes);
bool looks_like_obj(std::string_view bytes);
bool looks_like_stl(std::string_view bytes);

/// The name of a format whose fields are known, PCD, PLY, PTX, OBJ or STL, by the bytes; empty for a table in text.
std::string_view cloud_format_name(std::string_view bytes);

}  // namespace artcal
