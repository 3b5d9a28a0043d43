#pragma once

namespace artcal {

/// How a reading far off counts. Thresholds (1.345 and 2.385 standard deviations) are those of 95 %
/// efficiency on normal noise (Holland, Welsch 1977).
enum class Loss { None, Huber, Cauchy };

/// ρ(s) of a loss and its derivative at s, the squared residual in units of its variance. Both robust
/// losses are concave in s, which the solver relies on.
struct LossValue {
  double value = 0.0;
  double slope = 1.0;
};
LossValue loss_at(Loss loss, double s);

/// The same for an observation of several whitened residuals whose squares sum to `squares` and would in a good fit to
/// `expected`, which is their number less what the fit adapts to them: expected·ρ(squares/expected), and its derivative
/// by `squares`. Where nothing is expected nothing can be far off, and the loss is that of least squares.
LossValue loss_of(Loss loss, double squares, double expected);

/// Moments of a loss under normal noise, s being χ² with some degrees of freedom divided by them (s of one residual, or
/// of a reading's three together). ψ is the derivative of ρ/2 by a residual; by Stein's lemma E[ψ'] = E[ρ'·s].
struct LossMoments {
  double square = 1.0;    ///< E[ψ²] = E[ρ'²·s]; 1 for least squares
  double variance = 0.0;  ///< of ψ²
  double information = 1.0;  ///< E[ψ']²/(E[ψ²]·E[ρ']): by which weights ρ' give the covariance (Xᵀ·ρ'·X)⁻¹ of an
                             ///< M-estimate (Huber 1981, Eq. 7.6.7: E[ψ²]/E[ψ']²·(XᵀX)⁻¹)
};
LossMoments moments_of(Loss loss, double degrees_of_freedom);

}  // namespace artcal
