#pragma once

namespace artcal {

/// A vector of numbers at a place that is aligned as one number is: what memory is read and written by. Nothing may
/// refer to `numbers` itself, which its type would have aligned as a whole vector.
template <typename Vector>
struct __attribute__((packed, may_alias)) Unaligned {
  Vector numbers;
};

template <typename Vector>
[[gnu::always_inline]] inline const Unaligned<Vector>& unaligned_at(const double* place) {
  return *reinterpret_cast<const Unaligned<Vector>*>(place);
}

template <typename Vector>
[[gnu::always_inline]] inline Unaligned<Vector>& unaligned_at(double* place) {
  return *reinterpret_cast<Unaligned<Vector>*>(place);
}

}  // namespace artcal
