#pragma once

#include <atomic>
#include <cstddef>
#include <cstdlib>

/// Counts calls of malloc, those of operator new and of Eigen included, in the one test program whose
/// one source file includes this. Sanitizers bring their own malloc; there `counts_allocations` is false.
namespace artcal::testing {

inline std::atomic<long> allocation_count{0};

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
inline constexpr bool counts_allocations = false;
#else
inline constexpr bool counts_allocations = true;
#endif

}  // namespace artcal::testing

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && defined(__GLIBC__)
extern "C" void* __libc_malloc(std::size_t size);  // NOLINT(bugprone-reserved-identifier): glibc's own name
extern "C" void* malloc(std::size_t size) {
  artcal::testing::allocation_count.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}
#endif
