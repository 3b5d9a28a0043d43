#pragma once

#include <optional>

#include "fitting/fit.h"

namespace artcal::fitting {

/// The everyday sphere: least squares, no weights, radius free or known, well spread points. The same answer as the
/// general fit, to rounding, in a few microseconds for 25 points and a few reads of the data for a
/// million. None whenever something is not as plain as that: the general fit then finds what it is.
std::optional<Fitted<Sphere>> fit_plain_sphere(const Points& points, const FitOptions& options);

}  // namespace artcal::fitting
