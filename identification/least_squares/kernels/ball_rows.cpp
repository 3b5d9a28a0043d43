#include "identification/least_squares/kernels/ball_rows.h"

#include <cmath>

#include "core/kernels/kernel_variants.h"
#include "core/kernels/unaligned.h"

namespace artcal {
namespace {

constexpr int lane_count = 8;
constexpr int columns_of_a_block = 8;

// Eight numbers; the compiler makes as many instructions of an operation as the instruction set needs.
using Lanes = double __attribute__((vector_size(64)));

[[gnu::always_inline]] inline void put_all(const BallReadings& readings, const double* scale, int count,
                                           std::ptrdiff_t stride, double* residuals, double* by_centre,
                                           double* by_arm) {
  const Lanes x = unaligned_at<Lanes>(readings.tips).numbers - readings.centre[0];
  const Lanes y = unaligned_at<Lanes>(readings.tips + lane_count).numbers - readings.centre[1];
  const Lanes z = unaligned_at<Lanes>(readings.tips + 2 * lane_count).numbers - readings.centre[2];
  alignas(64) double lengths[lane_count];
  unaligned_at<Lanes>(lengths).numbers = (x * x + y * y) + z * z;
  bool is_at_centre = false;
  for (double& length : lengths) {
    length = std::sqrt(length);
    is_at_centre = is_at_centre || !(length > 0.0);
  }
  const Lanes length = unaligned_at<Lanes>(lengths).numbers;
  const Lanes weight = unaligned_at<Lanes>(readings.weights).numbers;
  const Lanes value = weight * (length - unaligned_at<Lanes>(readings.lengths).numbers);
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
  unaligned_at<Lanes>(block[0]).numbers = value;
  unaligned_at<Lanes>(block[1]).numbers = -wx;
  unaligned_at<Lanes>(block[2]).numbers = -wy;
  unaligned_at<Lanes>(block[3]).numbers = -wz;
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
      unaligned_at<Lanes>(block[c]).numbers =
          scale[first + c] * (wx * unaligned_at<Lanes>(d).numbers + wy * unaligned_at<Lanes>(d + lane_count).numbers +
                              wz * unaligned_at<Lanes>(d + 2 * lane_count).numbers);
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
