#pragma once

#include <cstdint>

namespace artcal::testing {

/// Basic blocks that the counted sources (tests/work/CMakeLists.txt) have run so far, on all threads.
std::uint64_t step_count();

}  // namespace artcal::testing
