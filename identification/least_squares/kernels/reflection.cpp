#include "identification/least_squares/kernels/reflection.h"

#include "core/kernels/kernel_variants.h"
#include "core/kernels/unaligned.h"

namespace artcal {
namespace {

// Eight numbers; the compiler makes as many instructions of an operation as the instruction set needs.
using Eight = double __attribute__((vector_size(64), may_alias));
using Four = double __attribute__((vector_size(32)));

// `width` groups at once: their sums do not wait for one another.
template <int width>
[[gnu::always_inline]] inline void reflect_together(const Eight* v, int pairs, double twice, double* row,
                                                    Eight* columns, std::ptrdiff_t stride) {
  Eight sums[width] = {};
  for (int p = 0; p < pairs; ++p) {
#pragma GCC unroll 8
    for (int g = 0; g < width; ++g) {
      sums[g] += v[p] * columns[g * stride + p];
    }
  }
  Eight along[width];
#pragma GCC unroll 8
  for (int g = 0; g < width; ++g) {
    auto& own = unaligned_at<Four>(row + 4 * g);
    const Four upper = __builtin_shufflevector(sums[g], sums[g], 0, 2, 4, 6);
    const Four lower = __builtin_shufflevector(sums[g], sums[g], 1, 3, 5, 7);
    const Four by = twice * (upper + lower + own.numbers);
    own.numbers -= by;
    along[g] = __builtin_shufflevector(by, by, 0, 0, 1, 1, 2, 2, 3, 3);
  }
  for (int p = 0; p < pairs; ++p) {
#pragma GCC unroll 8
    for (int g = 0; g < width; ++g) {
      columns[g * stride + p] -= along[g] * v[p];
    }
  }
}

template <int width>
[[gnu::always_inline]] inline void reflect_groups(const RowPairs* reflector, int pairs, double twice, double* row,
                                                  RowPairs* all, std::ptrdiff_t stride, int groups) {
  const auto* v = reinterpret_cast<const Eight*>(reflector);
  auto* columns = reinterpret_cast<Eight*>(all);
  int g = 0;
  for (; g + width <= groups; g += width) {
    reflect_together<width>(v, pairs, twice, row + 4 * g, columns + g * stride, stride);
  }
  for (; g < groups; ++g) {
    reflect_together<1>(v, pairs, twice, row + 4 * g, columns + g * stride, stride);
  }
}

// As many groups at once as leave their sums in registers.
void reflect_by_any(const RowPairs* v, int pairs, double twice, double* row, RowPairs* columns, std::ptrdiff_t stride,
                    int groups) {
  reflect_groups<1>(v, pairs, twice, row, columns, stride, groups);
}

ARTCAL_FOR_AVX2 void reflect_by_avx2(const RowPairs* v, int pairs, double twice, double* row, RowPairs* columns,
                                     std::ptrdiff_t stride, int groups) {
  reflect_groups<2>(v, pairs, twice, row, columns, stride, groups);
}

ARTCAL_FOR_AVX512 void reflect_by_avx512(const RowPairs* v, int pairs, double twice, double* row, RowPairs* columns,
                                         std::ptrdiff_t stride, int groups) {
  reflect_groups<4>(v, pairs, twice, row, columns, stride, groups);
}

}  // namespace

const std::vector<ReflectionVariant>& reflection_variants() {
  static const auto variants =
      variants_of_this_machine<ReflectionVariant>(reflect_by_any, reflect_by_avx2, reflect_by_avx512);
  return variants;
}

}  // namespace artcal
