#pragma once

#include <cstddef>
#include <vector>

namespace artcal {

/// Adds to the upper triangle of `gram` that of AᵀA. A has `rows` rows of `columns` numbers, a multiple of eight, one
/// after the other; `gram` has as many rows of as many numbers. Both begin at multiples of 64 bytes. Some entries below
/// the diagonal are changed too and mean nothing. Each entry sums its products in the order of the rows, so that every
/// variant gives the same bits.
using Gram = void(const double* a, int rows, int columns, double* gram);

/// The same for instruction sets that this machine has; the fastest is the last.
struct GramVariant {
  const char* instructions;
  Gram* add;
};
const std::vector<GramVariant>& gram_variants();

}  // namespace artcal
