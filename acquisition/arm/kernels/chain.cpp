#include "acquisition/arm/kernels/chain.h"

#include <algorithm>

#include "core/kernels/kernel_variants.h"
#include "core/kernels/unaligned.h"

namespace artcal {
namespace {

using Two = double __attribute__((vector_size(16)));
using Four = double __attribute__((vector_size(32)));
using Eight = double __attribute__((vector_size(64)));

template <typename V>
struct Vector {
  V x, y, z;
};

template <typename V>
[[gnu::always_inline]] inline Vector<V> cross(const Vector<V>& a, const Vector<V>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <typename V>
[[gnu::always_inline]] inline Vector<V> from(const Vector<V>& a, const Vector<V>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <typename V, typename S>
[[gnu::always_inline]] inline void turn(Vector<V>& first, Vector<V>& second, const S& sine, const S& cosine) {
  const Vector<V> turned{cosine * first.x + sine * second.x, cosine * first.y + sine * second.y,
                         cosine * first.z + sine * second.z};
  second = {cosine * second.x - sine * first.x, cosine * second.y - sine * first.y, cosine * second.z - sine * first.z};
  first = turned;
}

template <typename V>
struct Frame {
  Vector<V> z, z_at, x, x_at, y;
};

template <typename V>
[[gnu::always_inline]] inline void put(double* derivative, int column, const Vector<V>& value) {
  if (column >= 0) {
    double* out = derivative + 3 * postures_at_once * column;
    unaligned_at<V>(out).numbers = value.x;
    unaligned_at<V>(out + postures_at_once).numbers = value.y;
    unaligned_at<V>(out + 2 * postures_at_once).numbers = value.z;
  }
}

// As ForwardKinematics::walk() and tip_in_base(), operation by operation.
template <typename V>
[[gnu::always_inline]] inline void pass_lanes(const Chain& chain, const double* sines, const double* q, double* tips,
                                              double* derivative) {
  const V zero = {};
  const V one = zero + 1.0;
  Vector<V> x{one, zero, zero};
  Vector<V> y{zero, one, zero};
  Vector<V> z{zero, zero, one};
  Vector<V> p{zero, zero, zero};
  Frame<V> frames[max_links];
  for (int i = 0; i < chain.joints; ++i) {
    const ChainLink& link = chain.links[i];
    Frame<V>& frame = frames[i];
    V d = zero + link.d;
    V sin_q = link.sign * unaligned_at<V>(sines + 2 * i * postures_at_once).numbers;
    V cos_q = unaligned_at<V>(sines + (2 * i + 1) * postures_at_once).numbers;
    if (link.is_prismatic) {
      d = d + link.sign * unaligned_at<V>(q + i * postures_at_once).numbers;
      sin_q = zero;
      cos_q = one;
    }
    const V sine = link.sin_theta * cos_q + link.cos_theta * sin_q;
    const V cosine = link.cos_theta * cos_q - link.sin_theta * sin_q;
    if (!chain.is_modified) {
      frame.z = z;
      frame.z_at = p;
      turn(x, y, sine, cosine);
      p = {p.x + (d * z.x + link.a * x.x), p.y + (d * z.y + link.a * x.y), p.z + (d * z.z + link.a * x.z)};
      frame.x = x;
      frame.x_at = p;
      turn(y, z, link.sin_alpha, link.cos_alpha);
      frame.y = y;
      if (link.has_beta) {
        turn(z, x, link.sin_beta, link.cos_beta);
      }
    } else {
      frame.x = x;
      turn(y, z, link.sin_alpha, link.cos_alpha);
      p = {p.x + link.a * x.x, p.y + link.a * x.y, p.z + link.a * x.z};
      frame.x_at = p;
      frame.y = y;
      if (link.has_beta) {
        turn(z, x, link.sin_beta, link.cos_beta);
      }
      frame.z = z;
      frame.z_at = p;
      turn(x, y, sine, cosine);
      p = {p.x + d * z.x, p.y + d * z.y, p.z + d * z.z};
    }
  }
  const double* tip = chain.tip_in_last;
  p = {p.x + (tip[0] * x.x + tip[1] * y.x + tip[2] * z.x), p.y + (tip[0] * x.y + tip[1] * y.y + tip[2] * z.y),
       p.z + (tip[0] * x.z + tip[1] * y.z + tip[2] * z.z)};
  unaligned_at<V>(tips).numbers = p.x;
  unaligned_at<V>(tips + postures_at_once).numbers = p.y;
  unaligned_at<V>(tips + 2 * postures_at_once).numbers = p.z;
  if (derivative == nullptr) {
    return;
  }
  for (int i = 0; i < chain.joints; ++i) {
    const ChainLink& link = chain.links[i];
    const Frame<V>& frame = frames[i];
    put(derivative, link.column_a, frame.x);
    put(derivative, link.column_d, frame.z);
    if (link.column_theta >= 0) {
      put(derivative, link.column_theta, cross(frame.z, from(p, frame.z_at)));
    }
    if (link.column_alpha >= 0) {
      put(derivative, link.column_alpha, cross(frame.x, from(p, frame.x_at)));
    }
    if (link.has_beta && link.column_beta >= 0) {
      put(derivative, link.column_beta, cross(frame.y, from(p, frame.x_at)));
    }
  }
  put(derivative, chain.column_tip[0], x);
  put(derivative, chain.column_tip[1], y);
  put(derivative, chain.column_tip[2], z);
}

template <typename V>
[[gnu::always_inline]] inline void pass_all(const Chain& chain, const double* sines, const double* q, double* tips,
                                            double* derivative) {
  constexpr int lanes = sizeof(V) / sizeof(double);
  if (derivative != nullptr) {
    std::fill_n(derivative, 3 * postures_at_once * chain.columns, 0.0);
  }
  for (int first = 0; first < postures_at_once; first += lanes) {
    pass_lanes<V>(chain, sines + first, q + first, tips + first, derivative == nullptr ? nullptr : derivative + first);
  }
}

void pass_by_any(const Chain& chain, const double* sines, const double* q, double* tips, double* derivative) {
  pass_all<Two>(chain, sines, q, tips, derivative);
}

ARTCAL_FOR_AVX2 void pass_by_avx2(const Chain& chain, const double* sines, const double* q, double* tips,
                                  double* derivative) {
  pass_all<Four>(chain, sines, q, tips, derivative);
}

ARTCAL_FOR_AVX512 void pass_by_avx512(const Chain& chain, const double* sines, const double* q, double* tips,
                                      double* derivative) {
  pass_all<Eight>(chain, sines, q, tips, derivative);
}

}  // namespace

const std::vector<ChainVariant>& chain_variants() {
  static const auto variants = variants_of_this_machine<ChainVariant>(pass_by_any, pass_by_avx2, pass_by_avx512);
  return variants;
}

}  // namespace artcal
