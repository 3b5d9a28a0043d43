#include "tests/work/step_count.h"

#include <atomic>

namespace {

std::atomic<std::uint64_t> steps{0};

}  // namespace

// The compiler calls it at every basic block of what is compiled with -fsanitize-coverage=trace-pc.
extern "C" void __sanitizer_cov_trace_pc() {  // NOLINT(bugprone-reserved-identifier): the compiler's own name
  steps.fetch_add(1, std::memory_order_relaxed);
}

std::uint64_t artcal::testing::step_count() { return steps.load(std::memory_order_relaxed); }
