#pragma once

#include <vector>

// A function compiled for a set of vector instructions; for any processor where there are none of that name.
#if defined(__x86_64__)
#define ARTCAL_FOR_AVX2 [[gnu::target("avx2")]]
#define ARTCAL_FOR_AVX512 [[gnu::target("avx512f")]]
#else
#define ARTCAL_FOR_AVX2
#define ARTCAL_FOR_AVX512
#endif

namespace artcal {

/// Those of a function's variants that this machine can run, the fastest last. Debian's libraries are compiled for any
/// x86-64, so that the choice is made at run time. `Variant` holds the name of the instructions and the function.
template <typename Variant, typename Function>
std::vector<Variant> variants_of_this_machine(Function* any, [[maybe_unused]] Function* avx2,
                                              [[maybe_unused]] Function* avx512) {
  std::vector<Variant> variants{{"any", any}};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) {
    variants.push_back({"avx2", avx2});
  }
  if (__builtin_cpu_supports("avx512f")) {
    variants.push_back({"avx512f", avx512});
  }
#endif
  return variants;
}

}  // namespace artcal
