#include "acquisition/point_cloud/pcd/lzf.h"

#include <algorithm>

namespace artcal {

// A control byte below 32 is followed by one more than so many bytes as they are. Any other repeats what was
// written before: 3 bits of length (7: one more byte of it), 13 bits of distance, both less than they mean.
std::optional<std::string> lzf_decompress(std::string_view compressed, std::size_t size) {
  if (size / lzf_most_per_byte > compressed.size()) {
    return std::nullopt;
  }
  std::string out;
  out.reserve(size);
  std::size_t at = 0;
  const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(compressed[i])); };
  while (at < compressed.size()) {
    const std::size_t control = byte(at++);
    if (control < 32) {
      const std::size_t length = control + 1;
      if (length > compressed.size() - at || length > size - out.size()) {
        return std::nullopt;
      }
      out.append(compressed, at, length);
      at += length;
      continue;
    }
    std::size_t length = control >> 5;
    if (compressed.size() - at < (length == 7 ? 2u : 1u)) {
      return std::nullopt;
    }
    length += length == 7 ? byte(at++) : 0;
    length += 2;
    const std::size_t distance = ((control & 31) << 8) + byte(at++) + 1;
    if (distance > out.size() || length > size - out.size()) {
      return std::nullopt;
    }
    // What is repeated may overlap what it makes: a distance of one repeats one byte.
    for (std::size_t from = out.size() - distance; length > 0; --length, ++from) {
      out.push_back(out[from]);
    }
  }
  return out.size() == size ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace artcal
