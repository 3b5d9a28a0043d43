#include "identification/loss.h"

#include <cmath>

namespace artcal {
namespace {

constexpr double huber = 1.345;
constexpr double cauchy = 2.385;

}  // namespace

LossValue loss_at(Loss loss, double s) {
  switch (loss) {
    case Loss::Huber:
      return s <= huber * huber ? LossValue{s, 1.0}
                                : LossValue{2.0 * huber * std::sqrt(s) - huber * huber, huber / std::sqrt(s)};
    case Loss::Cauchy:
      return {cauchy * cauchy * std::log1p(s / (cauchy * cauchy)), 1.0 / (1.0 + s / (cauchy * cauchy))};
    case Loss::None: break;
  }
  return {s, 1.0};
}

}  // namespace artcal
