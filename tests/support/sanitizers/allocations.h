#pragma once

#include <atomic>
#include <cstddef>
#include <cstdlib>

#include "tests/support/sanitizers/sanitized.h"

/// Counts calls of malloc, those of operator new and of Eigen included, in the one test program whose
/// one source file includes this. Sanitizers bring their own malloc; there `counts_allocations` is false.
#if defined(ARTCAL_IS_SANITIZED) || !defined(__GLIBC__)
#define ARTCAL_COUNTS_ALLOCATIONS false
#else
#define ARTCAL_COUNTS_ALLOCATIONS true
#endif

namespace artcal::testing {

inline std::atomic<long> allocation_count{0};
inline constexpr bool counts_allocations = ARTCAL_COUNTS_ALLOCATIONS;

}  // namespace artcal::testing

#if ARTCAL_COUNTS_ALLOCATIONS
extern "C" void* __libc_malloc(std::size_t size);  // NOLINT(bugprone-reserved-identifier): glibc's own name
extern "C" void* malloc(std::size_t size) {
  artcal::testing::allocation_count.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}
#endif
