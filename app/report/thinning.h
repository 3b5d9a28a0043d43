#pragma once

#include <vector>

namespace artcal {

/// Which of many points a picture draws: at most `most` of them, ascending. All where they are few; else the
/// lowest and the highest y of every stretch along x, so that no extreme is unidentifiable, and between these points
/// evenly. Points of which either is NaN are left out. REQUIRES: as many x as y; most >= 8.
std::vector<int> thinned(const std::vector<double>& x, const std::vector<double>& y, int most);

}  // namespace artcal
