#pragma once

#include <vector>

#include "identification/identify.h"

namespace artcal {

/// Compares the prediction errors of all placements left out with their uncertainties. Within a placement errors are
/// correlated, so that each placement counts once: the sum over P placements of the mean of (error/u)² is P/ν times χ²
/// of ν degrees of freedom, where the model is right; ν is P, or less where the error of a certified value, the same in
/// all placements, is much of u (Satterthwaite). Beyond the 99 % quantile (beyond its mean where the residuals show
/// unmodelled effects, `effects_found`) the arm's share of u is enlarged until that sum is its mean, and by Student's
/// factor for so few placements.
/// With a robust `loss` the median over placements stands for the mean: one reading that the loss let go of spoils the
/// lengths of its placement.
CrossValidation cross_validate(const std::vector<LeftOut>& left_out, bool effects_found, Loss loss);

/// What the readings of placements left out are off beyond `noise`, mm a coordinate: the stated one, or else that of
/// the residuals beside the effects that were found in them.
double unmodelled_point_error(const std::vector<LeftOut>& left_out, double noise);

/// With a point error the scale is at least the one with which 95 % intervals hold 95 % of the coordinates of points in
/// the working volume, over random postures, that have that error beside their uncertainty without the noise of their
/// readings.
void add_point_error(double error, const Identification& result, CrossValidation& found);

/// Multiplies the covariance and the standard uncertainties of the parameters and says so in a warning.
void enlarge_for_unmodelled_errors(const CrossValidation& found, Identification& result);

/// All of it, from Identification::left_out: the comparison, the point error where something says that the model is
/// wrong (effects in the residuals, residuals beyond the stated noise, predictions beyond their uncertainty), and what
/// follows.
void judge_by_left_out(Loss loss, Identification& result);

}  // namespace artcal
