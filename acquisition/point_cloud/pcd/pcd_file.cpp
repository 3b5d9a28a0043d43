#include "acquisition/point_cloud/pcd/pcd_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "acquisition/point_cloud/pcd/lzf.h"
#include "acquisition/point_cloud/pcd/pcd_header.h"
#include "acquisition/point_cloud/promised_rows.h"

namespace artcal {
namespace {

/// A file on its way to a cloud.
struct Pcd {
  const FileBytes& file;
  std::string path;
  PcdHeader header;
  CloudColumns fields;  // which of header.fields are x, y, z, q1 … qn
  std::vector<std::string> warnings;

  [[nodiscard]] std::string_view body() const { return std::string_view(file.bytes).substr(header.body); }
};

std::string promise(const PcdHeader& header) { return fmt::format("the header promises {} points", header.points); }

Expected<void> check_fields(Pcd& pcd, const CloudUnits& units) {
  std::vector<std::string> names;
  for (const PcdField& field : pcd.header.fields) {
    names.push_back(field.name);
  }
  auto found = find_cloud_columns(names, units, pcd.path, pcd.warnings);
  if (!found) {
    return tl::unexpected(found.error());
  }
  for (const std::size_t column : *found) {
    const PcdField& field = pcd.header.fields[column];
    if (field.count != 1 || !is_exact_as_double(field.type)) {
      return bad_input(
          fmt::format("the field {} has COUNT {} and SIZE {}, expected one number that a double holds exactly",
                      field.name, field.count, size_of(field.type)),
          pcd.path);
    }
  }
  pcd.fields = std::move(*found);
  return {};
}

Expected<PointCloud> read_ascii(Pcd& pcd, const CloudUnits& units) {
  const PcdHeader& header = pcd.header;
  // A number and what separates it from the next take two bytes.
  if (header.points > (pcd.body().size() + 1) / (2 * header.record_numbers)) {
    return bad_input(
        fmt::format("{}, more than {} bytes can hold; is the file truncated?", promise(header), pcd.body().size()),
        pcd.path);
  }
  TextRows rows(pcd.body(), pcd.path, header.lines + 1, TextRows::Separator::Blanks);
  rows.allow_quotes();
  CloudBuilder builder(units, pcd.fields.size(), header.points);
  CloudColumns columns;
  for (const std::size_t field : pcd.fields) {
    columns.push_back(header.fields[field].first_number);
  }
  const auto taken = take_promised_rows(rows, columns, header.record_numbers, header.points, builder);
  if (!taken) {
    return tl::unexpected(taken.error());
  }
  if (*taken < header.points) {
    return bad_input(fmt::format("{}, the file ends after {}; is it truncated?", promise(header), *taken), pcd.path);
  }
  if (rows.next()) {
    return bad_input(fmt::format("{}, but the file goes on after them", promise(header)), rows.where());
  }
  const auto end = rows.check_end();
  if (!end) {
    return tl::unexpected(end.error());
  }
  pcd.warnings.insert(pcd.warnings.end(), end->begin(), end->end());
  return std::move(builder).finish(pcd.file, std::move(pcd.warnings));
}

// `columns` of `points` records in the body, little-endian as every PCD in use.
Expected<PointCloud> gather(Pcd& pcd, const CloudUnits& units, const std::vector<BinaryColumn>& columns) {
  CloudBuilder builder(units, columns.size(), pcd.header.points);
  add_records(columns, pcd.header.points, ByteOrder::Little, builder);
  return std::move(builder).finish(pcd.file, std::move(pcd.warnings));
}

Expected<PointCloud> read_binary(Pcd& pcd, const CloudUnits& units) {
  const PcdHeader& header = pcd.header;
  const std::size_t needed = header.points * header.record_size;  // below 2^31 · 2^16
  if (needed > pcd.body().size()) {
    return bad_input(fmt::format("{} of {} bytes, {} together, but {} follow; is the file truncated?", promise(header),
                                 header.record_size, needed, pcd.body().size()),
                     pcd.path);
  }
  // PCL's own writer leaves a page of zeros behind the points.
  if (pcd.body().find_first_not_of('\0', needed) != std::string_view::npos) {
    pcd.warnings.push_back(fmt::format("{} bytes follow the last point and were not read; {}",
                                       pcd.body().size() - needed, promise(header)));
  }
  std::vector<BinaryColumn> columns;
  for (const std::size_t field : pcd.fields) {
    columns.push_back({pcd.body().data() + header.fields[field].offset, header.record_size, header.fields[field].type});
  }
  return gather(pcd, units, columns);
}

std::size_t length_at(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < sizeof(value); ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) << (8 * i);
  }
  return value;
}

