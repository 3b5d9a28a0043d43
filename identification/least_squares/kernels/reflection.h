#pragma once

#include <cstddef>
#include <vector>

namespace artcal {

/// Two rows of four neighbouring columns of a matrix: column by column, each with its upper row first.
struct alignas(64) RowPairs {
  double values[8];
};

/// A Householder reflection of `groups` groups of four columns, each column under an element of a triangle's row:
///     s = twice·(row + vᵀ·column),  row −= s,  column −= s·v.
/// `v` are pairs of rows of the reflector, each pair four times; `row` are 4·groups numbers; the pairs of the g-th
/// group begin at columns + g·stride. A column's sum is that of its upper rows plus that of its lower ones, each in
/// their order, so that every variant gives the same bits.
using Reflection = void(const RowPairs* v, int pairs, double twice, double* row, RowPairs* columns,
                        std::ptrdiff_t stride, int groups);

/// The same for instruction sets that this machine has; the fastest is the last.
struct ReflectionVariant {
  const char* instructions;
  Reflection* reflect;
};
const std::vector<ReflectionVariant>& reflection_variants();

}  // namespace artcal
