#include "identification/least_squares/kernels/gram.h"

#include "core/kernels/kernel_variants.h"

namespace artcal {
namespace {

// Eight numbers; the compiler makes as many instructions of an operation as the instruction set needs.
using Sums = double __attribute__((vector_size(64), may_alias));

// Entries of four rows of the result in `width` times eight columns stay in registers.
template <int width>
[[gnu::always_inline]] inline void add_tile(const double* a, int rows, int columns, int i, int j, double* gram) {
  Sums sums[4][width];
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) {
#pragma GCC unroll 4
    for (int w = 0; w < width; ++w) {
      sums[k][w] = *reinterpret_cast<const Sums*>(gram + (i + k) * columns + j + 8 * w);
    }
  }
  for (int r = 0; r < rows; ++r) {
    const double* row = a + static_cast<std::ptrdiff_t>(r) * columns;
    Sums right[width];
#pragma GCC unroll 4
    for (int w = 0; w < width; ++w) {
      right[w] = *reinterpret_cast<const Sums*>(row + j + 8 * w);
    }
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) {
      const double left = row[i + k];
#pragma GCC unroll 4
      for (int w = 0; w < width; ++w) {
        sums[k][w] += left * right[w];
      }
    }
  }
#pragma GCC unroll 4
  for (int k = 0; k < 4; ++k) {
#pragma GCC unroll 4
    for (int w = 0; w < width; ++w) {
      *reinterpret_cast<Sums*>(gram + (i + k) * columns + j + 8 * w) = sums[k][w];
    }
  }
}

template <int width>
[[gnu::always_inline]] inline void add_all(const double* a, int rows, int columns, double* gram) {
  for (int i = 0; i < columns; i += 4) {
    int j = i / 8 * 8;
    for (; j + 8 * width <= columns; j += 8 * width) {
      add_tile<width>(a, rows, columns, i, j, gram);
    }
    for (; j < columns; j += 8) {
      add_tile<1>(a, rows, columns, i, j, gram);
    }
  }
}

void add_by_any(const double* a, int rows, int columns, double* gram) { add_all<1>(a, rows, columns, gram); }

ARTCAL_FOR_AVX2 void add_by_avx2(const double* a, int rows, int columns, double* gram) {
  add_all<1>(a, rows, columns, gram);
}

ARTCAL_FOR_AVX512 void add_by_avx512(const double* a, int rows, int columns, double* gram) {
  add_all<3>(a, rows, columns, gram);
}

}  // namespace

const std::vector<GramVariant>& gram_variants() {
  static const auto variants = variants_of_this_machine<GramVariant>(add_by_any, add_by_avx2, add_by_avx512);
  return variants;
}

}  // namespace artcal
