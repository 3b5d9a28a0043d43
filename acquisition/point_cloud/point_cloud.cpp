#include "acquisition/point_cloud/point_cloud.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "acquisition/coincidence/coincident_points.h"
#include "acquisition/point_cloud/cloud_formats.h"
#include "acquisition/point_cloud/cloud_limits.h"
#include "core/files/size_limits.h"

namespace artcal {
namespace {

// Formats of scans that are not read, by their first bytes.
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

constexpr std::array<std::pair<std::string_view, std::string_view>, 7> others{{{"LASF", "LAS"},
                                                                               {"ASTM-E57", "E57"},
                                                                               {"\xFF\xFE", "text in UTF-16"},
                                                                               {"\xFE\xFF", "text in UTF-16"},
                                                                               {"PK\x03\x04", "a ZIP or XLSX archive"},
                                                                               {"\x1f\x8b", "compressed with gzip"},
                                                                               {"solid ", "STL"}}};

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
  for (const auto& [start, format] : others) {
    if (file.bytes.starts_with(start)) {
      return bad_input(fmt::format("the file looks like {}, which is not read; export it as PLY, PCD or text", format),
                       name);
    }
  }
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

Expected<ReadCloud> parse_within(const FileBytes& file, const CloudUnits& units, const TextColumns& columns,
                                 const CloudLimits& limits) {
  if (file.bytes.starts_with(byte_order_mark)) {
    return parse_within({file.path, file.bytes.substr(byte_order_mark.size()), file.sha256}, units, columns, limits);
  }
  const bool ply = looks_like_ply(file.bytes);
  if (!ply && !looks_like_pcd(file.bytes)) {
    return check_text(file).and_then([&] { return parse_xyz(file, units, columns); });
  }
  if (columns) {
    return bad_input("columns are stated by number, but the file is PCD or PLY, which names its fields; leave them out",
                     file.path.string());
  }
  return (ply ? parse_ply(file, units) : parse_pcd(file, units, limits)).map([](PointCloud&& cloud) {
    return ReadCloud{std::move(cloud), "the fields x, y, z"};
  });
}

}  // namespace

Expected<ReadCloud> parse_cloud(const FileBytes& file, const CloudUnits& units, const TextColumns& columns) {
  return parse_within(file, units, columns, {});
}

Expected<ReadCloud> read_cloud(const std::filesystem::path& path, const CloudUnits& units, const TextColumns& columns) {
  return read_cloud(path, units, columns, {});
}

Expected<ReadCloud> read_cloud(const std::filesystem::path& path, const CloudUnits& units, const TextColumns& columns,
                               const CloudLimits& limits) {
  return read_file_bytes(path, largest::points, "a point file").and_then([&](const FileBytes& file) {
    return parse_within(file, units, columns, limits).map([](ReadCloud read) {
      drop_coincident_points(read.cloud);
      return read;
    });
  });
}

Expected<PointCloud> parse_point_cloud(const FileBytes& file, const CloudUnits& units) {
  return parse_cloud(file, units, std::nullopt).map([](ReadCloud&& read) { return std::move(read.cloud); });
}

Expected<PointCloud> read_point_cloud(const std::filesystem::path& path, const CloudUnits& units) {
  return read_cloud(path, units).map([](ReadCloud&& read) { return std::move(read.cloud); });
}

}  // namespace artcal
