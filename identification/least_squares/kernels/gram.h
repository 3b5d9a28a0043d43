#pragma once

#include <cstddef>
#include <vector>

namespace artcal {

/// Adds to the upper triangle of `gram` that of AᵀA. A has `rows` rows of `columns` numbers, a multiple of eight, one
/// after the other; `gram` has as many rows of as many numbers. Both begin at multiples of 64 bytes. Some entries below
/// the diagonal are changed too and mean nothing. Each entry sums its products in the order of the rows, so that every
/// variant gives the same bits.
using Gram = void(const double* a, int rows, int columns, double* gram);

/// Makes of the upper triangle of such a `gram` its Cholesky factor R, of the first `size` rows and columns (Golub, Van
/// Loan 2013, Algorithm 4.2.2 by outer products). A row of which is left less than a 1e-14th of its diagonal element
/// becomes zero. Each entry is divided and reduced in the order of the rows, so that every variant gives the same bits.
using GramFactor = void(double* gram, int size, int columns);

/// The same for instruction sets that this machine has; the fastest is the last.
struct GramVariant {
  const char* instructions;
  Gram* add;
};
const std::vector<GramVariant>& gram_variants();
struct GramFactorVariant {
  const char* instructions;
  GramFactor* factor;
};
const std::vector<GramFactorVariant>& gram_factor_variants();

}  // namespace artcal
