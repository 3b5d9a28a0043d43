#include "acquisition/point_cloud/binary_columns.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace artcal {
namespace {

constexpr std::size_t block = 1024;  // records at a time, so that they stay in the cache between two passes

template <typename T, bool swapped>
T load(const char* at) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), at, sizeof(T));
  if constexpr (swapped) {
    std::reverse(bytes.begin(), bytes.end());
  }
  return std::bit_cast<T>(bytes);
}

template <typename T, bool swapped>
void read_column(const BinaryColumn& column, std::size_t from, std::size_t count, double* out, std::size_t out_stride) {
  const char* at = column.first + from * column.stride;
  for (std::size_t i = 0; i < count; ++i, at += column.stride, out += out_stride) {
    *out = static_cast<double>(load<T, swapped>(at));
  }
}

using Read = void (*)(const BinaryColumn&, std::size_t, std::size_t, double*, std::size_t);

template <bool swapped>
Read reader_of(NumberType type) {
  switch (type) {
    case NumberType::Int8: return read_column<std::int8_t, swapped>;
    case NumberType::UInt8: return read_column<std::uint8_t, swapped>;
    case NumberType::Int16: return read_column<std::int16_t, swapped>;
    case NumberType::UInt16: return read_column<std::uint16_t, swapped>;
    case NumberType::Int32: return read_column<std::int32_t, swapped>;
    case NumberType::UInt32: return read_column<std::uint32_t, swapped>;
    case NumberType::Int64: return read_column<std::int64_t, swapped>;
    case NumberType::UInt64: return read_column<std::uint64_t, swapped>;
    case NumberType::Float32: return read_column<float, swapped>;
    case NumberType::Float64: break;
  }
  return read_column<double, swapped>;
}

bool is_swapped(ByteOrder order) { return (order == ByteOrder::Big) != (std::endian::native == std::endian::big); }

Read reader_of(NumberType type, ByteOrder order) {
  return is_swapped(order) ? reader_of<true>(type) : reader_of<false>(type);
}

}  // namespace

double read_number(const char* first, NumberType type, ByteOrder order) {
  double value = 0.0;
  reader_of(type, order)({first, 0, type}, 0, 1, &value, 1);
  return value;
}

std::size_t size_of(NumberType type) {
  switch (type) {
    case NumberType::Int8:
    case NumberType::UInt8: return 1;
    case NumberType::Int16:
    case NumberType::UInt16: return 2;
    case NumberType::Int32:
    case NumberType::UInt32:
    case NumberType::Float32: return 4;
    case NumberType::Int64:
    case NumberType::UInt64:
    case NumberType::Float64: break;
  }
  return 8;
}

bool is_exact_as_double(NumberType type) { return type != NumberType::Int64 && type != NumberType::UInt64; }

void add_records(const std::vector<BinaryColumn>& columns, std::size_t count, ByteOrder order, CloudBuilder& builder) {
  const std::size_t width = columns.size();
  if (std::any_of(columns.begin(), columns.end(), [](const auto& c) { return c.type == NumberType::Float32; })) {
    builder.note_single_precision();
  }
  std::vector<double> records(std::min(block, count) * width);
  for (std::size_t from = 0; from < count; from += block) {
    const std::size_t here = std::min(block, count - from);
    for (std::size_t i = 0; i < width; ++i) {
      reader_of(columns[i].type, order)(columns[i], from, here, records.data() + i, width);
    }
    builder.add(records.data(), here);
  }
}

}  // namespace artcal
