#pragma once

#include <algorithm>
#include <string>

#include "core/random.h"

namespace artcal::testing {

inline std::size_t below(RandomStream& random, std::size_t limit) { return limit == 0 ? 0 : random.bits() % limit; }

/// One to four damages: a flipped bit, another byte, a cut, a piece doubled, a piece lost, two lines exchanged
/// for one, a number made extreme.
inline std::string damaged(std::string text, RandomStream& random) {
  for (std::size_t n = 1 + below(random, 4); n > 0; --n) {
    const std::size_t at = below(random, text.size());
    const std::size_t length = 1 + below(random, std::min<std::size_t>(200, text.size() - at + 1));
    switch (below(random, 7)) {
      case 0: text[at] = static_cast<char>(text[at] ^ (1 << below(random, 8))); break;
      case 1: text[at] = static_cast<char>(random.bits()); break;
      case 2: text.resize(std::max<std::size_t>(at, 1)); break;
      case 3: text.insert(at, text.substr(at, length)); break;
      case 4: text.erase(at, std::min(length, text.size() - 1)); break;
      case 5: text.insert(at, text.substr(below(random, text.size()), length)); break;
      default: {
        const auto digit = text.find_first_of("0123456789", at);
        const char* const extreme[]{"1e308", "-1e308", "1e-320", "99999999999999999999", "0", "-0.0", "1e155"};
        if (digit != std::string::npos) {
          text.replace(digit, text.find_first_not_of("0123456789.", digit) - digit, extreme[below(random, 7)]);
        }
      }
    }
  }
  return text;
}

}  // namespace artcal::testing
