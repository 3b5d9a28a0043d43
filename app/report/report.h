#pragma once

#include <string>
#include <vector>

#include "app/report/page.h"
#include "app/report/result_file.h"
#include "core/error.h"

namespace artcal {

/// One page that shows results of one arm: what came out first, then each result, then how the arm changed
/// where there are several of a kind, then all files behind them. Opens without a network, prints on A4.
/// `plots`: Plots or SharedPlots.
/// Refused: results of different arms, results that are not as docs/result-schema.md says.
Expected<std::string> report_html(const std::vector<ReportedResult>& results, Scripts plots = Scripts::Plots);

}  // namespace artcal
