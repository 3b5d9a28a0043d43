#pragma once

#include <cstddef>
#include <vector>

namespace artcal {

/// Asks the system for large pages where `bytes` at `data` will lie, before they are written: of hundreds of megabytes
/// the kernel hands out each page of four kilobytes by itself, which takes longer than to fill it. Only asks, for a
/// megabyte or more; the content stays.
void prefer_large_pages(void* data, std::size_t bytes);

/// A vector of so many values, made so.
template <typename T>
std::vector<T> large_vector(std::size_t size) {
  std::vector<T> values;
  values.reserve(size);
  prefer_large_pages(values.data(), size * sizeof(T));
  values.resize(size);
  return values;
}

}  // namespace artcal
