#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "acquisition/point_cloud/cloud_builder.h"

namespace artcal {

/// How a number is stored in a binary file.
enum class NumberType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };

std::size_t size_of(NumberType type);
/// Whether every such number is exact as a double.
bool is_exact_as_double(NumberType type);

/// One column of a binary table: where its first number is and how far it is to the next record's.
struct BinaryColumn {
  const char* first = nullptr;
  std::size_t stride = 0;
  NumberType type = NumberType::Float32;
};

enum class ByteOrder { Little, Big };

/// One number. REQUIRES: its bytes are there.
double read_number(const char* first, NumberType type, ByteOrder order);

/// Hands `count` records of these columns to the builder.
/// REQUIRES: every column's bytes are there, and its type is exact as a double.
void add_records(const std::vector<BinaryColumn>& columns, std::size_t count, ByteOrder order, CloudBuilder& builder);

}  // namespace artcal
