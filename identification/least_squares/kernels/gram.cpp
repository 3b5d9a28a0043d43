#include "identification/least_squares/kernels/gram.h"

#include <algorithm>
#include <cmath>

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

[[gnu::always_inline]] inline bool is_zero(const double* four) {
  return four[0] == 0.0 && four[1] == 0.0 && four[2] == 0.0 && four[3] == 0.0;
}

// Rows before the first and after the last in which four columns are not all zero (other features' readings) add
// nothing to these columns' rows of the result.
template <int width>
[[gnu::always_inline]] inline void add_all(const double* a, int rows, int columns, double* gram) {
  for (int i = 0; i < columns; i += 4) {
    const double* first = a;
    int count = rows;
    while (count > 0 && is_zero(first + i)) {
      first += columns;
      --count;
    }
    while (count > 0 && is_zero(first + static_cast<std::ptrdiff_t>(count - 1) * columns + i)) {
      --count;
    }
    int j = i / 8 * 8;
    for (; j + 8 * width <= columns; j += 8 * width) {
      add_tile<width>(first, count, columns, i, j, gram);
    }
    for (; j < columns; j += 8) {
      add_tile<1>(first, count, columns, i, j, gram);
    }
  }
}

// Eight columns at once; those before a row's own mean nothing.
[[gnu::always_inline]] inline void factor_rows(double* gram, int size, int columns) {
  constexpr double still_dependent = 1e-14;  // of a column's own square
  const auto row_of = [&](int i) { return gram + static_cast<std::ptrdiff_t>(i) * columns; };
  std::vector<double> squares(static_cast<std::size_t>(size));
  for (int k = 0; k < size; ++k) {
    squares[static_cast<std::size_t>(k)] = row_of(k)[k];
  }
  for (int k = 0; k < size; ++k) {
    double* row = row_of(k);
    if (!(row[k] > still_dependent * squares[static_cast<std::size_t>(k)])) {
      std::fill_n(row, columns, 0.0);
      continue;
    }
    const double root = std::sqrt(row[k]);
    for (int j = k / 8 * 8; j < columns; j += 8) {
      *reinterpret_cast<Sums*>(row + j) /= root;
    }
    for (int i = k + 1; i < size; ++i) {
      double* other = row_of(i);
      const double by = row[i];
      for (int j = i / 8 * 8; j < columns; j += 8) {
        *reinterpret_cast<Sums*>(other + j) -= by * *reinterpret_cast<const Sums*>(row + j);
      }
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

void factor_by_any(double* gram, int size, int columns) { factor_rows(gram, size, columns); }

ARTCAL_FOR_AVX2 void factor_by_avx2(double* gram, int size, int columns) { factor_rows(gram, size, columns); }

ARTCAL_FOR_AVX512 void factor_by_avx512(double* gram, int size, int columns) { factor_rows(gram, size, columns); }

}  // namespace

const std::vector<GramVariant>& gram_variants() {
  static const auto variants = variants_of_this_machine<GramVariant>(add_by_any, add_by_avx2, add_by_avx512);
  return variants;
}

const std::vector<GramFactorVariant>& gram_factor_variants() {
  static const auto variants =
      variants_of_this_machine<GramFactorVariant>(factor_by_any, factor_by_avx2, factor_by_avx512);
  return variants;
}

}  // namespace artcal