// A few megabytes can stand for gigabytes of equal points.
Expected<void> check_memory(const Pcd& pcd, const CloudLimits& limits) {
  // The decompressed numbers, and x, y, z, q1 … qn and the row of each point as the cloud has them.
  const std::size_t of_a_point = pcd.header.record_size + sizeof(double) * pcd.fields.size() + sizeof(int);
  const std::size_t needed = pcd.header.points * of_a_point;  // below 2^31 · 2^17
  const std::size_t allowed = limits.allowed(pcd.file.bytes.size());
  if (needed <= allowed) {
    return {};
  }
  constexpr double mebibyte = 1024.0 * 1024.0;
  return bad_input(
      fmt::format("the file of {:.1f} MiB holds {} compressed points, which take {:.0f} MiB of memory, more "
                  "than the {:.0f} MiB that are allowed; if the file is sound, save it uncompressed (DATA "
                  "binary), or allow more with --max-memory",
                  static_cast<double>(pcd.file.bytes.size()) / mebibyte, pcd.header.points,
                  static_cast<double>(needed) / mebibyte, static_cast<double>(allowed) / mebibyte),
      pcd.path);
}

// Compressed, the numbers stand field by field: all x, then all y, and so on.
Expected<PointCloud> read_compressed(Pcd& pcd, const CloudUnits& units, const CloudLimits& limits) {
  const PcdHeader& header = pcd.header;
  const std::string_view body = pcd.body();
  if (body.size() < 8) {
    return bad_input("the file ends before the size of its compressed points; is it truncated?", pcd.path);
  }
  const std::size_t compressed = length_at(body);
  const std::size_t whole = length_at(body.substr(4));
  if (compressed > body.size() - 8) {
    return bad_input(fmt::format("{} compressed bytes are promised, but {} follow; is the file truncated?", compressed,
                                 body.size() - 8),
                     pcd.path);
  }
  if (whole != header.points * header.record_size) {
    return bad_input(
        fmt::format("{} of {} bytes, but {} bytes are compressed", promise(header), header.record_size, whole),
        pcd.path);
  }
  // What so few bytes cannot stand for at all is damaged, and is not decompressed either.
  if (whole / lzf_most_per_byte <= compressed) {
    if (auto fits = check_memory(pcd, limits); !fits) {
      return tl::unexpected(fits.error());
    }
  }
  const auto bytes = lzf_decompress(body.substr(8, compressed), whole);
  if (!bytes) {
    return bad_input("the compressed points cannot be decompressed; the file is damaged", pcd.path);
  }
  std::vector<BinaryColumn> columns;
  for (const std::size_t index : pcd.fields) {
    const PcdField& field = header.fields[index];
    columns.push_back({bytes->data() + field.offset * header.points, size_of(field.type), field.type});
  }
  return gather(pcd, units, columns);
}

void warn_of_viewpoint(Pcd& pcd) {
  const std::vector<double> origin{0, 0, 0, 1, 0, 0, 0};
  if (!pcd.header.viewpoint.empty() && pcd.header.viewpoint != origin) {
    pcd.warnings.emplace_back("the file has a VIEWPOINT other than the origin; it is not applied to the points");
  }
}

}  // namespace

std::size_t CloudLimits::allowed(std::size_t file_size) const {
  constexpr std::size_t least = std::size_t{256} << 20;
  constexpr std::size_t times_the_file = 16;
  return max_memory > 0 ? max_memory : std::max(least, times_the_file * file_size);
}

Expected<PointCloud> parse_pcd(const FileBytes& file, const CloudUnits& units, const CloudLimits& limits) {
  const std::string path = file.path.string();
  auto header = read_pcd_header(file.bytes, path);
  if (!header) {
    return tl::unexpected(header.error());
  }
  Pcd pcd{file, path, std::move(*header), {}, {}};
  if (auto checked = check_fields(pcd, units); !checked) {
    return tl::unexpected(checked.error());
  }
  warn_of_viewpoint(pcd);
  switch (pcd.header.data) {
    case PcdData::Ascii: return read_ascii(pcd, units);
    case PcdData::Binary: return read_binary(pcd, units);
    case PcdData::BinaryCompressed: break;
  }
  return read_compressed(pcd, units, limits);
}

}  // namespace artcal
