#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace artcal {

/// Told what a long identification is doing, and how much of it is done where that is known (else 0 of 0). Called by
/// one thread at a time.
using IdentifyProgressCallback = std::function<void(const std::string& what, std::size_t done, std::size_t total)>;

}  // namespace artcal
