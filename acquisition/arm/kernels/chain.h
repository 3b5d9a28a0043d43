#pragma once

#include <vector>

namespace artcal {

/// What a pass along the chain needs to know of one joint: Denavit and Hartenberg's numbers, mm and rad, sines and
/// cosines of the angles, and the column of each parameter in the derivative, or -1.
struct ChainLink {
  double a, d, sign;
  double sin_theta, cos_theta;  // of the zero offset
  double sin_alpha, cos_alpha;
  double sin_beta, cos_beta;
  bool has_beta, is_prismatic;
  int column_a, column_d, column_theta, column_alpha, column_beta;
};

/// A rigid arm.
struct Chain {
  bool is_modified;  ///< the convention
  int joints;
  const ChainLink* links;
  double tip_in_last[3];
  int column_tip[3];
  int columns;
};

constexpr int postures_at_once = 8;
constexpr int max_links = 24;

/// ForwardKinematics::tip_in_base() of eight postures at once, the numbers of each in a lane: `sines` are
/// [2·joints][8], `q` [joints][8] (looked at where a joint is prismatic), `tips` become [3][8] and `derivative`, which
/// may be null, [columns][3][8]. Each lane has the operations of one posture alone in their order, so that every
/// variant gives the same bits.
using ChainPass = void(const Chain& chain, const double* sines, const double* q, double* tips, double* derivative);

/// The same for instruction sets that this machine has; the fastest is the last.
struct ChainVariant {
  const char* instructions;
  ChainPass* pass;
};
const std::vector<ChainVariant>& chain_variants();

}  // namespace artcal
