#include "identification/least_squares/kernels/ball_rows.h"

#include <cmath>

#include "core/kernels/kernel_variants.h"

namespace artcal {
namespace {

constexpr int lane_count = 8;
constexpr int columns_of_a_block = 8;

// Eight numbers; the compiler makes as many instructions of an operation as the instruction set needs.
using Lanes = double __attribute__((vector_size(64), may_alias, aligned(8)));

[[gnu::always_inline]] inline const Lanes& lanes_at(const double* from) {
  return *reinterpret_cast<const Lanes*>(from);
}
[[gnu::always_inline]] inline void put_lanes(const Lanes& numbers, double* to) {
  *reinterpret_cast<Lanes*>(to) = numbers;
}

[[gnu::always_inline]] inline void put_all(const BallReadings& readings, const double* scale, int count,
                                           std::ptrdiff_t stride, double* residuals, double* by_centre,
                                           double* by_arm) {
  const Lanes x = lanes_at(readings.tips) - readings.centre[0];
  const Lanes y = lanes_at(readings.tips + lane_count) - readings.centre[1];
  const Lanes z = lanes_at(readings.tips + 2 * lane_count) - readings.centre[2];
  alignas(64) double lengths[lane_count];
  put_lanes((x * x + y * y) + z * z, lengths);
  bool is_at_centre = false;
  for (double& length : lengths) {
    length = std::sqrt(length);
    is_at_centre = is_at_centre || !(length > 0.0);
  }
  const Lanes length = lanes_at(lengths);
  const Lanes weight = lanes_at(readings.weights);
  const Lanes value = weight * (length - lanes_at(readings.lengths));
  // At the centre itself the direction is undefined; any one will do to leave it.
  Lanes along_x = x / length;
  Lanes along_y = y / length;
  Lanes along_z = z / length;
  for (int i = 0; is_at_centre && i < lane_count; ++i) {
    if (!(lengths[i] > 0.0)) {
      along_x[i] = 0.0;
      along_y[i] = 0.0;
      along_z[i] = 1.0;
    }
  }
  const Lanes wx = weight * along_x;
  const Lanes wy = weight * along_y;
  const Lanes wz = weight * along_z;
  alignas(64) double block[columns_of_a_block][lane_count];
  put_lanes(value, block[0]);
  put_lanes(-wx, block[1]);
  put_lanes(-wy, block[2]);
  put_lanes(-wz, block[3]);
  for (int i = 0; i < count; ++i) {
    residuals[i * stride] = block[0][i];
    for (int k = 0; by_centre != nullptr && k < 3; ++k) {
      by_centre[i * stride + k] = block[k + 1][i];
    }
  }
  if (by_arm == nullptr) {
    return;
  }
  for (int first = 0; first < readings.columns; first += columns_of_a_block) {
    const int end = readings.columns - first < columns_of_a_block ? readings.columns - first : columns_of_a_block;
    for (int c = 0; c < end; ++c) {
      const double* d = readings.derivative + 3 * lane_count * (first + c);
      put_lanes(
          scale[first + c] * (wx * lanes_at(d) + wy * lanes_at(d + lane_count) + wz * lanes_at(d + 2 * lane_count)),
          block[c]);
    }
    for (int i = 0; i < count; ++i) {
      double* out = by_arm + i * stride + first;
      for (int c = 0; c < end; ++c) {
        out[c] = block[c][i];
      }
    }
  }
}

void put_by_any(const BallReadings& readings, const double* scale, int count, std::ptrdiff_t stride, double* residuals,
                double* by_centre, double* by_arm) {
  put_all(readings, scale, count, stride, residuals, by_centre, by_arm);
}

ARTCAL_FOR_AVX2 void put_by_avx2(const BallReadings& readings, const double* scale, int count, std::ptrdiff_t stride,
                                 double* residuals, double* by_centre, double* by_arm) {
  put_all(readings, scale, count, stride, residuals, by_centre, by_arm);
}

ARTCAL_FOR_AVX512 void put_by_avx512(const BallReadings& readings, const double* scale, int count,
                                     std::ptrdiff_t stride, double* residuals, double* by_centre, double* by_arm) {
  put_all(readings, scale, count, stride, residuals, by_centre, by_arm);
}

}  // namespace

const std::vector<BallRowsVariant>& ball_rows_variants() {
  static const auto variants = variants_of_this_machine<BallRowsVariant>(put_by_any, put_by_avx2, put_by_avx512);
  return variants;
}

}  // namespace artcal
