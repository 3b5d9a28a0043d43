#pragma once

#include "app/report/sheet.h"
#include "app/results/recorded/recorded_head.h"
#include "app/results/uncertainty/recorded_monte_carlo.h"

namespace artcal {

/// Whether there were trials enough, and whether first-order uncertainties agree with them.
void write_monte_carlo_verdict(const RecordedMonteCarlo& result, Sheet& sheet);

/// Uncertainties of parameters and of what the arm measures, by Monte Carlo and to first order.
void write_monte_carlo(const RecordedHead& head, const RecordedMonteCarlo& result, Sheet& sheet);

}  // namespace artcal
