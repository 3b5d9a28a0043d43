#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "acquisition/point_cloud/binary_columns.h"
#include "core/error.h"

namespace artcal {

/// One property of a PLY element: a number, or a list of them behind its length.
struct PlyProperty {
  std::string name;
  NumberType type = NumberType::Float32;
  std::optional<NumberType> length;  ///< of a list: the type of its length
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;

  [[nodiscard]] bool has_lists() const;
  /// Bytes of one record. REQUIRES: no lists.
  [[nodiscard]] std::size_t record_size() const;
};

enum class PlyData { Ascii, LittleEndian, BigEndian };

/// What a PLY file says of itself before its data, not checked against the file's size.
struct PlyHeader {
  std::vector<PlyElement> elements;
  PlyData data = PlyData::Ascii;
  std::size_t body = 0;  ///< offset of the first byte after end_header's line
  int lines = 0;         ///< up to and with end_header
};

/// Whether the bytes begin as a PLY does.
bool looks_like_ply(std::string_view bytes);

/// Reads the header (PLY 1.0). `path` is for messages.
Expected<PlyHeader> read_ply_header(std::string_view bytes, const std::string& path);

}  // namespace artcal
