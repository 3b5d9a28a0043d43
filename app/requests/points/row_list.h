#pragma once

#include <filesystem>

#include "acquisition/point_cloud/point_cloud.h"
#include "core/error.h"

namespace artcal {

/// The points of a cloud whose rows a file lists: one whole number a line, from 0, in any order; blank lines
/// and lines that begin with # are passed over. The list is added to `inputs`.
/// Refused: no number, a row twice, a row that the cloud does not have or that was dropped as not a number.
Expected<PointCloud> take_rows(const PointCloud& cloud, const std::filesystem::path& list,
                               std::vector<InputFile>& inputs);

}  // namespace artcal
