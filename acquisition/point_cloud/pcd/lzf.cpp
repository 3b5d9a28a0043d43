#include "acquisition/point_cloud/pcd/lzf.h"

#include <limits>

#include <lzf.h>

namespace artcal {

std::optional<std::string> lzf_decompress(std::string_view compressed, std::size_t size) {
  constexpr std::size_t most = std::numeric_limits<unsigned int>::max();
  if (size / lzf_most_per_byte > compressed.size() || compressed.size() > most || size > most) {
    return std::nullopt;
  }
  if (size == 0) {
    return compressed.empty() ? std::optional<std::string>("") : std::nullopt;  // LibLZF says 0 for an error, too
  }
  std::string out(size, '\0');
  const unsigned int made = ::lzf_decompress(compressed.data(), static_cast<unsigned int>(compressed.size()),
                                             out.data(), static_cast<unsigned int>(size));
  return made == size ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace artcal
