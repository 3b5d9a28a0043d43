#include "fitting/least_squares/sphere_kernel.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

// The loader picks the version for the machine. No fused multiply-add anywhere (the build turns it off),
// so the versions differ in speed and not in digits. Sanitizers run before the loader can choose.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define ARTCAL_FOR_EACH_MACHINE __attribute__((target_clones("arch=x86-64-v4", "avx2", "default")))
#else
#define ARTCAL_FOR_EACH_MACHINE
#endif

#define ARTCAL_LAMBDA __attribute__((always_inline))
#define ARTCAL_INLINE [[gnu::always_inline]] inline

namespace artcal::fitting {
namespace {

constexpr std::size_t lanes = 8;

// Differences to the centre.
ARTCAL_INLINE void offset(const SphereView& v, std::size_t i, double& x, double& y, double& z) {
  const double* p = v.xyz + 3 * i;
  x = (p[0] - v.origin[0]) - v.centre[0];
  y = (p[1] - v.origin[1]) - v.centre[1];
  z = (p[2] - v.origin[2]) - v.centre[2];
}

// Eight doubles, copied from and to wherever they are stored; compilers know such vectors on every machine and split
// them up where its registers are shorter.
using Eight = double __attribute__((vector_size(lanes * sizeof(double))));

// The same for eight points, which are stored as three vectors of mixed coordinates. Left to themselves
// compilers take these apart one number at a time, and that is then what the pass waits for.
ARTCAL_INLINE void offsets(const SphereView& v, std::size_t i, double (&x)[lanes], double (&y)[lanes],
                           double (&z)[lanes]) {
  Eight a, b, c;
  std::memcpy(&a, v.xyz + 3 * i, sizeof a);
  std::memcpy(&b, v.xyz + 3 * i + lanes, sizeof b);
  std::memcpy(&c, v.xyz + 3 * i + 2 * lanes, sizeof c);
  const Eight xs = __builtin_shufflevector(a, b, 0, 3, 6, 9, 12, 15, 0, 0);
  const Eight ys = __builtin_shufflevector(a, b, 1, 4, 7, 10, 13, 0, 0, 0);
  const Eight zs = __builtin_shufflevector(a, b, 2, 5, 8, 11, 14, 0, 0, 0);
  const Eight dx = (__builtin_shufflevector(xs, c, 0, 1, 2, 3, 4, 5, 10, 13) - v.origin[0]) - v.centre[0];
  const Eight dy = (__builtin_shufflevector(ys, c, 0, 1, 2, 3, 4, 8, 11, 14) - v.origin[1]) - v.centre[1];
  const Eight dz = (__builtin_shufflevector(zs, c, 0, 1, 2, 3, 4, 9, 12, 15) - v.origin[2]) - v.centre[2];
  std::memcpy(x, &dx, sizeof dx);
  std::memcpy(y, &dy, sizeof dy);
  std::memcpy(z, &dz, sizeof dz);
}

// `Count` sums in eight lanes each. Whole groups of eight have a constant trip count, which compilers turn
// into vectors, and their sums stay in registers only if nothing else touches them: the rest, fewer than
// eight points, has its own. `term(x, y, z, k)` gives the sums' terms for one point.
template <std::size_t Count, typename Term>
ARTCAL_INLINE void sum_over(const SphereView& v, double (&sums)[Count], Term term) {
  double lane[Count][lanes] = {};
  std::size_t i = 0;
  for (; i + lanes <= v.count; i += lanes) {
    double x[lanes], y[lanes], z[lanes];
    offsets(v, i, x, y, z);
    for (std::size_t j = 0; j < lanes; ++j) {
      double terms[Count];
      term(i + j, x[j], y[j], z[j], terms);
      for (std::size_t k = 0; k < Count; ++k) {
        lane[k][j] += terms[k];
      }
    }
  }
  for (std::size_t k = 0; k < Count; ++k) {
    const auto& l = lane[k];
    sums[k] = ((l[0] + l[1]) + (l[2] + l[3])) + ((l[4] + l[5]) + (l[6] + l[7]));
  }
  for (; i < v.count; ++i) {
    double x, y, z;
    offset(v, i, x, y, z);
    double terms[Count];
    term(i, x, y, z, terms);
    for (std::size_t k = 0; k < Count; ++k) {
      sums[k] += terms[k];
    }
  }
}

ARTCAL_INLINE void distances(const SphereView& v, std::size_t from, std::size_t to, double* __restrict out) {
  std::size_t i = from;
  for (; i + lanes <= to; i += lanes) {
    double x[lanes], y[lanes], z[lanes];
    offsets(v, i, x, y, z);
    for (std::size_t j = 0; j < lanes; ++j) {
      out[i + j] = std::sqrt(x[j] * x[j] + y[j] * y[j] + z[j] * z[j]) - v.radius;
    }
  }
  for (; i < to; ++i) {
    double x, y, z;
    offset(v, i, x, y, z);
    out[i] = std::sqrt(x * x + y * y + z * z) - v.radius;
  }
}

// Range and sum of squares of whole groups; the caller sees to the rest.
ARTCAL_INLINE SphereResiduals summarise(const double* values, std::size_t count) {
  double low[lanes], high[lanes], squares[lanes] = {};
  for (std::size_t j = 0; j < lanes; ++j) {
    low[j] = high[j] = values[0];
  }
  for (std::size_t i = 0; i + lanes <= count; i += lanes) {
    for (std::size_t j = 0; j < lanes; ++j) {
      const double d = values[i + j];
      low[j] = std::min(low[j], d);
      high[j] = std::max(high[j], d);
      squares[j] += d * d;
    }
  }
  SphereResiduals all{values[0], values[0], 0.0};
  for (std::size_t j = 0; j < lanes; ++j) {
    all = {std::min(all.low, low[j]), std::max(all.high, high[j]), all.dd + squares[j]};
  }
  for (std::size_t i = count - count % lanes; i < count; ++i) {
    const double d = values[i];
    all = {std::min(all.low, d), std::max(all.high, d), all.dd + d * d};
  }
  return all;
}

}  // namespace

ARTCAL_FOR_EACH_MACHINE SphereSums sphere_sums(const SphereView& view) {
  double s[15];
  const double radius = view.radius;
  sum_over(view, s, [radius](std::size_t, double x, double y, double z, double(&t)[15]) ARTCAL_LAMBDA {
    const double rho = std::sqrt(x * x + y * y + z * z);
    const double d = rho - radius;
    const double f = 1.0 / rho;
    const double u = x * f, v = y * f, w = z * f;
    const double fu = f * u, fv = f * v;
    t[0] = d * u, t[1] = d * v, t[2] = d * w, t[3] = d, t[4] = d * d;
    t[5] = u, t[6] = v, t[7] = w;
    t[8] = fu * u, t[9] = fu * v, t[10] = fu * w, t[11] = fv * v, t[12] = fv * w, t[13] = f * w * w;
    t[14] = f;
  });
  return {{{s[0], s[1], s[2]}, s[3], s[4]}, {s[5], s[6], s[7]}, {s[8], s[9], s[10], s[11], s[12], s[13]}, s[14]};
}

ARTCAL_FOR_EACH_MACHINE SphereGradient sphere_gradient(const SphereView& view) {
  double s[5];
  const double radius = view.radius;
  sum_over(view, s, [radius](std::size_t, double x, double y, double z, double(&t)[5]) ARTCAL_LAMBDA {
    const double rho = std::sqrt(x * x + y * y + z * z);
    const double d = rho - radius;
    const double g = d / rho;
    t[0] = g * x, t[1] = g * y, t[2] = g * z, t[3] = d, t[4] = d * d;
  });
  return {{s[0], s[1], s[2]}, s[3], s[4]};
}

ARTCAL_FOR_EACH_MACHINE SphereResiduals sphere_residuals(const SphereView& view, double* out) {
  constexpr std::size_t block = 1024;  // read again while it is in the nearest cache
  SphereResiduals all{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0.0};
  for (std::size_t i = 0; i < view.count; i += block) {
    const std::size_t end = std::min(i + block, view.count);
    distances(view, i, end, out);
    const SphereResiduals part = summarise(out + i, end - i);
    all = {std::min(all.low, part.low), std::max(all.high, part.high), all.dd + part.dd};
  }
  return all;
}

}  // namespace artcal::fitting
