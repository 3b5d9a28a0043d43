#include "acquisition/point_cloud/cloud_formats.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "acquisition/point_cloud/mesh/obj_file.h"
#include "acquisition/point_cloud/mesh/stl_file.h"
#include "acquisition/point_cloud/pcd/pcd_entries.h"
#include "acquisition/point_cloud/pcd/pcd_file.h"
#include "acquisition/point_cloud/ply_file.h"
#include "acquisition/point_cloud/ply_header.h"
#include "acquisition/point_cloud/ptx_file.h"
#include "acquisition/point_cloud/xyz_file.h"

namespace artcal {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

// Formats of scans that are not read, by their first bytes.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> others{{{"LASF", "LAS"},
                                                                               {"ASTM-E57", "E57"},
                                                                               {"\xFF\xFE", "text in UTF-16"},
                                                                               {"\xFE\xFF", "text in UTF-16"},
                                                                               {"PK\x03\x04", "a ZIP or XLSX archive"},
                                                                               {"\x1f\x8b", "compressed with gzip"}}};

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return extension;
}

// A cloud whose header was lost would read as a table of other columns.
Expected<void> check_text(const FileBytes& file) {
  const std::string name = file.path.string();
  if (file.bytes.find('\0') != std::string::npos) {
    return bad_input(
        "the file holds zero bytes, but begins neither as PCD nor as PLY; expected one of these or plain "
        "text",
        name);
  }
  const std::string extension = lower_extension(file.path);
  if (extension == ".pcd" || extension == ".ply") {
    return bad_input(fmt::format("the name ends in {}, but the file does not begin as such a file does", extension),
                     name);
  }
  return {};
}

Expected<void> check_known(const FileBytes& file) {
  for (const auto& [start, format] : others) {
    if (file.bytes.starts_with(start)) {
      return bad_input(fmt::format("the file looks like {}, which is not read; export it as PLY, PCD or text", format),
                       file.path.string());
    }
  }
  return {};
}

/// A format that names its coordinates or has them in one place.
struct NamedFormat {
  std::string_view name, extension;  ///< a file of that extension is of that format or is refused
  bool (*looks)(std::string_view bytes);
  Expected<ReadCloud> (*parse)(const FileBytes& file, const CloudUnits& units);
};

constexpr std::array<NamedFormat, 3> named_formats{{{"PTX", ".ptx", looks_like_ptx, parse_ptx},
                                                    {"STL", ".stl", looks_like_stl, parse_stl},
                                                    {"OBJ", ".obj", looks_like_obj, parse_obj}}};

Expected<void> check_no_columns(const FileBytes& file, const TextColumns& columns) {
  return columns ? bad_input(
                       "columns are stated by number, but the file is PCD, PLY, PTX, OBJ or STL, where the "
                       "coordinates have their place; leave them out",
                       file.path.string())
                 : Expected<void>{};
}

}  // namespace

std::string_view cloud_format_name(std::string_view bytes) {
  if (looks_like_ply(bytes)) {
    return "PLY";
  }
  if (looks_like_pcd(bytes)) {
    return "PCD";
  }
  const auto found = std::find_if(named_formats.begin(), named_formats.end(),
                                  [&](const NamedFormat& format) { return format.looks(bytes); });
  return found == named_formats.end() ? std::string_view{} : found->name;
}

Expected<ReadCloud> parse_cloud(const FileBytes& file, const CloudUnits& units, const TextColumns& columns,
                                const CloudLimits& limits) {
  if (file.bytes.starts_with(byte_order_mark)) {
    return parse_cloud({file.path, file.bytes.substr(byte_order_mark.size()), file.sha256}, units, columns, limits);
  }
  const bool ply = looks_like_ply(file.bytes);
  if (!ply && !looks_like_pcd(file.bytes)) {
    if (auto known = check_known(file); !known) {
      return tl::unexpected(known.error());
    }
    const std::string extension = lower_extension(file.path);
    for (const NamedFormat& format : named_formats) {
      if (format.looks(file.bytes) || extension == format.extension) {
        return check_no_columns(file, columns).and_then([&] { return format.parse(file, units); });
      }
    }
    return check_text(file).and_then([&] { return parse_xyz(file, units, columns); });
  }
  if (auto none = check_no_columns(file, columns); !none) {
    return tl::unexpected(none.error());
  }
  return (ply ? parse_ply(file, units) : parse_pcd(file, units, limits)).map([](PointCloud&& cloud) {
    return ReadCloud{std::move(cloud), "the fields x, y, z"};
  });
}

Expected<PointCloud> parse_point_cloud(const FileBytes& file, const CloudUnits& units) {
  return parse_cloud(file, units).map([](ReadCloud&& read) { return std::move(read.cloud); });
}

}  // namespace artcal
