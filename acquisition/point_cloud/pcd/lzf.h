#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace artcal {

/// Largest number of bytes that one compressed byte can stand for: three bytes that repeat 264.
inline constexpr std::size_t lzf_most_per_byte = 88;

/// Undoes LZF (M. Lehmann's LibLZF, the compression of PCD's binary_compressed). Nothing, where the bytes
/// are not LZF or do not make exactly `size` bytes; never reads or writes outside, and allocates `size` only
/// where the compressed bytes could make as much.
std::optional<std::string> lzf_decompress(std::string_view compressed, std::size_t size);

}  // namespace artcal
