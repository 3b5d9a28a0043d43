#include "acquisition/point_cloud/ply_file.h"

#include <algorithm>

#include <fmt/format.h>

#include "acquisition/point_cloud/ply_header.h"
#include "acquisition/point_cloud/promised_rows.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

/// A file on its way to a cloud.
struct Ply {
  const FileBytes& file;
  std::string path;
  PlyHeader header;
  const PlyElement* vertex = nullptr;  // in header
  CloudColumns columns;                // which of vertex's properties are x, y, z, q1 … qn
  std::vector<std::string> warnings;
};

tl::unexpected<Error> too_short(const Ply& ply, const PlyElement& element) {
  const std::string what = &element == ply.vertex ? "points" : "records of the element " + in_quotes(element.name);
  return bad_input(
      fmt::format("the header promises {} {}, but the file ends before that; is it truncated?", element.count, what),
      ply.path);
}

Expected<void> find_vertex(Ply& ply, const CloudUnits& units) {
  for (const PlyElement& element : ply.header.elements) {
    if (element.name == "vertex" && ply.vertex != nullptr) {
      return bad_input("the element vertex is there twice", ply.path);
    }
    ply.vertex = element.name == "vertex" ? &element : ply.vertex;
  }
  if (ply.vertex == nullptr) {
    return bad_input("the header has no element vertex, where the points of a PLY file are", ply.path);
  }
  if (ply.vertex->has_lists()) {
    return bad_input("the element vertex has a list among its properties, which is not read; export without it",
                     ply.path);
  }
  std::vector<std::string> names;
  for (const PlyProperty& property : ply.vertex->properties) {
    names.push_back(property.name);
  }
  return find_cloud_columns(names, units, ply.path, ply.warnings).map([&](CloudColumns columns) {
    ply.columns = std::move(columns);
  });
}

Expected<PointCloud> read_ascii(Ply& ply, const CloudUnits& units) {
  const std::string_view body = std::string_view(ply.file.bytes).substr(ply.header.body);
  TextRows rows(body, ply.path, ply.header.lines + 1, TextRows::Separator::Blanks);
  rows.allow_quotes();
  for (const PlyElement& before : ply.header.elements) {
    if (&before == ply.vertex) {
      break;
    }
    for (std::size_t i = 0; i < before.count; ++i) {
      if (!rows.next()) {
        return too_short(ply, before);
      }
    }
  }
  const std::size_t width = ply.vertex->properties.size();
  if (ply.vertex->count > (rows.rest().size() + 1) / (2 * width)) {
    return too_short(ply, *ply.vertex);
  }
  CloudBuilder builder(units, ply.columns.size(), ply.vertex->count);
  const auto taken = take_promised_rows(rows, ply.columns, width, ply.vertex->count, builder);
  if (!taken) {
    return tl::unexpected(taken.error());
  }
  if (*taken < ply.vertex->count) {
    return too_short(ply, *ply.vertex);
  }
  if (ply.vertex == &ply.header.elements.back() && rows.next()) {
    return bad_input(fmt::format("the header promises {} points, but the file goes on after them", ply.vertex->count),
                     rows.where());
  }
  const auto end = rows.check_end();
  if (!end) {
    return tl::unexpected(end.error());
  }
  ply.warnings.insert(ply.warnings.end(), end->begin(), end->end());
  return std::move(builder).finish(ply.file, std::move(ply.warnings));
}

// Walks over the records of an element that stands before the points; `at` moves behind them. False where
// the file ends first.
bool skip_element(std::string_view bytes, ByteOrder order, const PlyElement& element, std::size_t& at) {
  const auto skip = [&](std::size_t size) {
    if (size > bytes.size() - at) {
      return false;
    }
    at += size;
    return true;
  };
  if (!element.has_lists()) {
    return skip(element.count * element.record_size());
  }
  for (std::size_t i = 0; i < element.count; ++i) {
    for (const PlyProperty& property : element.properties) {
      std::size_t items = 1;
      if (property.length) {
        const char* const first = bytes.data() + at;
        if (!skip(size_of(*property.length))) {
          return false;
        }
        const double length = read_number(first, *property.length, order);
        if (!(length >= 0.0)) {
          return false;
        }
        items = static_cast<std::size_t>(length);
      }
      if (!skip(items * size_of(property.type))) {
        return false;
      }
    }
  }
  return true;
}

Expected<PointCloud> read_binary(Ply& ply, const CloudUnits& units, ByteOrder order) {
  const std::string_view bytes = ply.file.bytes;
  std::size_t at = ply.header.body;
  for (const PlyElement& before : ply.header.elements) {
    if (&before == ply.vertex) {
      break;
    }
    if (!skip_element(bytes, order, before, at)) {
      return too_short(ply, before);
    }
  }
  const std::size_t stride = ply.vertex->record_size();
  if (ply.vertex->count > (bytes.size() - at) / stride) {
    return too_short(ply, *ply.vertex);
  }
  const std::size_t left = bytes.size() - at - ply.vertex->count * stride;
  if (ply.vertex == &ply.header.elements.back() && left > 0) {
    ply.warnings.push_back(fmt::format(
        "{} bytes follow the last point and were not read; the header promises {} points", left, ply.vertex->count));
  }
  std::vector<std::size_t> offsets{0};
  for (const PlyProperty& property : ply.vertex->properties) {
    offsets.push_back(offsets.back() + size_of(property.type));
  }
  std::vector<BinaryColumn> columns;
  for (const std::size_t column : ply.columns) {
    columns.push_back({bytes.data() + at + offsets[column], stride, ply.vertex->properties[column].type});
  }
  CloudBuilder builder(units, columns.size(), ply.vertex->count);
  add_records(columns, ply.vertex->count, order, builder);
  return std::move(builder).finish(ply.file, std::move(ply.warnings));
}

}  // namespace

Expected<PointCloud> parse_ply(const FileBytes& file, const CloudUnits& units) {
  const std::string path = file.path.string();
  auto header = read_ply_header(file.bytes, path);
  if (!header) {
    return tl::unexpected(header.error());
  }
  Ply ply{file, path, std::move(*header), nullptr, {}, {}};
  if (auto found = find_vertex(ply, units); !found) {
    return tl::unexpected(found.error());
  }
  switch (ply.header.data) {
    case PlyData::Ascii: return read_ascii(ply, units);
    case PlyData::LittleEndian: return read_binary(ply, units, ByteOrder::Little);
    case PlyData::BigEndian: break;
  }
  return read_binary(ply, units, ByteOrder::Big);
}

}  // namespace artcal
