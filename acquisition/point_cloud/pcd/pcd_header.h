#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "acquisition/point_cloud/binary_columns.h"
#include "core/error.h"

namespace artcal {

/// One field of a PCD record: `count` numbers of one type.
struct PcdField {
  std::string name;
  NumberType type = NumberType::Float32;
  std::size_t count = 1;
  std::size_t offset = 0;        ///< of its first byte in a record
  std::size_t first_number = 0;  ///< which number of a record it begins with
};

enum class PcdData { Ascii, Binary, BinaryCompressed };

/// What a PCD file says of itself before its points, checked against itself but not against the file's size.
struct PcdHeader {
  std::vector<PcdField> fields;
  std::size_t record_size = 0;     ///< bytes of a record
  std::size_t record_numbers = 0;  ///< numbers of a record
  std::size_t points = 0;
  std::vector<double> viewpoint;  ///< of the sensor: tx ty tz qw qx qy qz; empty where not stated
  PcdData data = PcdData::Ascii;
  std::size_t body = 0;  ///< offset of the first byte after the DATA line
  int lines = 0;         ///< up to and with the DATA line
};

/// Reads the header (PCD 0.5 to 0.7). `path` is for messages.
Expected<PcdHeader> read_pcd_header(std::string_view bytes, const std::string& path);

}  // namespace artcal
